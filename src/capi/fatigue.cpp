#include "model/fatigue.hpp"

#include <algorithm>
#include <cstddef>

#include "capi/described_tip.hpp"
#include "capi/given_struct.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

constexpr bempd_fatigue fatigue_defaults{.struct_size = sizeof(bempd_fatigue),
                                         .first_cycle = 0,
                                         .most_cycles = 0,
                                         .most_length = 0,
                                         .most_steps = 1000,
                                         .tolerance = 1e-3,
                                         .largest_step = 0.25};

void require_blocks(std::int64_t count, const double* high, const double* low, const double* cycles) {
  require_count(count, "block_count", "block");
  require(high != nullptr && low != nullptr, high ? "low" : "high", " is NULL; give a load factor for each block");
  require(cycles != nullptr || count == 1, "cycles is NULL; only one block, of constant amplitude, may go without");
}

double cycles_of(std::int64_t block, const double* cycles) {
  const double number = cycles ? cycles[block] : 1;
  require(std::isfinite(number) && number > 0, "block ", block + 1, " has ", number,
          " cycles; it must have more than 0");
  return number;
}

std::vector<model::LoadBlock> blocks_of(std::int64_t count, const double* high, const double* low,
                                        const double* cycles) {
  require_blocks(count, high, low, cycles);
  std::vector<model::LoadBlock> blocks;
  for (std::int64_t b = 0; b < count; ++b) {
    require(std::isfinite(high[b]) && std::isfinite(low[b]), "block ", b + 1, " goes from ", low[b], " to ", high[b],
            "; load factors must be finite numbers");
    require(high[b] >= low[b], "the high load factor of block ", b + 1, " is ", high[b], ", below the low one, ",
            low[b], "; it must be higher: R = low / high lies below 1");
    blocks.push_back({{high[b]}, {low[b]}, cycles_of(b, cycles)});
  }
  return blocks;
}

std::vector<model::LoadBlock> blocks_of_cases(std::int64_t count, std::int64_t cases, const double* high,
                                              const double* low, const double* cycles) {
  require_blocks(count, high, low, cycles);
  require(cases >= 1 && cases < (std::int64_t{1} << 31), "case_count is ", cases,
          "; give a factor for each load case, at least 1");
  std::vector<model::LoadBlock> blocks;
  for (std::int64_t b = 0; b < count; ++b) {
    const auto combination = [&](const double* of, const char* name) {
      const std::vector<double> factors(of + b * cases, of + (b + 1) * cases);
      for (std::int64_t c = 0; c < cases; ++c)
        require(std::isfinite(factors[static_cast<std::size_t>(c)]), "the ", name, " factor of load case ", c + 1,
                " in block ", b + 1, " is ", factors[static_cast<std::size_t>(c)], "; it must be a finite number");
      return model::LoadLevel{0, factors};
    };
    blocks.push_back({combination(high, "high"), combination(low, "low"), cycles_of(b, cycles)});
  }
  return blocks;
}

model::FatigueOptions options_of(const bempd_fatigue* given) {
  const bempd_fatigue fatigue = given ? given_struct(given, "options", fatigue_defaults) : fatigue_defaults;
  require_at_least(fatigue.first_cycle, 0, "first_cycle");
  require_at_least(fatigue.most_cycles, 0, "most_cycles");
  require_at_least(fatigue.most_length, 0, "most_length");
  require(fatigue.most_steps >= 1, "most_steps is ", fatigue.most_steps, "; it must be >= 1");
  require(fatigue.tolerance > 0 && fatigue.tolerance < 1, "tolerance is ", fatigue.tolerance,
          "; it must be > 0 and < 1, a share of the number of cycles");
  require(fatigue.largest_step > 0 && fatigue.largest_step <= 1, "largest_step is ", fatigue.largest_step,
          "; it must be > 0 and <= 1, a share of the crack's length");
  require(fatigue.most_cycles == 0 || fatigue.most_cycles > fatigue.first_cycle, "most_cycles is ", fatigue.most_cycles,
          ", and ", fatigue.first_cycle, " have passed before; give more, or 0 for no limit");
  model::FatigueOptions options;
  options.first_cycle = fatigue.first_cycle;
  if (fatigue.most_cycles > 0) options.most_cycles = fatigue.most_cycles;
  if (fatigue.most_length > 0) options.most_length = fatigue.most_length;
  options.most_steps = fatigue.most_steps;
  options.tolerance = fatigue.tolerance, options.largest_step = fatigue.largest_step;
  return options;
}

