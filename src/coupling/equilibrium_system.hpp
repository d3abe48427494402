#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/condensed_operator.hpp"
#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "coupling/stiffness_assembly.hpp"
#include "geometry/point.hpp"
#include "linalg/nested_dissection.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace bempd::coupling {

struct SolverCounters {
  std::int64_t sparse_unknowns = 0;
  std::int64_t factor_nonzeros = 0;
  std::int64_t dense_factorizations = 0;
  std::int64_t sparse_factorizations = 0;
  std::int64_t factor_updates = 0;
  std::int64_t solves = 0;
  std::int64_t iterations = 0;
  double reciprocal_condition = 1;  // smallest of all factorizations, a crude estimate
  double seconds_assembly = 0;
  double seconds_factorization = 0;
  double seconds_solve = 0;
  double seconds_update = 0;
};

// A motion (2 * node + component, largest component 1) and the energy it needs, relative to the stiffest motions.
struct SoftMotion {
  Eigen::VectorXd motion;
  double resistance;
};

// Equilibrium of all nodes: dense operators condensed onto the unknowns they share, bonds, and holding springs, in one
// sparse system: symmetric positive definite (Cholesky factor, conjugate gradients) unless an operator is unsymmetric
// (LU factor, GMRES). Nothing is condensed or factorized before the first solve().
class EquilibriumSystem {
 public:
  // Masters of tied nodes belong to dense operators; tied nodes carry bonds only and cannot be prescribed.
  EquilibriumSystem(int node_count, std::vector<DenseOperator> operators, BondSet bonds,
                    std::vector<char> prescribed_dofs, NodeTies ties = {});

  // Where the nodes are: an ordering of a symmetric system with less fill follows from it.
  void place_nodes(const std::vector<Point>& positions);

  // The unknowns of these nodes are eliminated last, from the next factorization on.
  void keep_last(std::vector<int> nodes);

  int node_count() const { return node_count_; }
  const BondSet& bonds() const { return bonds_; }
  bool is_prescribed(int dof) const { return kind_[dof] == DofKind::prescribed; }
  bool is_unknown(int dof) const { return unknown_of_[dof] >= 0; }
  bool in_dense_body(int node) const { return in_body_[node] != 0; }
  // Nodes of each dense operator and those tied to them: a body that cannot break.
  const std::vector<std::vector<int>>& dense_bodies() const { return bodies_; }

  const std::vector<char>& intact() const { return intact_; }
  const std::vector<HoldingSpring>& springs() const { return springs_; }

  // Forces on free degrees of freedom [N] and displacements of prescribed ones [m], 2 * node + component.
  void set_load(Affine force, Affine prescribed);
  const Affine& force() const { return force_; }
  const Affine& prescribed() const { return prescribed_; }
  const NodeTies& ties() const { return ties_; }

  // Breaking takes two calls, so that the parts it frees can be found in between and held before the matrix loses
  // their resistance: mark the bonds, then change the matrix (rank-one changes of the factor where there is one).
  void mark_broken(std::span<const int> bonds);
  void commit_break(std::span<const int> bonds, std::span<const HoldingSpring> springs);

  // Takes bonds out or puts them back without touching the factor, which then belongs to another matrix.
  void set_parted(std::span<const int> bonds, bool parted);

  // Replaces the state; the next solve factorizes afresh.
  void restore(std::vector<char> intact, std::vector<HoldingSpring> springs);
  void forget_factor();

  // True if the factor is that of the present matrix, with these nodes' unknowns last.
  bool factor_keeps(const std::vector<int>& nodes) const;

  // Throws Error (unsolvable) if something can move freely.
  Affine solve();

  // False if some motion may have lost its resistance with these bonds, without showing in their elongations under the
  // present load; softest_motion() tells.
  bool resists_all_motions(std::span<const int> broken);

  // The motion that meets the least resistance: what moves freely, after solve() has failed or run away.
  SoftMotion softest_motion();

  // Nodal forces of operators and bonds (not of holding springs) under a displacement. Those on tied nodes are counted
  // at their masters.
  Eigen::VectorXd internal_force(const Eigen::VectorXd& displacement) const;

  bool is_symmetric() const { return symmetric_; }
  // The sparse matrix, of which a symmetric system gives the lower triangle; for factorization and tests.
  const Eigen::SparseMatrix<double>& assemble() const;

  const SolverCounters& counters() const { return counters_; }

 private:
  friend class Condensation;

  void classify(const std::vector<DenseOperator>& operators, const std::vector<char>& prescribed_dofs);
  void collect_bodies(const std::vector<DenseOperator>& operators);
  void condense();
  void condense_load();
  bool has_unknown(int node) const { return is_unknown(2 * node) || is_unknown(2 * node + 1); }
  void choose_order();
  void factorize();
  Affine right_hand_side() const;
  Eigen::VectorXd apply(const Eigen::VectorXd& unknowns) const;
  Eigen::VectorXd solve_column(const Eigen::VectorXd& rhs);
  void add_bond_forces(const Eigen::VectorXd& displacement, Eigen::VectorXd& force) const;
  void change_factor(const std::vector<Eigen::Triplet<double>>& entries, int columns, linalg::Change change);
  // A pull of this size along a direction at a node as entries of a column of unknowns.
  void add_pull(int node, double cosine, double sine, double size, int column,
                std::vector<Eigen::Triplet<double>>& entries) const;
  // All nodes' displacements from the unknowns, prescribed ones at 0.
  Eigen::VectorXd displacement_of(const Eigen::VectorXd& unknowns) const;

  std::unique_ptr<linalg::SparseFactorization> make_factorization() const;
  const linalg::SparseCholesky& cholesky() const { return static_cast<const linalg::SparseCholesky&>(*factor_); }

  int node_count_;
  bool symmetric_ = true;
  std::vector<DenseOperator> pending_;  // until condensed
  std::vector<CondensedOperator> operators_;
  std::vector<std::vector<int>> bodies_;
  std::vector<char> in_body_;  // per node
  BondSet bonds_;
  NodeTies ties_;
  std::vector<double> active_stiffness_;  // 0 for a bond that is not intact
  std::vector<char> intact_;
  std::vector<HoldingSpring> springs_;
  std::vector<DofKind> kind_;
  std::vector<int> unknown_of_;  // dof -> unknown of the sparse system, or -1
  std::vector<int> dof_of_;      // unknown -> dof
  Affine force_, prescribed_, condensed_load_;
  bool load_condensed_ = false;
  bool condensed_ = false;
  mutable std::unique_ptr<StiffnessAssembly> assembly_;  // once condensed
  std::unique_ptr<linalg::NodeGraph> graph_;
  std::vector<int> kept_nodes_;
  int kept_ = 0;  // their unknowns
  std::unique_ptr<linalg::SparseFactorization> factor_;
  double largest_diagonal_ = 0;  // of the matrix last factorized
  bool has_factor_ = false;
  bool factor_is_current_ = false;    // false: changed matrix, stale factor
  bool factor_is_untouched_ = false;  // by low-rank changes
  SolverCounters counters_;
};

}  // namespace bempd::coupling
