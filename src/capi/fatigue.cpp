#include "model/fatigue.hpp"

#include <algorithm>
#include <cstddef>

#include "capi/guard.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

constexpr bempd_growth_rate rate_defaults{.struct_size = sizeof(bempd_growth_rate),
                                          .kind = BEMPD_RATE_PARIS,
                                          .reserved = 0,
                                          .coefficient = 0,
                                          .exponent = 0,
                                          .unit_intensity = 1,
                                          .threshold = 0,
                                          .critical_intensity = 0,
                                          .walker = 1,
                                          .p = 0,
                                          .q = 0,
                                          .closure_alpha = 1,
                                          .closure_stress = 0,
                                          .function = nullptr,
                                          .user = nullptr,
                                          .retardation = BEMPD_RETARDATION_NONE,
                                          .reserved2 = 0,
                                          .yield_strength = 0,
                                          .zone_constraint = 0,
                                          .wheeler_exponent = 0,
                                          .shutoff_ratio = 0};

constexpr bempd_fatigue fatigue_defaults{.struct_size = sizeof(bempd_fatigue),
                                         .first_cycle = 0,
                                         .most_cycles = 0,
                                         .most_length = 0,
                                         .most_steps = 1000,
                                         .tolerance = 1e-3,
                                         .largest_step = 0.25};

// Copy of a caller's struct: members beyond the caller's size have their defaults. A longer struct of a newer program
// must have zeros beyond the known members.
template <class T>
T given_struct(const T* from, const char* name, const T& defaults) {
  const std::size_t size = struct_bytes(from, name, sizeof(std::int64_t));
  T values = defaults;
  std::memcpy(&values, from, std::min(size, sizeof values));
  const auto* bytes = reinterpret_cast<const unsigned char*>(from);
  require(size <= sizeof values ||
              std::all_of(bytes + sizeof values, bytes + size, [](unsigned char byte) { return byte == 0; }),
          name, " was filled by a program made for a newer bempd, with members this version does not know");
  return values;
}

void require_at_least(double value, double least, const char* name) {
  require(std::isfinite(value) && value >= least, name, " is ", value, "; it must be a finite number >= ", least);
}

crack::HostRate::Function host_rate(bempd_rate_function function, void* user) {
  return [=](const crack::TipCycle& c) {
    return function(c.tip.crack, c.tip.end == 0 ? BEMPD_CRACK_START : BEMPD_CRACK_END, c.highest, c.lowest, c.high.x(),
                    c.high.y(), c.length, c.place.x(), c.place.y(), user);
  };
}

// Coefficient of a law for factors in [Pa m^(1/2)], out of one for factors in the unit unit_intensity. The exponent is
// that of the law, but less by one for Forman's law, which divides by a factor.
double coefficient_of(const bempd_growth_rate& rate) {
  const double exponent = rate.kind == BEMPD_RATE_FORMAN ? rate.exponent - 1 : rate.exponent;
  const double coefficient = rate.coefficient * std::pow(rate.unit_intensity, -exponent);
  require(std::isfinite(coefficient) && (coefficient > 0) == (rate.coefficient > 0), "coefficient is ",
          rate.coefficient, " with unit_intensity ", rate.unit_intensity, " and exponent ", rate.exponent,
          ", which no number holds in [Pa m^(1/2)]; state them in larger units");
  return coefficient;
}

