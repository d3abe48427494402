#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/contact/face_state.hpp"
#include "fracture/line/growing_tip.hpp"
#include "fracture/stepping_options.hpp"
#include "fracture/window/window_zones.hpp"

namespace bempd::fracture {

// Location of the present window or of the last one.
struct WindowLocation {
  std::vector<Zone> zones;
  std::vector<int> nodes;
  bool are_last = false;  // these nodes are eliminated last
};

// Options that determine how a window computes.
struct WindowOptions {
  double tie_band = 0;
  int max_breaks_per_solve = 0;
  double ahead = 0;  // of a crack tip, in lattice spacings; 0: chosen by the size of the system
  Control control = Control::load;
  bool operator==(const WindowOptions&) const = default;
};

// Origin of an open window: what it was opened with, and when it computed events ahead. The terms' stages at that time
// are those in the system's factor.
struct WindowOrigin {
  WindowOptions options;
  double load_factor = 0;
  coupling::Affine displacement{0, 2};
  std::vector<GrowingTip> tips;    // when the window was opened
  std::optional<FaceState> faces;  // when it was opened, if places have closed or opened in the window since
  // Occasion on which the window computed events ahead.
  struct Computation {
    std::int64_t after = 0;  // number of the window's events performed before
    double load_factor = 0, largest_force = 0;
  };
  std::vector<Computation> computations;
  std::int64_t events_performed = 0;
  bool is_out_of_date = false;  // the displacements were not asked for by the run itself
  // What closing the window does to the system's factor: it is dropped if terms have changed, and its order of
  // elimination, too, if an event needs the whole body because a motion may come free.
  bool has_changed_terms = false, needs_whole_body = false;
};

}  // namespace bempd::fracture
