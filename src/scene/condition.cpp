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
    require(std::isfinite(values[i]), "the ", part, " value ", i, " is ", values[i], "; it must be a finite number");
  }
}

}  // namespace

double SampledValues::constant_at(double fraction) const { return sample(constant, fraction); }

double SampledValues::proportional_at(double fraction) const { return sample(proportional, fraction); }

void SampledValues::check() const {
  require_finite(constant, "constant");
  require_finite(proportional, "proportional");
}

BoundaryValue Condition::value(const Point& where, double fraction_of_part) const {
  if (const auto* function = std::get_if<BoundaryFunction>(&values)) return (*function)(where);
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