void set_retardation(const bempd_growth_rate& rate, crack::RateParameters& parameters) {
  require(rate.retardation >= BEMPD_RETARDATION_NONE && rate.retardation <= BEMPD_RETARDATION_WILLENBORG,
          "retardation is ", rate.retardation,
          "; it must be BEMPD_RETARDATION_NONE (0), BEMPD_RETARDATION_WHEELER (1) ",
          "or BEMPD_RETARDATION_WILLENBORG (2)");
  require(rate.reserved2 == 0, "reserved2 is ", rate.reserved2, "; it must be 0");
  parameters.retarding = static_cast<crack::RateParameters::Retarding>(rate.retardation);
  if (rate.retardation == BEMPD_RETARDATION_NONE) return;
  require(rate.kind != BEMPD_RATE_SUSTAINED,
          "retardation is given with BEMPD_RATE_SUSTAINED, growth in time; it acts on growth by cycles");
  require(std::isfinite(rate.yield_strength) && rate.yield_strength > 0, "yield_strength is ", rate.yield_strength,
          "; retardation needs one > 0");
  require_at_least(rate.zone_constraint, 0, "zone_constraint");
  parameters.yield_strength = rate.yield_strength, parameters.zone_constraint = rate.zone_constraint;
  if (rate.retardation == BEMPD_RETARDATION_WHEELER) {
    require(std::isfinite(rate.wheeler_exponent) && rate.wheeler_exponent > 0, "wheeler_exponent is ",
            rate.wheeler_exponent, "; it must be > 0");
    parameters.wheeler_exponent = rate.wheeler_exponent;
    return;
  }
  require(std::isfinite(rate.shutoff_ratio) && rate.shutoff_ratio > 1, "shutoff_ratio is ", rate.shutoff_ratio,
          "; it must be > 1, the overload over the load that stops a crack");
  require(rate.kind != BEMPD_RATE_PARIS || rate.walker != 1,
          "retardation is BEMPD_RETARDATION_WILLENBORG, which acts through the load ratio R, and by the law "
          "BEMPD_RATE_PARIS with walker = 1 R has no effect; give a walker, or another law");
  parameters.shutoff_ratio = rate.shutoff_ratio;
}

crack::RateParameters parameters_of(const bempd_growth_rate* given) {
  const bempd_growth_rate rate = given_struct(given, "rate", rate_defaults);
  require(rate.kind >= BEMPD_RATE_PARIS && rate.kind <= BEMPD_RATE_HOST, "kind is ", rate.kind,
          "; it must be BEMPD_RATE_PARIS (1), BEMPD_RATE_FORMAN (2), BEMPD_RATE_NASGRO (3), BEMPD_RATE_SUSTAINED (4) "
          "or BEMPD_RATE_HOST (5)");
  require(rate.reserved == 0, "reserved is ", rate.reserved, "; it must be 0");
  const bool by_function = rate.kind == BEMPD_RATE_HOST;
  require(!by_function || rate.function != nullptr, "function is NULL; BEMPD_RATE_HOST needs one");
  if (!by_function) {
    require(std::isfinite(rate.coefficient) && rate.coefficient > 0, "coefficient is ", rate.coefficient,
            "; it must be > 0");
    require_at_least(rate.exponent, 0, "exponent");
  }
  require(std::isfinite(rate.unit_intensity) && rate.unit_intensity > 0, "unit_intensity is ", rate.unit_intensity,
          "; it must be > 0");
  require_at_least(rate.threshold, 0, "threshold");
  require_at_least(rate.critical_intensity, 0, "critical_intensity");
  require_at_least(rate.walker, 0, "walker");
  require_at_least(rate.p, 0, "p");
  require_at_least(rate.q, 0, "q");
  require(rate.closure_alpha >= 1 && rate.closure_alpha <= 3, "closure_alpha is ", rate.closure_alpha,
          "; it must lie between 1, plane stress, and 3, plane strain");
  require(rate.closure_stress >= 0 && rate.closure_stress < 1, "closure_stress is ", rate.closure_stress,
          "; it must be >= 0 and < 1");
  crack::RateParameters parameters;
  parameters.kind = static_cast<crack::RateParameters::Kind>(rate.kind);
  if (!by_function) parameters.coefficient = coefficient_of(rate);
  parameters.exponent = rate.exponent, parameters.walker = rate.walker;
  parameters.p = rate.p, parameters.q = rate.q;
  parameters.closure = {rate.closure_alpha, rate.closure_stress};
  parameters.threshold = rate.threshold * rate.unit_intensity;
  parameters.critical = rate.critical_intensity * rate.unit_intensity;
  if (by_function) parameters.function = host_rate(rate.function, rate.user);
  set_retardation(rate, parameters);
  return parameters;
}

