#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/outline.hpp"

namespace bempd::model {

class Model;

// Why a part of the model is as it is.
enum class PartReason {
  given = 1,  // the host has added it with its elements or its lattice
  body = 2,   // elements of a body, which the library has chosen
  crack = 3   // a crack of the body was to run in a lattice
};

// Part of the model: a region of the host, or a patch that was cut out of a body.
struct Part {
  bool is_lattice = false;
  int body = 0, region = 0;  // ids: of the region that the host has added, and for requests
  PartReason reason = PartReason::given;
  int crack = 0;  // for which a patch was laid
  int horizon_ratio = 0;
  double spacing = 0;         // of a lattice [m]
  std::int64_t elements = 0;  // boundary elements on its edges and cracks, so far as it is planned
  std::int64_t points = 0;    // material points
  // Load factors at which the cracks of a patch first grow, by its lattice and by elements alone. Infinite: they do not
  // grow; NaN: not known.
  double growth_load = std::numeric_limits<double>::quiet_NaN(), growth_load_of_elements = growth_load;
  Outline outline;
};

// Parts of the model, which is planned or prepared if needed; regions of the host come first.
std::vector<Part> parts_of(Model& model);

// Loop of an outline as a polyline; arcs have a vertex at each step of a few degrees.
std::vector<Point> polyline_of(const Outline& outline, std::size_t loop);

}  // namespace bempd::model
