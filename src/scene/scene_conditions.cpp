#include "error.hpp"
#include "scene/scene.hpp"

namespace bempd::scene {

void Scene::check_condition(const Condition& condition, bool is_support) const {
  require(condition.components >= 1 && condition.components <= 3, "component is ", condition.components,
          "; it must be BEMPD_X (1), BEMPD_Y (2)", is_support ? " or BEMPD_BOTH (3) where allowed" : "");
  if (const auto* samples = std::get_if<SampledValues>(&condition.values)) samples->check();
  condition.place->check(*this);
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
  require(!supports_[id - 1].removed(), "support ", id, " was removed");
  return supports_[id - 1];
}

Condition& Scene::load(int id) {
  require(id >= 1 && id <= static_cast<int>(loads_.size()), "load ", id, " does not exist; there are ", loads_.size());
  require(!loads_[id - 1].removed(), "load ", id, " was removed");
  return loads_[id - 1];
}

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
  auto* samples = std::get_if<SampledValues>(&condition.values);
  require(samples != nullptr, what, " ", id, " was given by a function; only sampled values can be replaced");
  require(samples->constant.size() == values.constant.size(), what, " ", id, " was made with ",
          samples->constant.size(), " values, now there are ", values.constant.size(), "; give as many");
  values.check();
  *samples = std::move(values);
}

}  // namespace bempd::scene
