#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "coupling/terms.hpp"

namespace bempd::coupling {

// Unilateral constraint: the gap between the two faces of a crack at one place must not become negative. A closed
// constraint presses the faces on each other, either by a penalty energy k/2 gap^2 or, if it is exact, by a multiplier
// (contact force) that makes the gap zero.
struct Constraint {
  static constexpr double exact = std::numeric_limits<double>::infinity();

  std::vector<TermEntry> pull;  // coefficients c of the gap c.u; empty if exact (the dense operator has them)
  double stiffness = exact;     // k of the penalty [N/m]
  bool operator==(const Constraint&) const = default;

  bool is_exact() const { return stiffness == exact; }
  // Gap c.u with the coefficients c of the constraint, where displacement(dof) returns the displacement u of degree of
  // freedom 2 * node + component.
  template <class Displacement>
  double gap_at(const Displacement& displacement) const {
    double sum = 0;
    for (const TermEntry& e : pull) sum += e.x * displacement(2 * e.node) + e.y * displacement(2 * e.node + 1);
    return sum;
  }
  double gap(const double* displacement) const {
    return gap_at([&](int dof) { return displacement[dof]; });
  }
  // Whether is_known(dof) holds for all degrees of freedom on which the gap depends; false for exact constraints.
  template <class IsKnown>
  bool is_on(const IsKnown& is_known) const {
    return !is_exact() && std::all_of(pull.begin(), pull.end(), [&](const TermEntry& e) {
      return is_known(2 * e.node) && is_known(2 * e.node + 1);
    });
  }
};

// All constraints of a body, and the active set: which of them are closed. Exact constraints come first and their
// number is fixed; constraints with a penalty follow as they are added. Where the gap is zero, the energy with a
// penalty has the same slope open and closed, so that the energy stays convex and equilibrium unique.
class Constraints {
 public:
  Constraints() = default;
  explicit Constraints(std::size_t exact_count)
      : list_(exact_count), closed_(exact_count, 0), exact_count_(exact_count) {}

  std::size_t size() const { return list_.size(); }
  std::size_t exact_count() const { return exact_count_; }
  const Constraint& operator[](std::size_t i) const { return list_[i]; }
  bool is_closed(std::size_t i) const { return closed_[i] != 0; }
  const std::vector<char>& closed() const { return closed_; }
  std::size_t closed_count() const { return closed_exact_ + closed_penalties_; }
  std::size_t closed_exact_count() const { return closed_exact_; }
  std::size_t closed_penalty_count() const { return closed_penalties_; }
  std::vector<char> closed_exact() const {
    return {closed_.begin(), closed_.begin() + static_cast<std::ptrdiff_t>(exact_count_)};
  }

  // Adds a constraint with a penalty, which is open at first.
  void add(Constraint constraint) {
    list_.push_back(std::move(constraint));
    closed_.push_back(0);
  }
  // Replaces constraint `i`, which has a penalty and is open.
  void replace(std::size_t i, Constraint constraint) { list_[i] = std::move(constraint); }
  void set_closed(std::size_t i, bool closed) {
    std::size_t& count = list_[i].is_exact() ? closed_exact_ : closed_penalties_;
    count += closed == (closed_[i] != 0) ? 0 : closed ? 1 : -1;
    closed_[i] = closed ? 1 : 0;
  }

  // Whether a constraint is barred from closing, because it would only push a loose fragment away.
  bool is_barred(std::size_t i) const {
    if (i < exact_count_) return i < barred_exact_.size() && barred_exact_[i] != 0;
    return i - exact_count_ < barred_.size() && barred_[i - exact_count_] != 0;
  }
  // Flags of the barred constraints with a penalty. Constraints beyond the end of the list are not barred.
  const std::vector<char>& barred() const { return barred_; }
  const std::vector<char>& barred_exact() const { return barred_exact_; }  // flags of the exact ones
  void bar(std::vector<char> barred, std::vector<char> exact) {
    barred_ = std::move(barred);
    barred_exact_ = std::move(exact);
  }

  // Calls visit(constraint) for all closed constraints that have a penalty.
  template <class Visit>
  void for_each_closed_penalty(const Visit& visit) const {
    if (closed_penalties_ == 0) return;
    for (std::size_t i = exact_count_; i < size(); ++i) {
      if (closed_[i]) visit(list_[i]);
    }
  }

  // Adds to `force` the forces k (c.u) c of the closed constraints with a penalty k and coefficients c, at the
  // displacements u; numbered 2 * node + component.
  void add_penalty_forces(const double* displacement, double* force) const {
    for_each_closed_penalty([&](const Constraint& constraint) {
      const double tension = constraint.stiffness * constraint.gap(displacement);
      for (const TermEntry& e : constraint.pull) {
        force[2 * e.node] += tension * e.x;
        force[2 * e.node + 1] += tension * e.y;
      }
    });
  }
  double penalty_energy(const double* displacement) const {
    double sum = 0;
    for_each_closed_penalty([&](const Constraint& constraint) {
      const double gap = constraint.gap(displacement);
      sum += 0.5 * constraint.stiffness * gap * gap;
    });
    return sum;
  }

 private:
  std::vector<Constraint> list_;
  std::vector<char> closed_, barred_, barred_exact_;
  std::size_t exact_count_ = 0, closed_exact_ = 0, closed_penalties_ = 0;
};

}  // namespace bempd::coupling
