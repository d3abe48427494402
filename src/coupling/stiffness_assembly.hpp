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

// Entry of a pull, which is a sparse vector over the unknowns: an unknown and its coefficient.
struct UnknownEntry {
  int unknown;
  double weight;
};

// Appends the pull of a node, size * (cosine, sine), to `entries`; at a tied node, the pulls of its masters instead.
// Degrees of freedom that are no unknowns get no entry.
void append_pull(const std::vector<int>& unknown_of, const NodeTies& ties, int node, double cosine, double sine,
                 double size, std::vector<UnknownEntry>& entries);

// Sums terms, condensed operators and holding springs up to the sparse matrix of the unknowns. The places of all
// entries in the matrix are found once, so that each sum costs one pass over the terms.
class StiffnessAssembly {
 public:
  // Finds the pattern of the matrix. `unknown_of` gives the unknown of a degree of freedom, or -1. A symmetric matrix
  // has its lower triangle only. Every one of `constraints` gets entries between its nodes, also where no term needs
  // them.
  StiffnessAssembly(const std::vector<int>& unknown_of, const Terms& terms, const NodeTies& ties,
                    const std::vector<OperatorSchurComplement>& operators, bool symmetric,
                    const Constraints& constraints = {});

  // Sums the matrix with the present stiffness of every term. A broken term has the stiffness 0; its entries stay, so
  // that the pattern does not change. Closed ones of `constraints` are included; null: all are open, exact ones too.
  const Eigen::SparseMatrix<double>& sum(const std::vector<double>& stiffness,
                                         const std::vector<HoldingSpring>& springs, const Constraints* constraints);
  bool has_room_for(const Constraints& constraints) const;  // the closed ones

 private:
  // Calls visit(node, other) for every two nodes with common entries in the matrix; for some pairs several times.
  template <class Visit>
  void each_pair(const Constraints& constraints, const Visit& visit) const;
  // Nodes that have common entries with each node; if the matrix is symmetric, only those with larger numbers.
  linalg::Adjacency partners(const Constraints& constraints) const;
  void make_pattern(const Constraints& constraints);
  std::vector<int> nodes_pulled(std::size_t term) const;
  void add_node_pulled(int node, std::vector<int>& nodes) const;  // or its masters
  std::vector<UnknownEntry> pull_of(const Constraint& constraint) const;
  bool is_general(std::size_t term) const;
  int place(int row, int column) const;  // -1: in the triangle left out
  void add(int row, int column, double value);
  void find_places();
  void find_block(int row_node, int column_node, int* places) const;
  void add_general(std::size_t term, double stiffness);
  // Adds a wide term (one that is not a bond). Its part of the nodes' diagonal blocks goes to `diagonal`: xx, xy, yy.
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
  std::vector<int> bond_places_;  // of the four entries that couple its ends, -1 for none; twice as many if unsymmetric
  // Numbers of the terms whose entries in the matrix are looked up one by one at each assembly: those with a tied node,
  // and in unsymmetric systems those that are not bonds.
  std::vector<std::size_t> general_;
};

}  // namespace bempd::coupling
