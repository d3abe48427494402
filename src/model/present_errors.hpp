#pragma once

#include <vector>

#include "model/mesh_errors.hpp"
#include "results/point_values.hpp"

namespace bempd::model {

class Model;

// Errors of the present results, one for each source: lengths of boundary elements, and choice of the growth criterion.
struct ErrorSources {
  MeshErrors boundary;
  // Relative difference between the load factors of the next growth by the two growth criteria.
  double model = 0;
  bool has_lattices = false;
  double halving_seconds = 0, halving_bytes = 0;  // time [s] and memory for preparing with halved elements
};

// Errors of the present results at the present loads and cracks. To find them, the scene is solved with its elements
// merged in pairs and in fours or, if there are few elements, halved. Throws Error (order) once bonds have broken or a
// part has come off.
ErrorSources errors_now(Model& model);

// Magnitudes of the errors of displacements [m] and stresses [Pa] at places; NaN where they are not known.
struct PlaceErrors {
  std::vector<double> displacement, stress;
};

// Errors of the values at places in the body, from meshes as in errors_now(). The errors are unknown in lattices, and
// for stress also at places where stress is unbounded.
PlaceErrors errors_at(Model& model, const std::vector<Point>& places, const results::Side& side);

}  // namespace bempd::model
