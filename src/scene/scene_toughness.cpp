#include <cmath>

#include "error.hpp"
#include "scene/scene.hpp"

namespace bempd::scene {

namespace {

std::shared_ptr<const ScatteredField> field_of(std::vector<Point> places, std::vector<double> fracture_energies) {
  for (std::size_t k = 0; k < fracture_energies.size(); ++k) {
    require(places[k].allFinite(), "place ", k + 1, " is (", places[k].x(), ", ", places[k].y(),
            "); it must be finite");
    require(std::isfinite(fracture_energies[k]) && fracture_energies[k] > 0, "value ", k + 1, " is ",
            fracture_energies[k], "; a fracture energy must be a number above 0");
  }
  return std::make_shared<const ScatteredField>(std::move(places), std::move(fracture_energies));
}

}  // namespace

void Scene::set_toughness(int region_id, std::vector<Point> places, std::vector<double> fracture_energies) {
  Region& region = mutable_region(region_id);
  require(material_of(region_id).fracture_energy > 0, "the material of region ", region_id,
          " has no fracture_energy, whose place the values take; give it one");
  region.set_fracture_energies(field_of(std::move(places), std::move(fracture_energies)));
}

}  // namespace bempd::scene
