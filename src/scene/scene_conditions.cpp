#include "error.hpp"
#include "scene/scene.hpp"

namespace bempd::scene {

namespace {

Condition with_sample_count(Condition condition) {
  const auto* samples = std::get_if<SampledValues>(&condition.values);
  condition.sample_count = samples ? samples->constant.size() : 0;
  return condition;
}

// Condition number `id` of a list; throws Error (argument) if there is none or it was removed.
const Condition& condition_at(const std::vector<Condition>& all, const char* what, int id) {
  require(id >= 1 && id <= static_cast<int>(all.size()), what, " ", id, " does not exist; there are ", all.size());
  require(!all[id - 1].removed(), what, " ", id, " was removed");
  return all[id - 1];
}

}  // namespace

void Scene::check_condition(const Condition& condition, bool is_support) const {
  require(condition.components >= 1 && condition.components <= 3, "component is ", condition.components,
          "; it must be BEMPD_X (1), BEMPD_Y (2)", is_support ? " or BEMPD_BOTH (3) where allowed" : "");
  if (const auto* samples = std::get_if<SampledValues>(&condition.values)) samples->check();
  if (const auto* placed = std::get_if<PlacedValues>(&condition.values)) placed->check();
  condition.place->check(*this);
}

int Scene::add_support(Condition condition) {
  check_condition(condition, true);
  supports_.push_back(with_sample_count(std::move(condition)));
  return static_cast<int>(supports_.size());
}

int Scene::add_load(Condition condition) {
  check_condition(condition, false);
  loads_.push_back(with_sample_count(std::move(condition)));
  return static_cast<int>(loads_.size());
}

const Condition& Scene::support(int id) const { return condition_at(supports_, "support", id); }

const Condition& Scene::load(int id) const { return condition_at(loads_, "load", id); }

Condition& Scene::support(int id) { return const_cast<Condition&>(std::as_const(*this).support(id)); }

Condition& Scene::load(int id) { return const_cast<Condition&>(std::as_const(*this).load(id)); }

SceneValues Scene::values() const {
  SceneValues all;
  for (const Condition& support : supports_) all.supports.push_back(support.values);
  for (const Condition& load : loads_) all.loads.push_back(load.values);
  return all;
}

void Scene::exchange_values(SceneValues& values) noexcept {
  for (std::size_t i = 0; i < supports_.size(); ++i) supports_[i].values.swap(values.supports[i]);
  for (std::size_t i = 0; i < loads_.size(); ++i) loads_[i].values.swap(values.loads[i]);
}

void Scene::set_values(Condition& condition, const char* what, int id, SampledValues values) {
  const std::size_t count = condition.sample_count;
  require(count != 0, what, " ", id, " was given by a function; only sampled values can be replaced; bempd_set_", what,
          "_values_at() replaces any");
  require(count == values.constant.size(), what, " ", id, " has ", count, count == 1 ? " value" : " values",
          " for each component, now there are ", values.constant.size(),
          "; give as many, or x and y at places of your own by bempd_set_", what, "_values_at()");
  values.check();
  condition.values = std::move(values);
}

void Scene::set_values(Condition& condition, const char* what, int id, PlacedValues values) {
  require(condition.place->lies_along_a_line(), what, " ", id,
          " does not lie along an edge or a crack; give it its value by bempd_set_", what, "_values()");
  values.check();
  condition.values = std::move(values);
}

}  // namespace bempd::scene
