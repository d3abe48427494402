#include "scene/condition.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"

namespace bempd::scene {

namespace {

double sample(const std::vector<double>& values, double fraction) {
  if (values.size() == 1) return values.front();
  const double position = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const std::size_t left = std::min(static_cast<std::size_t>(position), values.size() - 2);
  const double weight = position - static_cast<double>(left);
  return (1 - weight) * values[left] + weight * values[left + 1];
}

void require_finite(const std::vector<double>& values, const char* part) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    require(std::isfinite(values[i]), "the ", part, " value ", i + 1, " is ", values[i],
            "; it must be a finite number");
  }
}

}  // namespace

double SampledValues::constant_at(double fraction) const { return sample(constant, fraction); }

double SampledValues::proportional_at(double fraction) const { return sample(proportional, fraction); }

void SampledValues::check() const {
  require_finite(constant, "constant");
  require_finite(proportional, "proportional");
}

BoundaryValue PlacedValues::at(double fraction) const {
  const auto after = std::upper_bound(fractions.begin(), fractions.end(), fraction) - fractions.begin();
  const auto last = static_cast<std::ptrdiff_t>(fractions.size()) - 1;
  const auto left = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, last));
  const auto right = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 0, last));
  const double apart = fractions[right] - fractions[left];
  const double weight = apart > 0 ? (fraction - fractions[left]) / apart : 0;
  const auto between = [&](const std::vector<double>& all) {
    const Point before(all[2 * left], all[2 * left + 1]), behind(all[2 * right], all[2 * right + 1]);
    return weight == 0 ? before : Point((1 - weight) * before + weight * behind);
  };
  return {between(constant), between(proportional)};
}

void PlacedValues::check() const {
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    require(fractions[i] >= 0 && fractions[i] <= 1, "fraction ", i + 1, " is ", fractions[i],
            "; places lie between 0, the start of the part, and 1, its end");
    require(i == 0 || fractions[i] > fractions[i - 1], "fraction ", i + 1, " is ", fractions[i], " after ",
            i == 0 ? 0 : fractions[i - 1], "; give places in order along the part, each once");
  }
  require_finite(constant, "constant");
  require_finite(proportional, "proportional");
}

BoundaryValue Condition::value(const Point& where, double fraction_of_part) const {
  if (const auto* function = std::get_if<BoundaryFunction>(&values)) return (*function)(where, fraction_of_part);
  if (const auto* placed = std::get_if<PlacedValues>(&values)) return placed->at(fraction_of_part);
  const auto& samples = std::get<SampledValues>(values);
  return {Point::Constant(samples.constant_at(fraction_of_part)),
          Point::Constant(samples.proportional_at(fraction_of_part))};
}

BoundaryValue Condition::acting_value(const Point& where, double fraction_of_part) const {
  BoundaryValue acting = value(where, fraction_of_part);
  for (int component = 0; component < 2; ++component) {
    if (!acts_on(component)) acting.constant[component] = acting.proportional[component] = 0;
  }
  return acting;
}

}  // namespace bempd::scene
