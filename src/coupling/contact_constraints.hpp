#pragma once

#include <span>
#include <utility>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/repeatable_factor.hpp"
#include "coupling/system_parts.hpp"

namespace bempd::coupling {

// Changes of a system's unilateral constraints between crack faces, and their gaps. Operators number the exact ones,
// and eliminate the closed ones of these. Closed ones with a penalty are a part of the matrix, the forces and the
// energies.
class ContactConstraints {
 public:
  ContactConstraints(SystemParts& parts, RepeatableFactor& factor) : parts_(parts), factor_(factor) {}

  void add(Constraint constraint) { parts_.constraints.add(std::move(constraint)); }
  void replace_open(std::size_t number, Constraint other) { parts_.constraints.replace(number, std::move(other)); }
  void bar(std::vector<char> barred, std::vector<char> exact = {}) {
    parts_.constraints.bar(std::move(barred), std::move(exact));
  }
  // Closes those of the numbered constraints that are open and opens the closed ones. Penalties are rank-one changes of
  // the factor; if one of the constraints is exact, the next solve factorizes afresh.
  void switch_over(std::span<const int> numbers);
  // Replaces all constraints and the active set. If that changes the matrix, the next solve factorizes afresh.
  void set(Constraints constraints);
  // Replaces all constraints, of which the exact ones must stay the same. The factor is left as it is, so that it
  // belongs to another matrix than the present one: for callers that do not solve with it, as while a window is open.
  void set_without_factor(Constraints constraints) { parts_.constraints = std::move(constraints); }
  void exchange_gap_offsets(Affine& others) noexcept {  // a system's set_load() has to follow
    parts_.operators.exchange_gap_offsets(others);
  }

  // Gaps of all constraints. For a closed exact one, which a multiplier closes and not a penalty, it is the gap that it
  // would have without this multiplier: negative while its faces press.
  Affine gaps(const Affine& displacement) const;
  // Gap of an open constraint as a linear function of displacements: its weights, 2 * node + component, 0 at tied
  // nodes. The gap of an exact one has a constant offset besides, which loads inside its operator cause.
  Eigen::VectorXd gap_function(std::size_t number) const;

 private:
  void eliminate_exact_ones();

  SystemParts& parts_;
  RepeatableFactor& factor_;
};

}  // namespace bempd::coupling