void grow(model::Model& m, const model::FatigueOptions& asked, bempd_fatigue_report* report) {
  const model::FatigueReport done = m.fatigue().grow(asked);
  if (!report) return;
  write_struct(report,
               bempd_fatigue_report{.struct_size = sizeof(bempd_fatigue_report),
                                    .stop_reason = static_cast<int32_t>(done.end),
                                    .crack = done.tip.crack,
                                    .end = end_of(done.tip),
                                    .reserved = 0,
                                    .steps = done.steps,
                                    .cycles = done.cycles,
                                    .growth = done.growth,
                                    .error = done.error},
               "report");
}

}  // namespace

bempd_status bempd_fatigue_init(bempd_fatigue* options, int64_t struct_size) {
  return init_struct(__func__, "options", options, struct_size, fatigue_defaults);
}

bempd_status bempd_fatigue_report_init(bempd_fatigue_report* report, int64_t struct_size) {
  return init_struct(__func__, "report", report, struct_size, bempd_fatigue_report{});
}

bempd_status bempd_grow_fatigue(bempd_model* model, int64_t block_count, const double* high, const double* low,
                                const double* cycles, const bempd_fatigue* options, bempd_fatigue_report* report) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (report) struct_bytes(report, "report");
    model::FatigueOptions asked = options_of(options);
    asked.blocks = blocks_of(block_count, high, low, cycles);
    grow(m, asked, report);
  });
}

bempd_status bempd_grow_fatigue_cases(bempd_model* model, int64_t block_count, int64_t case_count, const double* high,
                                      const double* low, const double* cycles, const bempd_fatigue* options,
                                      bempd_fatigue_report* report) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (report) struct_bytes(report, "report");
    model::FatigueOptions asked = options_of(options);
    asked.blocks = blocks_of_cases(block_count, case_count, high, low, cycles);
    grow(m, asked, report);
  });
}

bempd_status bempd_fatigue_record_init(bempd_fatigue_record* record, int64_t struct_size) {
  return init_struct(__func__, "record", record, struct_size, bempd_fatigue_record{});
}

bempd_status bempd_fatigue_record_count(const bempd_model* model, int64_t* count) {
  return with_model(model, __func__, [&](const model::Model& m) {
    out(count, "count") = static_cast<int64_t>(m.fatigue().records().size());
  });
}

bempd_status bempd_get_fatigue_record(const bempd_model* model, int64_t index, bempd_fatigue_record* record) {
  return with_model(model, __func__, [&](const model::Model& m) {
    struct_bytes(record, "record");
    const std::vector<model::FatigueRecord>& all = m.fatigue().records();
    const model::FatigueRecord& r = entry_at(all, index, "; the last call of bempd_grow_fatigue() made ", " records");
    write_struct(record,
                 bempd_fatigue_record{.struct_size = sizeof(bempd_fatigue_record),
                                      .step = r.step,
                                      .event = r.event,
                                      .crack = r.tip.crack,
                                      .end = end_of(r.tip),
                                      .cycles = r.cycles,
                                      .length = r.length,
                                      .growth = r.growth,
                                      .x = r.place.x(),
                                      .y = r.place.y(),
                                      .stress_intensity_1 = r.high.x(),
                                      .stress_intensity_2 = r.high.y(),
                                      .stress_intensity_1_low = r.low.x(),
                                      .stress_intensity_2_low = r.low.y(),
                                      .highest = r.highest,
                                      .range = r.highest - r.lowest,
                                      .ratio = r.highest > 0 ? r.lowest / r.highest : std::nan(""),
                                      .rate = r.rate},
                 "record");
  });
}

bempd_status bempd_extend_cracks(bempd_model* model, int64_t count, const int32_t* cracks, const int32_t* ends,
                                 const double* lengths, bempd_growth* growth) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (growth) struct_bytes(growth, "growth");
    require_count(count, "count", "tip");
    require(cracks && ends && lengths,
            !cracks ? "cracks"
            : !ends ? "ends"
                    : "lengths",
            " is NULL; give one for each tip");
    std::vector<std::pair<crack::TipId, double>> tips;
    for (int64_t k = 0; k < count; ++k) {
      const crack::TipId tip{cracks[k], end_from(ends[k])};
      require(std::isfinite(lengths[k]) && lengths[k] > 0, "length is ", lengths[k], "; it must be > 0");
      require(std::none_of(tips.begin(), tips.end(), [&](const auto& other) { return other.first == tip; }),
              "an end of crack ", tip.crack, " is given twice; give each tip once");
      tips.emplace_back(tip, lengths[k]);
    }
    give_growth(growth, m.fatigue().extend(tips));
  });
}
