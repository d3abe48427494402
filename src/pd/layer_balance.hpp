#pragma once

#include "pd/bond_draft.hpp"

namespace bempd::pd {

// Changes the stiffnesses of free bonds so that their points have no missing moments and no stiffness is below `lower`
// times the kernel's. The sum of squares of the changes, relative to the kernel's values, is minimal. Returns false if
// no such stiffnesses were found. `surface` has the surface vectors of all points.
//
// With the `places` of all points, their Killing tensor fields are kept out of the multipliers. These are then found to
// more digits before they decide which stiffnesses are held at the bound. Long layers need this; it changes digits.
bool balance_layer(const std::vector<Point>& surface, double lower, int threads, DraftBonds& bonds,
                   const std::vector<Point>& places = {});

}  // namespace bempd::pd
