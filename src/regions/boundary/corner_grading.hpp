#pragma once

#include <functional>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "geometry/arc.hpp"

namespace bempd::regions {

// Displacement components that supports hold on a piece of a boundary; `interface` for a piece that borders on another
// region.
enum class HeldComponents { none, one, both, interface };

struct BoundaryPiece {
  Arc arc;
  HeldComponents held;
  int components = 0;      // components that supports hold: 1 x, 2 y, 3 both
  std::vector<int> loads;  // ids of the loads on the piece, ascending
};

// Number of times that the element at each end of a piece is divided towards the end; 0 where stress is regular.
struct EndDivisions {
  int start = 0, end = 0;
};

// Rule that gives the number of divisions of elements at the place where one piece ends and the next begins.
using DivisionRule = std::function<int(const BoundaryPiece& before, const BoundaryPiece& after)>;

// Usual number of divisions at the place where two pieces meet: five where stress is generally unbounded, else none.
// Stress is unbounded at re-entrant corners, and at ends of supports that do not act as planes of symmetry (M. L.
// Williams, J. Appl. Mech. 19, 1952). Ends of interfaces have none, because the singularity there depends on the other
// region, too.
int usual_divisions(const BoundaryPiece& before, const BoundaryPiece& after);

// Rule for the number of divisions at singular places (usual_divisions()) and where tractions may jump. There are so
// many divisions that the error of displacements at the place is less than `wanted`, relative to the largest
// displacement.
DivisionRule divisions_for(double wanted, const PlaneElasticity& elasticity);

// Divisions at the ends of the pieces of one closed loop.
std::vector<EndDivisions> end_divisions(const std::vector<BoundaryPiece>& loop, const DivisionRule& rule);

// Element ends of a piece (fractions of its length) after the elements at both ends of the piece have been divided
// towards these ends. Elements are divided only as often as they stay longer than the fraction `least`.
std::vector<double> graded_stations(const EndDivisions& divisions, const std::vector<double>& stations, double least);

}  // namespace bempd::regions
