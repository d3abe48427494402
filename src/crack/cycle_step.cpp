#include "crack/cycle_step.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "error.hpp"

namespace bempd::crack {

namespace {

// Number of parts into which the crack growth in one step is divided while cycles are counted. In each part growth
// rates are integrated by the Runge-Kutta rule, whose error is far below that of the step itself.
constexpr double parts_of_a_step = 24;

// Largest growth that is integrated at once inside the plastic zone of an overload, as a share of the distance from the
// tip to the end of the zone: for cycles of one block, and for whole programs of cycles.
constexpr double share_of_zone = 0.04, share_of_zone_by_program = 0.002;

double rate_of(const TipOnStep& tip, double grown, const Block& block, const Overload& overload) {
  const double rate = tip.law->rate(tip.cycle(grown, block), overload, grown);
  if (!(rate >= 0) || std::isinf(rate))
    fail(Failure::argument, "the growth rate of crack ", tip.tip.crack, " is ", rate,
         "; it must be a finite number >= 0");
  return rate;
}

// Highest load of a block over the load that breaks the tip: by the equivalent factor, and by the net section.
struct Shares {
  double of_factor, of_section;
  double largest() const { return std::max(of_factor, of_section); }
};

Shares shares_of(const TipOnStep& tip, double grown, const Block& block) {
  const LevelFactors high = tip.at(grown, block.high), low = tip.at(grown, block.low);
  return {std::max(high.equivalent, low.equivalent) / tip.critical_at(grown),
          std::max(high.net_section, low.net_section)};
}

double share_of_critical(const TipOnStep& tip, double grown, const Block& block) {
  return shares_of(tip, grown, block).largest();
}

double between(double first, double last, double share) { return (1 - share) * first + share * last; }

// Interpolates the ratio of the load on a net section to its limit load between two crack lengths, by the inverse
// ratio: the inverse is proportional to the ligament (rest of the section), which shrinks about linearly as the tip
// grows.
double section_between(double first, double last, double share) {
  return first > 0 && last > 0 ? 1 / between(1 / first, 1 / last, share) : between(first, last, share);
}

}  // namespace

LevelFactors TipOnStep::at(double grown, std::size_t level) const {
  const LevelFactors& first = before[level];
  if (after.empty() || !(growth > 0)) return first;
  const LevelFactors& last = after[level];
  const double share = grown / growth, start = own_length();
  LevelFactors there;
  there.net_section = section_between(first.net_section, last.net_section, share);
  there.t_stress = between(first.t_stress, last.t_stress, share);
  if (!(first.equivalent * last.equivalent > 0)) {
    there.factors = (1 - share) * first.factors + share * last.factors;
    there.equivalent = between(first.equivalent, last.equivalent, share);
    return there;
  }
  const double whole = std::log1p(growth / start), way = std::log1p(grown / start);
  const double power = std::log(last.equivalent / first.equivalent) / whole;
  there.equivalent = first.equivalent * std::exp(way * (power + (way - whole) * bend(level)));
  const Point modes = (1 - share) / first.equivalent * first.factors + share / last.equivalent * last.factors;
  there.factors = there.equivalent * modes;
  return there;
}

double TipOnStep::critical_at(double grown) const {
  const std::size_t parts = critical.size() - 1;
  if (parts == 0 || !(growth > 0)) return critical.front();
  const double at = std::clamp(grown / growth, 0.0, 1.0) * static_cast<double>(parts);
  const std::size_t part = std::min(static_cast<std::size_t>(at), parts - 1);
  if (std::isinf(critical[part]) || std::isinf(critical[part + 1])) return std::min(critical[part], critical[part + 1]);
  return between(critical[part], critical[part + 1], at - static_cast<double>(part));
}

// Curvature of the equivalent factor (logarithms); 0 if the previous step is unknown or exceeded 0.7 own_length().
double TipOnStep::bend(std::size_t level) const {
  const double start = own_length(), longest = 0.7 * start;
  const bool is_known = !past.empty() && past[level].equivalent * before[level].equivalent > 0;
  if (!is_known || !(past_growth > 0 && past_growth < longest)) return 0;
  const double whole = std::log1p(growth / start), back = -std::log1p(-past_growth / start);
  const double power = std::log(after[level].equivalent / before[level].equivalent) / whole;
  const double power_before = std::log(before[level].equivalent / past[level].equivalent) / back;
  return (power - power_before) / (whole + back);
}

TipCycle TipOnStep::cycle(double grown, const Block& block) const {
  LevelFactors high = at(grown, block.high), low = at(grown, block.low);
  if (low.equivalent > high.equivalent) std::swap(high, low);
  const double share = growth > 0 ? grown / growth : 0;
  return {tip,
          high.factors,
          low.factors,
          high.equivalent,
          low.equivalent,
          critical_at(grown),
          high.t_stress,
          length + share * crack_growth,
          from + share * (to - from)};
}

double mean_rate(const TipOnStep& tip, double grown, const CycleProgram& program) {
  double sum = 0;
  for (std::size_t b = 0; b < program.size(); ++b) {
    const Block& block = program.block(b);
    if (share_of_critical(tip, grown, block) >= 1) continue;
    sum += rate_of(tip, grown, block, tip.overload) * (program.size() == 1 ? 1 : block.cycles / program.cycles());
  }
  return sum;
}

std::size_t CycleIntegration::critical_tip(const Growth& grown, std::size_t block) const {
  std::size_t t = 0;
  while (t < tips_.size() && share_of_critical(tips_[t], grown[t], program_.block(block)) < 1) ++t;
  return t;
}

std::size_t CycleIntegration::most_loaded(const Growth& grown, std::size_t block) const {
  std::size_t most = 0;
  const auto share = [&](std::size_t t) { return share_of_critical(tips_[t], grown[t], program_.block(block)); };
  for (std::size_t t = 1; t < tips_.size(); ++t)
    if (share(t) > share(most)) most = t;
  return most;
}

void CycleIntegration::end_at(CyclesOnStep& now, std::size_t tip) const {
  const Shares shares = shares_of(tips_[tip], now.growth[tip], program_.block(now.place.block));
  now.tip = tip;
  now.end = shares.of_section > shares.of_factor ? CyclesEnd::net_section : CyclesEnd::critical;
}

std::optional<std::vector<double>> CycleIntegration::rates(const Growth& grown, std::size_t block,
                                                           const Overloads& overloads) const {
  if (critical_tip(grown, block) < tips_.size()) return std::nullopt;
  Growth rates;
  for (std::size_t t = 0; t < tips_.size(); ++t)
    rates.push_back(rate_of(tips_[t], grown[t], program_.block(block), overloads[t]));
  return rates;
}

void CycleIntegration::update_overloads(Overloads& overloads, const Growth& grown, std::size_t block) const {
  for (std::size_t t = 0; t < tips_.size(); ++t)
    if (const Retardation* retardation = tips_[t].law->retardation())
      overloads[t] =
          retardation->after(overloads[t], grown[t], tips_[t].cycle(grown[t], program_.block(block)).highest);
}

double CycleIntegration::growth_to_zone_end(std::size_t tip, double grown, const Overload& overload) const {
  const double left = overload.end - grown;
  return tips_[tip].law->retardation() && left > 0 ? left : std::numeric_limits<double>::infinity();
}

std::optional<std::vector<double>> CycleIntegration::program_growth(const Growth& grown,
                                                                    const Overloads& overloads) const {
  Growth sum(tips_.size(), 0.0);
  Overloads met = overloads;
  for (std::size_t b = 0; b < program_.size(); ++b) update_overloads(met, grown, b);  // overloads after an earlier pass
  for (std::size_t b = 0; b < program_.size(); ++b) {
    const std::optional<Growth> of_block = rates(grown, b, met);
    if (!of_block) return std::nullopt;
    for (std::size_t t = 0; t < sum.size(); ++t) sum[t] += program_.block(b).cycles * (*of_block)[t];
  }
  return sum;
}

// Growth of each tip after `by` more cycles or programs, by the classical Runge-Kutta rule; empty if a tip would break.
template <class Rates>
std::optional<std::vector<double>> CycleIntegration::advanced(const Growth& grown, double by,
                                                              const Rates& rates_at) const {
  const auto moved = [&](const Growth& rates, double way) {
    Growth there = grown;
    for (std::size_t t = 0; t < there.size(); ++t) there[t] += way * rates[t];
    return there;
  };
  const std::optional<Growth> a = rates_at(grown);
  const std::optional<Growth> b = a ? rates_at(moved(*a, 0.5 * by)) : std::nullopt;
  const std::optional<Growth> c = b ? rates_at(moved(*b, 0.5 * by)) : std::nullopt;
  const std::optional<Growth> d = c ? rates_at(moved(*c, by)) : std::nullopt;
  if (!d) return std::nullopt;
  Growth mean = *a;
  for (std::size_t t = 0; t < mean.size(); ++t) mean[t] = ((*a)[t] + 2 * ((*b)[t] + (*c)[t]) + (*d)[t]) / 6;
  return moved(mean, by);
}

// Passes several whole programs of cycles at once. Returns false if the blocks have to be passed one by one.
bool CycleIntegration::pass_programs(CyclesOnStep& now, std::size_t goal, double growth, double most_cycles) const {
  if (program_.size() == 1 || now.place.block != 0 || now.place.done > 0) return false;
  const std::optional<Growth> by_one = program_growth(now.growth, now.overloads);
  if (!by_one || !((*by_one)[goal] > 0)) return false;
  for (std::size_t t = 0; t < tips_.size(); ++t)
    if ((*by_one)[t] > share_of_zone_by_program * growth_to_zone_end(t, now.growth[t], now.overloads[t])) return false;
  const double part = std::min(growth / parts_of_a_step, growth - now.growth[goal]);
  const auto rates_at = [&](const Growth& grown) { return program_growth(grown, now.overloads); };
  double programs = std::min(part / (*by_one)[goal], (most_cycles - now.cycles) / program_.cycles());
  for (; programs >= 4; programs /= 2) {
    const double whole = std::floor(programs);
    const std::optional<Growth> there = advanced(now.growth, whole, rates_at);
    if (!there || (*there)[goal] > growth || !program_growth(*there, now.overloads)) continue;
    now.growth = *there;
    for (std::size_t b = 0; b < program_.size(); ++b) update_overloads(now.overloads, now.growth, b);
    now.cycles += whole * program_.cycles();
    return true;
  }
  return false;
}

// Passes some cycles of the present block. Returns false if a tip breaks in them, or tip `goal` has grown by `growth`.
bool CycleIntegration::pass_block(CyclesOnStep& now, const Growth& at_start, std::size_t goal, double growth,
                                  double most_cycles) const {
  const auto after = [&](double cycles) {
    return advanced(now.growth, cycles,
                    [&](const Growth& grown) { return rates(grown, now.place.block, now.overloads); });
  };
  const auto arrive = [&](double cycles, Growth grown) {
    now.cycles += cycles;
    // An overload's zone lies ahead of the place where its cycle began, so less than a whole cycle adds no overload.
    Growth last_begins = now.growth;
    for (std::size_t t = 0; t < grown.size(); ++t) last_begins[t] += (1 - 1 / cycles) * (grown[t] - last_begins[t]);
    now.growth = std::move(grown);
    now.in_cycle = cycles < 1;
    if (cycles >= 1) update_overloads(now.overloads, last_begins, now.place.block);
    program_.go_on(now.place, cycles);
  };
  double cycles = std::min(program_.left(now.place), most_cycles - now.cycles);
  for (std::size_t t = 0; t < tips_.size(); ++t)
    if (at_start[t] > 0 && tips_[t].growth > 0)
      cycles = std::min(cycles, (t == goal ? growth : tips_[t].growth) / parts_of_a_step / at_start[t]);
  for (std::size_t t = 0; t < tips_.size(); ++t)
    if (at_start[t] > 0)
      cycles = std::min(cycles, share_of_zone * growth_to_zone_end(t, now.growth[t], now.overloads[t]) / at_start[t]);
  std::optional<Growth> grown = after(cycles);
  const bool breaks = !grown || critical_tip(*grown, now.place.block) < tips_.size();
  if (!breaks && (*grown)[goal] < growth * (1 - 1e-12)) {
    arrive(cycles, std::move(*grown));
    return true;
  }
  double low = 0, high = cycles;
  Growth last = now.growth;
  for (int i = 0; i < 60 && high - low > 1e-13 * high; ++i) {
    const double middle = 0.5 * (low + high);
    std::optional<Growth> there = after(middle);
    const bool beyond = !there || critical_tip(*there, now.place.block) < tips_.size() || (*there)[goal] > growth;
    (beyond ? high : low) = middle;
    if (!beyond) last = std::move(*there);
  }
  const bool reached = last[goal] >= growth * (1 - 1e-9);
  CyclesOnStep broken = now;
  broken.growth = last;
  if (!reached) end_at(broken, most_loaded(last, now.place.block));
  now.end = reached ? CyclesEnd::growth : broken.end, now.tip = broken.tip;
  arrive(low, std::move(last));
  return false;
}

CyclesOnStep CycleIntegration::run(const CycleProgram::Place& from, std::vector<double> grown, std::size_t goal,
                                   double growth, double most_cycles) const {
  CyclesOnStep now;
  now.growth = std::move(grown);
  now.place = from;
  for (const TipOnStep& tip : tips_) now.overloads.push_back(tip.overload);
  std::size_t idle_blocks = 0;
  for (;;) {
    check_cancelled();
    if (now.cycles >= most_cycles * (1 - 1e-14)) {
      now.end = CyclesEnd::cycles;
      return now;
    }
    if (const std::size_t tip = critical_tip(now.growth, now.place.block); tip < tips_.size()) {
      end_at(now, tip);
      return now;
    }
    if (pass_programs(now, goal, growth, most_cycles)) continue;
    const double begun = now.place.done - std::floor(now.place.done);
    if (!now.in_cycle || begun < 1e-9 || begun > 1 - 1e-9) update_overloads(now.overloads, now.growth, now.place.block);
    const Growth present = *rates(now.growth, now.place.block, now.overloads);
    if (std::all_of(present.begin(), present.end(), [](double rate) { return rate == 0; })) {
      if (++idle_blocks > program_.size() || program_.size() == 1) {
        now.end = CyclesEnd::none_grows;
        return now;
      }
      const double cycles = std::min(program_.left(now.place), most_cycles - now.cycles);
      now.cycles += cycles;
      program_.go_on(now.place, cycles);
      continue;
    }
    idle_blocks = 0;
    if (!pass_block(now, present, goal, growth, most_cycles)) return now;
  }
}

}  // namespace bempd::crack
