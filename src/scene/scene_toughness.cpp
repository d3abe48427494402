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

// Energies of a table as shares of the material's fracture energy.
std::vector<double> shares_of(std::vector<double> energies, double of_material) {
  for (std::size_t k = 0; k < energies.size(); ++k) {
    require(std::isfinite(energies[k]) && energies[k] > 0, "energy ", k + 1, " is ", energies[k],
            "; a fracture energy must be a number above 0");
    energies[k] /= of_material;
  }
  return energies;
}

Material& breaking_material(Scene& scene, int id) {
  require(scene.material(id).fracture_energy > 0, "material ", id,
          " has no fracture_energy, whose place the values take; give it one");
  return scene.mutable_material(id);
}

Material& material_for_table(Scene& scene, int id) {
  Material& material = breaking_material(scene, id);
  require(!material.resistance.function, "material ", id,
          " has a resistance function, which takes the place of tables; give one of them");
  return material;
}

}  // namespace

void set_resistance_function(Scene& scene, int id, crack::HostResistance::Function function) {
  crack::Resistance& resistance = breaking_material(scene, id).resistance;
  require(!resistance.curve && !resistance.directions, "material ", id,
          " has a table of resistance; a function takes the place of tables, so give one of them");
  resistance.function = std::make_shared<const crack::HostResistance>(std::move(function));
}

void set_resistance_curve(Scene& scene, int id, std::vector<double> extensions, std::vector<double> energies) {
  Material& material = material_for_table(scene, id);
  material.resistance.curve = std::make_shared<const crack::ResistanceCurve>(
      std::move(extensions), shares_of(std::move(energies), material.fracture_energy));
}

void set_resistance_directions(Scene& scene, int id, std::vector<double> angles, std::vector<double> energies) {
  Material& material = material_for_table(scene, id);
  material.resistance.directions = std::make_shared<const crack::ResistanceDirections>(
      std::move(angles), shares_of(std::move(energies), material.fracture_energy));
}

double Crack::grown(int end) const {
  const std::size_t count = points.size(), added = static_cast<std::size_t>(end == 0 ? grown_at_start : grown_at_end);
  double sum = 0;
  for (std::size_t k = 0; k < added; ++k) {
    const std::size_t from = end == 0 ? added - k : count - 1 - added + k, to = end == 0 ? from - 1 : from + 1;
    sum += (points[to] - points[from]).norm();
  }
  return sum;
}

void Scene::set_toughness(int region_id, std::vector<Point> places, std::vector<double> fracture_energies) {
  Region& region = mutable_region(region_id);
  require(material_of(region_id).fracture_energy > 0, "the material of region ", region_id,
          " has no fracture_energy, whose place the values take; give it one");
  region.set_fracture_energies(field_of(std::move(places), std::move(fracture_energies)));
}

}  // namespace bempd::scene
