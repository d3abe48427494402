#pragma once

#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/constraints.hpp"

namespace bempd::fracture {

// Rules by which contact constraints close and open, the same for whole bodies and for windows.

// Whether a gap is on the wrong side of zero by more than rounding: an opening at a closed constraint, or an overlap at
// an open one.
bool is_wrong(const coupling::Constraint& constraint, bool closed, double gap, double largest_displacement);

// Constraints whose status (closed or open) contradicts their gaps at a load factor, and barred constraints that are
// closed. If a gap is zero, its sign just ahead in `direction` (1 or -1) decides. With direction 0, a constraint with a
// penalty keeps its status at a zero gap, and an exact one is treated as if the load factor rises.
std::vector<int> wrong_constraints(const coupling::Constraints& constraints, const coupling::Affine& gaps,
                                   const coupling::Affine& displacement, double load_factor, double direction);

// Load factor between `from` and `to` at which the first constraint opens or closes; empty if none does.
std::optional<double> next_switch(const coupling::Constraints& constraints, const coupling::Affine& gaps,
                                  const coupling::Affine& displacement, double from, double to);

// Energy that a constraint with a penalty releases when it opens, or takes up (negative) when it closes, from its gaps
// before and after the switch. The potential energy is quadratic and least in equilibrium: if the penalty k is lost
// while the gap goes from g to g', the energy falls by k g g' / 2.
inline double released_by_switch(const coupling::Constraint& constraint, bool was_closed, double gap_before,
                                 double gap_after) {
  const double lost = (was_closed ? 1 : -1) * constraint.stiffness;
  return 0.5 * lost * gap_before * gap_after;
}

}  // namespace bempd::fracture
