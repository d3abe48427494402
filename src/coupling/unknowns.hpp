#pragma once

#include <vector>

#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "coupling/schur_complement.hpp"

namespace bempd::coupling {

// Kind of every degree of freedom (2 * node + component), and the numbering of those that are unknowns of the sparse
// system.
struct Unknowns {
  std::vector<DofKind> kind;
  std::vector<int> unknown_of;  // unknown of each degree of freedom, or -1
  std::vector<int> dof_of;      // degree of freedom of each unknown

  bool is_unknown(int dof) const { return unknown_of[dof] >= 0; }
  bool is_prescribed(int dof) const { return kind[dof] == DofKind::prescribed; }
  bool has_unknown(int node) const { return is_unknown(2 * node) || is_unknown(2 * node + 1); }
  Eigen::Index count() const { return static_cast<Eigen::Index>(dof_of.size()); }
};

Unknowns classify(int node_count, const std::vector<DenseOperator>& operators, const Terms& terms, const NodeTies& ties,
                  const std::vector<char>& prescribed);

}  // namespace bempd::coupling
