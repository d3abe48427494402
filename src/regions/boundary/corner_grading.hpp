#pragma once

#include <vector>

#include "geometry/arc.hpp"

namespace bempd::regions {

// Boundary condition on a piece of a boundary.
enum class Held { nothing, one_component, both_components, interface };

struct BoundaryPiece {
  Arc arc;
  Held held;
};

struct SingularEnds {
  bool start = false, end = false;
};

// Ends of the pieces of one closed loop at which stress is singular in general: re-entrant corners, and places where a
// support ends unless it acts like a plane of symmetry (M. L. Williams, J. Appl. Mech. 19, 1952). Ends of interfaces
// are left out: the other body matters there, too.
std::vector<SingularEnds> singular_ends(const std::vector<BoundaryPiece>& loop);

// Element ends in which the elements at singular ends are divided repeatedly, ever closer to the end.
std::vector<double> refined_towards(const SingularEnds& singular, const std::vector<double>& stations);

}  // namespace bempd::regions
