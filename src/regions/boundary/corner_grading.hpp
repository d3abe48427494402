#pragma once

#include <vector>

#include "geometry/arc.hpp"

namespace bempd::regions {

// Displacement components that are held on a piece of a boundary.
enum class Held { nothing, one_component, both_components, interface };

struct BoundaryPiece {
  Arc arc;
  Held held;
};

inline constexpr int usual_grading = 5;

struct SingularEnds {
  bool start = false, end = false;
};

// Ends of the pieces of one closed loop at which stress is generally singular: re-entrant corners, and ends of supports
// that do not act as planes of symmetry (M. L. Williams, J. Appl. Mech. 19, 1952). Ends of interfaces are left out,
// because their singularity depends on the other body too.
std::vector<SingularEnds> singular_ends(const std::vector<BoundaryPiece>& loop);

// Element ends `stations` (fractions of the piece) with the elements at singular ends divided repeatedly towards these
// ends, `levels` times.
std::vector<double> refined_towards(const SingularEnds& singular, const std::vector<double>& stations,
                                    int levels = usual_grading);
// Number of divisions after which the error of displacements due to a singular end is below `wanted`, relative to the
// largest.
int grading_for(double wanted);

}  // namespace bempd::regions
