#pragma once

#include <memory>
#include <vector>

#include "geometry/scattered_field.hpp"

namespace bempd::pd {

// Fracture energy that varies with the place, relative to the fracture energy of the material.
struct VariedEnergy {
  std::shared_ptr<const ScatteredField> field;  // [J/m^2]; null if the fracture energy is the material's everywhere
  double of_material = 0;                       // [J/m^2]

  double share(const Point& place) const { return field ? field->at(place) / of_material : 1; }
  const VariedEnergy* if_any() const { return field ? this : nullptr; }
  // Fracture energy at places, relative to the material's; empty if it is the material's everywhere.
  std::vector<double> shares(const std::vector<Point>& places) const {
    std::vector<double> all;
    if (!field) return all;
    all.reserve(places.size());
    for (const Point& place : places) all.push_back(share(place));
    return all;
  }
};

}  // namespace bempd::pd
