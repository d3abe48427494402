#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/contact/face_state.hpp"
#include "fracture/line/growing_tip.hpp"
#include "fracture/load_way.hpp"
#include "fracture/window/window_zones.hpp"

namespace bempd::fracture {

// Location of the open window (region around crack tips or bonds close to breaking that is solved alone) or, if none is
// open, of the last window.
struct WindowLocation {
  std::vector<Zone> zones;
  std::vector<int> nodes;
  bool are_last = false;  // the system eliminates these nodes last
};

// Options that determine which events a window computes, and its size.
struct WindowOptions {
  double tie_band = 0;
  int max_breaks_per_solve = 0;
  double ahead = 0;  // length ahead of a crack tip [lattice spacings]; 0: chosen by the size of the system
  Control control = Control::load;
  bool operator==(const WindowOptions&) const = default;
};

// Origin of an open window: the data with which it was opened, and the calls in which it computed events ahead. The
// damage stages that the terms had at the opening are saved with the system's factor (coupling::FactorOrigin).
struct WindowOrigin {
  WindowOptions options;
  double load_factor = 0;
  coupling::Affine displacement{0, 2};
  std::vector<GrowingTip> tips;    // tips of crack lines when the window was opened
  std::optional<FaceState> faces;  // contact state when it was opened, if the window has closed or opened places since
  // Call in which the window computed events ahead: its starting point in the run.
  struct Computation {
    std::int64_t after = 0;  // number of the window's events performed before
    double load_factor = 0, largest_force = 0;
  };
  std::vector<Computation> computations;
  std::int64_t events_performed = 0;
  bool is_out_of_date = false;  // the run itself has not brought the displacements up to date
  // Flags for the closing of the window: the system's factor is dropped if terms have changed (`has_changed_terms`),
  // and its order of elimination is dropped if the next event needs the whole body because a motion may come free
  // (`needs_whole_body`).
  bool has_changed_terms = false, needs_whole_body = false;
};

}  // namespace bempd::fracture
