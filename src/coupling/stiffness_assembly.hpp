#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "coupling/constraints.hpp"
#include "coupling/node_ties.hpp"
#include "coupling/operator_schur_complement.hpp"
#include "coupling/operators.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::coupling {

// Entry of a pull: an unknown and its coefficient. A pull is a sparse vector of nodal forces by unit tension in a bond,
// constraint or spring.
struct UnknownEntry {
  int unknown;
  double weight;
};

// Appends to `entries` the pull of the force size * (cosine, sine) at a node; for a tied node, the pulls at its
// masters. Prescribed degrees of freedom and others that are no unknowns get no entry.
void append_pull(const std::vector<int>& unknown_of, const NodeTies& ties, int node, double cosine, double sine,
                 double size, std::vector<UnknownEntry>& entries);

// Sum of energy terms (bonds and cell squares), condensed operators and holding springs as a sparse matrix of the
// unknowns. The places of all entries in the matrix are found once, so that each sum costs one pass over the terms.
class StiffnessAssembly {
 public:
  // Finds the pattern of the matrix. `unknown_of` gives the unknown of a degree of freedom, or -1. Of a symmetric
  // matrix only the lower triangle is kept. Each of `constraints` gets entries between its nodes, even where no term
  // needs them.
  StiffnessAssembly(const std::vector<int>& unknown_of, const Terms& terms, const NodeTies& ties,
                    const std::vector<OperatorSchurComplement>& operators, bool symmetric,
                    const Constraints& constraints = {});

  // Sums the matrix with the present stiffness of every term. A broken term has the stiffness 0, but keeps its entries,
  // so that the pattern does not change. The closed constraints of `constraints` are included; null: all constraints,
  // exact ones too, count as open.
  const Eigen::SparseMatrix<double>& sum(const std::vector<double>& stiffness,
                                         const std::vector<HoldingSpring>& springs, const Constraints* constraints);
  bool has_room_for(const Constraints& constraints) const;  // for the closed ones

 private:
  // Calls visit(node, other) for every two nodes with common entries in the matrix, several times for some pairs.
  template <class Visit>
  void each_pair(const Constraints& constraints, const Visit& visit) const;
  // Nodes that have common entries with each node; if the matrix is symmetric, only those with larger numbers.
  linalg::Adjacency partners(const Constraints& constraints) const;
  void make_pattern(const Constraints& constraints);
  std::vector<int> nodes_pulled(std::size_t term) const;
  void add_node_pulled(int node, std::vector<int>& nodes) const;  // or its masters if it is tied
  std::vector<UnknownEntry> pull_of(const Constraint& constraint) const;
  bool is_general(std::size_t term) const;
  int place(int row, int column) const;  // -1: no unknown, or in the upper triangle of a symmetric matrix
  void add(int row, int column, double value);
  void find_places();
  void find_block(int row_node, int column_node, int* places) const;
  void add_general(std::size_t term, double stiffness);
  // Adds a wide term (cell square or other term that is not a bond). Its parts of the nodes' diagonal blocks are added
  // to `diagonal`, as xx, xy, yy.
  void add_wide(std::span<const TermEntry> entries, double stiffness, Eigen::Matrix3Xd& diagonal);
  void add_bonds(const std::vector<double>& stiffness);
  void add_operators(bool with_constraints);
  void add_springs(const std::vector<HoldingSpring>& springs);
  void add_penalties(const Constraints& constraints);

  const std::vector<int>& unknown_of_;
  const Terms& terms_;
  const NodeTies& ties_;
  const std::vector<OperatorSchurComplement>& operators_;
  bool symmetric_;
  Eigen::SparseMatrix<double> matrix_;
  std::vector<int> bond_places_;  // 4 entries per bond that couple its ends (8 if unsymmetric); -1: none
  // Numbers of the terms whose entries in the matrix are searched at each assembly: terms with a tied node, and in
  // unsymmetric systems wide terms.
  std::vector<std::size_t> general_;
};

}  // namespace bempd::coupling
