#include "crack/laws/resistance_directions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "error.hpp"
#include "number_range.hpp"

namespace bempd::crack {

namespace {

constexpr double pi = std::numbers::pi;

// Largest kink angle that is tried, to either side [rad].
constexpr double widest_kink = 1.9;
// Number of equal steps between trial angles, from 0 to the largest kink angle, on either side.
constexpr int steps_to_widest = 64;

// Number of local maxima over the trial angles around which the largest ratio of energy release rate to fracture energy
// is searched.
constexpr std::size_t most_tops = 3;

// Indices of the highest local maxima, the highest one first.
std::vector<std::size_t> tops_of(const std::vector<double>& values) {
  std::vector<std::size_t> tops;
  for (std::size_t k = 0; k < values.size(); ++k)
    if ((k == 0 || values[k] >= values[k - 1]) && (k + 1 == values.size() || values[k] >= values[k + 1]))
      tops.push_back(k);
  std::stable_sort(tops.begin(), tops.end(), [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  if (tops.size() > most_tops) tops.resize(most_tops);
  return tops;
}

// Largest value of a function between two angles, by golden section search.
template <class Value>
Kink largest_between(double low, double high, const Value& value) {
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low), at_a = value(a), at_b = value(b);
  for (int round = 0; round < 45; ++round) {
    if (at_a > at_b) {
      high = b, b = a, at_b = at_a;
      a = high - golden * (high - low), at_a = value(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + golden * (high - low), at_b = value(b);
    }
  }
  return at_a > at_b ? Kink{a, at_a} : Kink{b, at_b};
}

// Angle of an axis (a direction or its opposite) within half a turn from `first` on.
double within_half_turn(double angle, double first) {
  double turned = std::fmod(angle - first, pi);
  if (turned < 0) turned += pi;
  return first + turned;
}

}  // namespace

ResistanceDirections::ResistanceDirections(std::vector<double> angles, std::vector<double> shares)
    : angles_(std::move(angles)), shares_(std::move(shares)) {
  for (std::size_t k = 0; k < angles_.size(); ++k) {
    require(std::isfinite(angles_[k]), "angle ", k + 1, " is ", angles_[k], "; it must be a finite number");
    require(k == 0 || angles_[k] > angles_[k - 1], "angle ", k + 1, " is ", angles_[k], ", not above the one before, ",
            angles_[k == 0 ? 0 : k - 1], "; give them in ascending order");
  }
  require(angles_.back() - angles_.front() < pi, "the angles span ", angles_.back() - angles_.front(),
          "; they must lie within half a turn, pi: a direction and its opposite are the same");
}

double ResistanceDirections::share(double angle) const {
  if (angles_.size() == 1) return shares_.front();
  const double at = within_half_turn(angle, angles_.front());
  const auto behind = std::upper_bound(angles_.begin(), angles_.end(), at);
  const auto k = static_cast<std::size_t>(behind - angles_.begin());
  const bool wraps = behind == angles_.end();
  const double from = angles_[k - 1], to = wraps ? angles_.front() + pi : angles_[k];
  const double way = std::min(1.0, (at - from) / (to - from));
  return (1 - way) * shares_[k - 1] + way * shares_[wraps ? 0 : k];
}

double ResistanceDirections::smallest_share() const { return *std::min_element(shares_.begin(), shares_.end()); }

// Kink angles to try: equal steps, and the directions of the table, where the ratio of energy release rate to fracture
// energy may have a cusp.
std::vector<double> ResistanceDirections::trial_angles(double heading) const {
  std::vector<double> trials;
  for (int k = -steps_to_widest; k <= steps_to_widest; ++k) trials.push_back(widest_kink * k / steps_to_widest);
  for (const double angle : angles_)
    for (double kink = within_half_turn(angle - heading, -2 * pi); kink < widest_kink; kink += pi)
      if (kink > -widest_kink) trials.push_back(kink);
  std::sort(trials.begin(), trials.end());
  return trials;
}

Kink ResistanceDirections::kink(const Point& given, double heading, KinkCriterion criterion) const {
  const int far = far_exponent(given.lpNorm<Eigen::Infinity>());
  const Point factors = far == 0 ? given : Point(given * std::ldexp(1, -far));
  const auto value = [&](double angle) {
    return factor_of_kink(factors, angle, criterion) / std::sqrt(share(heading + angle));
  };
  const std::vector<double> trials = trial_angles(heading);
  std::vector<double> values;
  for (const double angle : trials) values.push_back(value(angle));
  Kink best{0, -std::numeric_limits<double>::infinity()};
  const auto take = [&](const Kink& kink) {
    if (kink.equivalent_factor > best.equivalent_factor) best = kink;
  };
  for (const std::size_t top : tops_of(values)) {
    take({trials[top], values[top]});
    // The ratio of energy release rate to fracture energy is smooth between neighbouring trial angles only, so both
    // sides of a maximum are searched separately.
    if (top > 0) take(largest_between(trials[top - 1], trials[top], value));
    if (top + 1 < trials.size()) take(largest_between(trials[top], trials[top + 1], value));
  }
  return {best.angle, std::ldexp(best.equivalent_factor, far)};
}

}  // namespace bempd::crack
