#pragma once

#include <vector>

#include "model/mesh_errors.hpp"
#include "results/point_values.hpp"

namespace bempd::model {

class Model;

// Errors of the present results by source.
struct ErrorSources {
  MeshErrors boundary;
  double model = 0;  // difference of the next load of growth between the growth criteria
  bool has_lattices = false;
  double halving_seconds = 0, halving_bytes = 0;  // of preparing with half as long elements
};

// Errors at the present loads and cracks, for which the scene is solved with its elements merged in pairs and fours, or
// halved where there are few. Throws Error (order) once bonds have broken or a part has come off.
ErrorSources errors_now(Model& model);

// Magnitudes of the errors of displacements [m] and stresses [Pa] at places; NaN where they are not known.
struct PlaceErrors {
  std::vector<double> displacement, stress;
};

// Errors of the values at places in the body, from meshes as in errors_now(). They are unknown in lattices, and for
// stress also where it is unbounded.
PlaceErrors errors_at(Model& model, const std::vector<Point>& places, const results::Side& side);

}  // namespace bempd::model
