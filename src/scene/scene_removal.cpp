#include "error.hpp"
#include "scene/scene.hpp"

namespace bempd::scene {

namespace {

void require_free(const std::vector<Condition>& conditions, const char* what, int region) {
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    require(conditions[i].removed() || !conditions[i].place->needs(region), "region ", region, " bears ", what, " ",
            i + 1, "; remove that first");
  }
}

}  // namespace

void Scene::remove_region(int id) {
  region(id);
  require_free(supports_, "support", id);
  require_free(loads_, "load", id);
  regions_[id - 1].reset();
}

const Crack& Scene::crack(int id) const {
  require(id >= 1 && id <= static_cast<int>(cracks_.size()), "crack ", id, " does not exist; there are ",
          cracks_.size());
  require(!cracks_[id - 1].points.empty(), "crack ", id, " was removed");
  return cracks_[id - 1];
}

void Scene::remove_crack(int id) {
  crack(id);
  for (std::size_t l = 0; l < loads_.size(); ++l)
    require(loads_[l].removed() || !loads_[l].place->needs_crack(id), "load ", l + 1, " is on crack ", id,
            "; remove that load first");
  cracks_[id - 1].points.clear();
}

void Scene::remove_support(int id) { support(id) = {}; }

void Scene::remove_load(int id) { load(id) = {}; }

}  // namespace bempd::scene
