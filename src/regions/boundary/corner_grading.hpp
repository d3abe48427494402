#pragma once

#include <functional>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "geometry/arc.hpp"

namespace bempd::regions {

// Displacement components that are held on a piece of a boundary.
enum class HeldComponents { none, one, both, interface };

struct BoundaryPiece {
  Arc arc;
  HeldComponents held;
  int components = 0;      // that are held: 1 x, 2 y, 3 both
  std::vector<int> loads;  // ids, ascending
};

// Number of times that the element at each end of a piece is divided towards the end; 0 where stress is regular.
struct EndDivisions {
  int start = 0, end = 0;
};

// Rule that gives the number of divisions of elements at the place where one piece ends and the next begins.
using DivisionRule = std::function<int(const BoundaryPiece& before, const BoundaryPiece& after)>;

// Usual number of divisions: five where stress is generally unbounded, which is at re-entrant corners and at ends of
// supports that do not act as planes of symmetry (M. L. Williams, J. Appl. Mech. 19, 1952), else none. Ends of
// interfaces have none, because their singularity depends on the other body too.
int usual_divisions(const BoundaryPiece& before, const BoundaryPiece& after);

// Divisions at these places, and where loads begin or end, that make the error of displacements at the place less
// than `wanted`, relative to the largest.
DivisionRule divisions_for(double wanted, const PlaneElasticity& elasticity);

// Divisions at the ends of the pieces of one closed loop.
std::vector<EndDivisions> end_divisions(const std::vector<BoundaryPiece>& loop, const DivisionRule& rule);

// Element ends `stations` (fractions of the piece) with the elements at the piece's ends divided towards them, as often
// as all elements stay longer than `least`, a fraction too.
std::vector<double> graded_stations(const EndDivisions& divisions, const std::vector<double>& stations, double least);

}  // namespace bempd::regions
