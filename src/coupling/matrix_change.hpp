#pragma once

#include <Eigen/SparseCore>
#include <cmath>
#include <vector>

#include "coupling/operators.hpp"
#include "coupling/stiffness_assembly.hpp"
#include "coupling/terms.hpp"
#include "coupling/unknowns.hpp"

namespace bempd::coupling {

// Change of a system's matrix by stiffnesses that are added or removed. Each stiffness is a column c over the unknowns:
// the matrix gains or loses c c^T.
class MatrixChange {
 public:
  struct Columns {
    std::vector<Eigen::Triplet<double>> entries;
    int count = 0;
  };

  MatrixChange(const Unknowns& unknowns, const NodeTies& ties) : unknowns_(unknowns), ties_(ties) {}

  void add_spring(const HoldingSpring& spring) {
    pull_.clear();
    append(spring.node, spring.cosine, spring.sine, std::sqrt(spring.stiffness));
    put_into(added_);
  }
  // Adds a stiffness of an energy term (bond or cell square) to the matrix; a negative stiffness is removed.
  void add_term(const Terms& terms, int term, double stiffness) {
    const double size = std::sqrt(std::abs(stiffness));
    pull_.clear();
    terms.for_each_entry(static_cast<std::size_t>(term),
                         [&](int node, double x, double y) { append(node, x, y, size); });
    put_into(stiffness > 0 ? added_ : removed_);
  }
  // Adds the penalty of a constraint to the matrix if the constraint closes, else removes the penalty.
  void switch_penalty(const Constraint& constraint, bool closes) {
    pull_.clear();
    for (const TermEntry& e : constraint.pull) append(e.node, e.x, e.y, std::sqrt(constraint.stiffness));
    put_into(closes ? added_ : removed_);
  }

  const Columns& added() const { return added_; }
  const Columns& removed() const { return removed_; }
  int column_count() const { return added_.count + removed_.count; }

 private:
  void append(int node, double x, double y, double size) {
    append_pull(unknowns_.unknown_of, ties_, node, x, y, size, pull_);
  }
  void put_into(Columns& columns) {
    for (const UnknownEntry& e : pull_) columns.entries.emplace_back(e.unknown, columns.count, e.weight);
    ++columns.count;
  }

  const Unknowns& unknowns_;
  const NodeTies& ties_;
  Columns added_, removed_;
  std::vector<UnknownEntry> pull_;
};

}  // namespace bempd::coupling
