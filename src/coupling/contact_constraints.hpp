#pragma once

#include <span>
#include <utility>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/repeatable_factor.hpp"
#include "coupling/system_parts.hpp"

namespace bempd::coupling {

// Changes of a system's unilateral constraints between crack faces, and their gaps. Exact constraints belong to dense
// operators, which number them and eliminate the closed ones. Closed constraints with a penalty are a part of the
// matrix, the forces and the energies.
class ContactConstraints {
 public:
  ContactConstraints(SystemParts& parts, RepeatableFactor& factor) : parts_(parts), factor_(factor) {}

  void add(Constraint constraint) { parts_.constraints.add(std::move(constraint)); }
  void replace_open(std::size_t number, Constraint other) { parts_.constraints.replace(number, std::move(other)); }
  void bar(std::vector<char> barred, std::vector<char> exact = {}) {
    parts_.constraints.bar(std::move(barred), std::move(exact));
  }
  // Switches the constraints with these numbers: closes the open ones and opens the closed ones. Penalties are rank-one
  // changes of the factor; if an exact constraint is switched, the next solve factorizes again.
  void switch_over(std::span<const int> numbers);
  // Replaces all constraints and the active set. If this changes the matrix, the next solve factorizes again.
  void set(Constraints constraints);
  // Replaces all constraints; the exact ones must be unchanged. The factor is left as it is and then belongs to another
  // matrix, which suits callers that do not solve with it, as while a window (region around the tips that is solved
  // alone) is in use.
  void set_without_factor(Constraints constraints) { parts_.constraints = std::move(constraints); }
  void exchange_gap_offsets(Affine& others) noexcept {  // a system's set_load() has to follow
    parts_.operators.exchange_gap_offsets(others);
  }

  // Gaps of all constraints. A closed exact constraint gets the gap that it would have without its multiplier, which is
  // negative while its faces press.
  Affine gaps(const Affine& displacement) const;
  // Weights of the displacements (2 * node + component) in the gap of an open constraint, 0 at tied nodes. The gap of
  // an exact constraint has an offset besides, which loads inside its operator cause.
  Eigen::VectorXd gap_function(std::size_t number) const;

 private:
  void eliminate_exact_ones();

  SystemParts& parts_;
  RepeatableFactor& factor_;
};

}  // namespace bempd::coupling
