#include "model/fatigue_overloads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "model/extension_end.hpp"

namespace bempd::model {

namespace {

constexpr std::size_t numbers_of_one = 7;
constexpr double is_waiting = 2;  // added to the crack's end in a row for waiting growth

}  // namespace

std::vector<double> numbers_of(const std::vector<RememberedOverload>& overloads) {
  std::vector<double> numbers;
  for (const auto& [tip, place, overload, waiting] : overloads) {
    const double crack = tip.crack, end = tip.end;
    numbers.insert(numbers.end(), {crack, end, place.x(), place.y(), overload.end, overload.zone, overload.highest});
    if (waiting != 0) numbers.insert(numbers.end(), {crack, end + is_waiting, place.x(), place.y(), waiting, 0.0, 0.0});
  }
  return numbers;
}

std::vector<RememberedOverload> overloads_of(const std::vector<double>& numbers) {
  bool sound = numbers.size() % numbers_of_one == 0;
  std::vector<RememberedOverload> overloads;
  for (std::size_t k = 0; sound && k < numbers.size(); k += numbers_of_one) {
    const double* n = numbers.data() + k;
    const bool waits = n[1] >= is_waiting;
    const double end = waits ? n[1] - is_waiting : n[1];
    sound = n[0] >= 1 && n[0] < 1e9 && (end == 0 || end == 1) && std::isfinite(n[2]) && std::isfinite(n[3]) &&
            n[4] < std::numeric_limits<double>::infinity() && n[5] >= 0 && std::isfinite(n[5]) && n[6] >= 0 &&
            std::isfinite(n[6]) && (!waits || (std::isfinite(n[4]) && !overloads.empty()));
    if (sound && waits)
      overloads.back().waiting = n[4];
    else if (sound)
      overloads.push_back({{static_cast<int>(n[0]), static_cast<int>(n[1])}, {n[2], n[3]}, {n[4], n[5], n[6]}});
  }
  require(sound, "the state remembers overloads that are none; its bytes were altered");
  return overloads;
}

const RememberedOverload* remembered_at(const FrontTip& tip, const std::vector<RememberedOverload>& known,
                                        const std::vector<scene::Crack>& cracks) {
  constexpr double rounding_of_places = 1e-9;
  const double length = length_of(cracks[static_cast<std::size_t>(tip.values.crack) - 1]);
  const auto found = std::find_if(known.begin(), known.end(), [&](const RememberedOverload& one) {
    return one.tip == tip.id() && (one.place - tip.values.place).norm() <= rounding_of_places * length;
  });
  return found == known.end() ? nullptr : &*found;
}

std::vector<double> WaitingGrowth::of(const Front& front) const {
  std::vector<double> all;
  for (const FrontTip& tip : front) all.push_back(of(tip.id()));
  return all;
}

void WaitingGrowth::take_up(const std::vector<RememberedOverload>& known, const Front& front,
                            const std::vector<scene::Crack>& cracks) {
  for (const FrontTip& tip : front)
    if (const RememberedOverload* found = remembered_at(tip, known, cracks)) of_tips_[tip.id()] = found->waiting;
}

void MetOverloads::take_up(const std::vector<RememberedOverload>& known, const Front& front,
                           const std::vector<scene::Crack>& cracks, double first_cycle) {
  for (const FrontTip& tip : front) {
    if (!tip.law->retardation()) continue;
    const RememberedOverload* found = remembered_at(tip, known, cracks);
    require(found != nullptr, "first_cycle is ", first_cycle, ", and the overloads that crack ", tip.id().crack,
            " has met before are not known: the last call of bempd_grow_fatigue() on this model did not end at its "
            "present tip; go on from there, or begin with first_cycle = 0");
    met_[tip.id()] = found->overload;
  }
}

void MetOverloads::set_after_step(const crack::TipOnStep& tip, crack::Overload overload) {
  overload.end -= tip.growth;
  met_[tip.tip] = overload;
}

crack::Overload MetOverloads::of(const crack::TipId& tip) const {
  const auto found = met_.find(tip);
  return found == met_.end() ? crack::Overload{} : found->second;
}

std::vector<RememberedOverload> MetOverloads::remembered(const Front& front, const std::vector<double>& waiting) const {
  std::vector<RememberedOverload> all;
  for (std::size_t t = 0; t < front.size(); ++t) {
    const FrontTip& tip = front[t];
    if (tip.law->retardation() || waiting[t] != 0)
      all.push_back({tip.id(), tip.values.place, of(tip.id()), waiting[t]});
  }
  return all;
}

}  // namespace bempd::model