std::vector<crack::Block> blocks_of(std::int64_t count, const double* high, const double* low, const double* cycles) {
  require(count >= 1 && count < (std::int64_t{1} << 31), "block_count is ", count, "; give at least 1 block");
  require(high != nullptr && low != nullptr, high ? "low" : "high", " is NULL; give a load factor for each block");
  require(cycles != nullptr || count == 1, "cycles is NULL; only one block, of constant amplitude, may go without");
  std::vector<crack::Block> blocks;
  for (std::int64_t b = 0; b < count; ++b) {
    const double number = cycles ? cycles[b] : 1;
    require(std::isfinite(high[b]) && std::isfinite(low[b]), "block ", b + 1, " goes from ", low[b], " to ", high[b],
            "; load factors must be finite numbers");
    require(high[b] >= low[b], "the high load factor of block ", b + 1, " is ", high[b], ", below the low one, ",
            low[b], "; it must be higher: R = low / high lies below 1");
    require(std::isfinite(number) && number > 0, "block ", b + 1, " has ", number, " cycles; it must have more than 0");
    blocks.push_back({high[b], low[b], number});
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

int32_t end_of(const crack::TipId& tip) {
  if (tip.crack == 0) return 0;
  return tip.end == 0 ? BEMPD_CRACK_START : BEMPD_CRACK_END;
}

}  // namespace

bempd_status bempd_growth_rate_init(bempd_growth_rate* rate, int64_t struct_size) {
  return init_struct(__func__, "rate", rate, struct_size, rate_defaults);
}

bempd_status bempd_set_growth_rate(bempd_model* model, int32_t material, const bempd_growth_rate* rate) {
  return with_model(model, __func__, [&](model::Model& m) { m.fatigue().set_rate(material, parameters_of(rate)); });
}

bempd_status bempd_fatigue_init(bempd_fatigue* options, int64_t struct_size) {
  return init_struct(__func__, "options", options, struct_size, fatigue_defaults);
}

bempd_status bempd_fatigue_report_init(bempd_fatigue_report* report, int64_t struct_size) {
  return init_struct(__func__, "report", report, struct_size, bempd_fatigue_report{});
}

bempd_status bempd_grow_fatigue(bempd_model* model, int64_t block_count, const double* high, const double* low,
                                const double* cycles, const bempd_fatigue* options, bempd_fatigue_report* report) {
  return with_model(model, __func__, [&](model::Model& m) {
    if (report) struct_bytes(report, "report", sizeof(int64_t));
    model::FatigueOptions asked = options_of(options);
    asked.blocks = blocks_of(block_count, high, low, cycles);
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
    struct_bytes(record, "record", sizeof(int64_t));
    const std::vector<model::FatigueRecord>& all = m.fatigue().records();
    require(index >= 0 && index < static_cast<int64_t>(all.size()), "index is ", index, "; the last call of ",
            "bempd_grow_fatigue() made ", all.size(), " records");
    const model::FatigueRecord& r = all[static_cast<std::size_t>(index)];
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
    if (growth) struct_bytes(growth, "growth", sizeof(int64_t));
    require(count >= 1 && count < (int64_t{1} << 31), "count is ", count, "; give at least 1 tip");
    require(cracks && ends && lengths,
            !cracks ? "cracks"
            : !ends ? "ends"
                    : "lengths",
            " is NULL; give one for each tip");
    std::vector<std::pair<crack::TipId, double>> tips;
    for (int64_t k = 0; k < count; ++k) {
      require(ends[k] == BEMPD_CRACK_START || ends[k] == BEMPD_CRACK_END, "end is ", ends[k],
              "; it must be BEMPD_CRACK_START (1) or BEMPD_CRACK_END (2)");
      require(std::isfinite(lengths[k]) && lengths[k] > 0, "length is ", lengths[k], "; it must be > 0");
      const crack::TipId tip{cracks[k], ends[k] == BEMPD_CRACK_START ? 0 : 1};
      require(std::none_of(tips.begin(), tips.end(), [&](const auto& other) { return other.first == tip; }),
              "an end of crack ", tip.crack, " is given twice; give each tip once");
      tips.emplace_back(tip, lengths[k]);
    }
    const model::GrowthResult grown = m.fatigue().extend(tips);
    if (growth)
      write_struct(growth,
                   bempd_growth{sizeof(bempd_growth), grown.tips, grown.ended, grown.load_factor, grown.length,
                                grown.released_energy},
                   "growth");
  });
}
