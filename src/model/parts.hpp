#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd::model {

class Model;

// Reason for which a part of the model has elements or a lattice.
enum class PartReason {
  given = 1,  // the host added the region with its elements or lattice
  body = 2,   // elements of a body, which the library chose
  crack = 3   // lattice of a body, in which a crack is to run
};

// Part of the model: a region of the host, or a lattice patch that was cut out of a body.
struct Part {
  bool is_lattice = false;
  int body = 0, region = 0;  // ids of the host's region, and of the region that is this part
  PartReason reason = PartReason::given;
  int crack = 0;  // crack for which a lattice patch was laid; 0: none
  int horizon_ratio = 0;
  double spacing = 0;         // spacing of a lattice [m]
  std::int64_t elements = 0;  // boundary elements on edges and cracks, as far as they are planned
  std::int64_t points = 0;    // material points
  // Load factors at which the first crack of a patch grows: computed with the lattice (growth_load), and with boundary
  // elements in place of the patch (growth_load_of_elements). Infinite: no growth; NaN: unknown.
  double growth_load = std::numeric_limits<double>::quiet_NaN(), growth_load_of_elements = growth_load;
  Outline outline;
};

// Parts of the model: first the regions that the host has added, then the lattice patches that the library has laid in
// bodies. The model is planned or prepared if needed.
std::vector<Part> parts_of(Model& model);

// Loop of an outline as a polyline; arcs have a vertex at each step of a few degrees.
std::vector<Point> polyline_of(const Outline& outline, std::size_t loop);

}  // namespace bempd::model
