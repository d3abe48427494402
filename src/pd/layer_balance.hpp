#pragma once

#include "pd/bond_draft.hpp"

namespace bempd::pd {

// Changes the stiffnesses of free bonds so that their points have no missing third moments (missing_moments()) and no
// stiffness is below its lower bound, `lower` times the bond's bulk stiffness. The sum of squares of the changes,
// relative to the bulk stiffnesses, is minimal. Returns false if no such stiffnesses were found. `surface` has the
// surface vectors of all points.
//
// If the `places` of all points are given, the Lagrange multipliers are made orthogonal to the Killing tensor fields at
// these places. The multipliers are then computed to more digits before they decide which stiffnesses are held at their
// lower bound. Long layers need this; it changes the last digits of the stiffnesses.
bool balance_layer(const std::vector<Point>& surface, double lower, int threads, DraftBonds& bonds,
                   const std::vector<Point>& places = {});

}  // namespace bempd::pd
