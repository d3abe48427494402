#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

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

void check_values(const SampledValues& values) {
  require_finite(values.constant, "constant");
  require_finite(values.proportional, "proportional");
}

}  // namespace

double SampledValues::constant_at(double fraction) const { return sample(constant, fraction); }

double SampledValues::proportional_at(double fraction) const { return sample(proportional, fraction); }

BoundaryValue Condition::value(const Point& where, double fraction_of_part) const {
  if (const auto* function = std::get_if<BoundaryFunction>(&values)) return (*function)(where);
  const auto& samples = std::get<SampledValues>(values);
  return {Point::Constant(samples.constant_at(fraction_of_part)),
          Point::Constant(samples.proportional_at(fraction_of_part))};
}

void Scene::check_condition(const Condition& condition, bool is_support) const {
  require(condition.components >= 1 && condition.components <= 3, "component is ", condition.components,
          "; it must be BEMPD_X (1), BEMPD_Y (2)", is_support ? " or BEMPD_BOTH (3) where allowed" : "");
  if (const auto* samples = std::get_if<SampledValues>(&condition.values)) check_values(*samples);
  if (const auto* part = std::get_if<EdgePart>(&condition.place)) {
    const Region& region = this->region(part->region);
    require(part->edge >= 1 && part->edge <= region.edge_count(), "edge ", part->edge, " does not exist; region ",
            part->region, " has edges 1 .. ", region.edge_count());
    require(std::isfinite(part->from) && std::isfinite(part->to) && part->from >= 0 && part->to <= 1 &&
                part->to - part->from > 1e-9,
            "the part of the edge is from ", part->from, " to ", part->to,
            "; fractions must satisfy 0 <= from < to <= 1");
  } else {
    const Point& p = std::get<Point>(condition.place);
    require(p.allFinite(), "the place is (", p.x(), ", ", p.y(), "); coordinates must be finite numbers");
  }
}

int Scene::add_support(Condition condition) {
  check_condition(condition, true);
  supports_.push_back(std::move(condition));
  return static_cast<int>(supports_.size());
}

int Scene::add_load(Condition condition) {
  check_condition(condition, false);
  loads_.push_back(std::move(condition));
  return static_cast<int>(loads_.size());
}

Condition& Scene::support(int id) {
  require(id >= 1 && id <= static_cast<int>(supports_.size()), "support ", id, " does not exist; there are ",
          supports_.size());
  return supports_[id - 1];
}

Condition& Scene::load(int id) {
  require(id >= 1 && id <= static_cast<int>(loads_.size()), "load ", id, " does not exist; there are ", loads_.size());
  return loads_[id - 1];
}

void Scene::set_values(Condition& condition, const char* what, int id, SampledValues values) {
  auto* samples = std::get_if<SampledValues>(&condition.values);
  require(samples != nullptr, what, " ", id, " was given by a function; only sampled values can be replaced");
  require(samples->constant.size() == values.constant.size(), what, " ", id, " was made with ",
          samples->constant.size(), " values, now there are ", values.constant.size(), "; give as many");
  check_values(values);
  *samples = std::move(values);
}

}  // namespace bempd::model
