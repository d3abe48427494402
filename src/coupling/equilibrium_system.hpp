#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/applied_load.hpp"
#include "coupling/condensed_operators.hpp"
#include "coupling/constraints.hpp"
#include "coupling/factor_origin.hpp"
#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "coupling/solver_counters.hpp"
#include "coupling/stiffness_assembly.hpp"
#include "coupling/system_factor.hpp"
#include "coupling/unknowns.hpp"
#include "geometry/point.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::coupling {

// Motion (2 * node + component, largest component 1) and the energy that it needs, relative to the stiffest motions.
struct SoftMotion {
  Eigen::VectorXd motion;
  double resistance;
};

// System after its operators are condensed and its matrix is factorized. It has references into the system, valid as
// long as that keeps this factor.
struct FactorizedSystem {
  const linalg::SparseCholesky& cholesky;
  const std::vector<int>& dof_of;  // unknown -> dof
  int kept;                        // unknowns eliminated last
  const std::vector<OperatorSchurComplement>& operators;
  const NodeTies& ties;
  const Affine& prescribed;
  Affine right_hand_side;  // of the unknowns
  SolverCounters& counters;
};

// Equilibrium of all nodes: dense operators condensed onto the unknowns they share, terms, and holding springs, in one
// sparse system. The method that the operators name solves it. Nothing is condensed or factorized before the first
// solve().
class EquilibriumSystem {
 public:
  // Creates the system. Masters of tied nodes belong to dense operators; tied nodes carry terms only and cannot be
  // prescribed.
  EquilibriumSystem(int node_count, std::vector<DenseOperator> operators, Terms terms,
                    const std::vector<char>& prescribed_dofs, NodeTies ties = {});
  EquilibriumSystem(const EquilibriumSystem&) = delete;
  EquilibriumSystem& operator=(const EquilibriumSystem&) = delete;

  // Sets the positions of the nodes, from which an ordering of a symmetric system with less fill follows.
  void place_nodes(const std::vector<Point>& positions);

  // Makes the next factorization eliminate the unknowns of these nodes last.
  void keep_last(std::vector<int> nodes);
  bool keeps_last(const std::vector<int>& nodes) const { return factor_.kept_nodes() == nodes; }

  int node_count() const { return node_count_; }
  const Terms& terms() const { return terms_; }
  bool is_prescribed(int dof) const { return unknowns_.kind[dof] == DofKind::prescribed; }
  bool is_unknown(int dof) const { return unknowns_.is_unknown(dof); }
  bool in_dense_body(int node) const { return in_body_[node] != 0; }
  // Bodies that cannot break: the nodes of each dense operator, or of each piece of one, and those tied to them.
  const std::vector<std::vector<int>>& dense_bodies() const { return bodies_; }

  // Stage of every term in its law, and whether it is intact (not broken).
  const std::vector<std::uint8_t>& stages() const { return stages_; }
  const std::vector<char>& intact() const { return intact_; }
  // Stiffness of every term in its stage.
  const std::vector<double>& present_stiffness() const { return present_stiffness_; }
  // Whether terms or operators have forces without displacements.
  bool has_offsets() const {
    return terms_.have_offsets() || operators_.have_rest(0) || operators_.have_rest(1) ||
           constraints_.closed_exact_count() > 0;
  }
  // Stage change of a term that reaches the critical elongation of its stage.
  StageChange after_critical(int term) const {
    return {term, terms_.law_of(static_cast<std::size_t>(term)).after_critical(stages_[term])};
  }
  // Critical elongation of a term in its stage, as a share of its own critical elongation.
  double critical_share(int term) const {
    return terms_.law_of(static_cast<std::size_t>(term)).critical_share(stages_[term]);
  }
  double stiffness_after(const StageChange& change) const;
  // Changes together with the breaks of all terms that follow broken ones; by ascending terms, each once.
  std::vector<StageChange> with_followers(std::vector<StageChange> changes) const;
  // Number of terms that the changes break, without those that merely follow others.
  std::int64_t count_broken(std::span<const StageChange> changes) const;
  const std::vector<HoldingSpring>& springs() const { return springs_; }

  // Sets forces on free degrees of freedom [N] and displacements of prescribed ones [m], 2 * node + component.
  void set_load(Affine force, Affine prescribed);
  const AppliedLoad& load() const { return load_; }
  const Affine& force() const { return load_.force(); }
  const Affine& prescribed() const { return load_.prescribed(); }
  // Largest displacement that free swelling of terms and operators (heat, for instance) would cause [m]: of the
  // proportional part; and the sum of the magnitudes of both parts.
  double rest_motion() const { return rest_motion_of(1); }
  double rest_motion(double load_factor) const { return rest_motion_of(0) + std::abs(load_factor) * rest_motion_of(1); }
  const NodeTies& ties() const { return ties_; }

  // Rest elongations and displacements, and their exchange for as many others; set_load() has to follow.
  Rests rests() const { return {terms_.rest_elongation, operators_.rests()}; }
  void exchange_rests(Rests& others) noexcept;
  const CondensedOperators& operators() const { return operators_; }

  // Changes the stages of terms in two calls, so that fragments can be found in between and held before the matrix
  // loses their resistance: mark() marks the terms, commit() changes the matrix (rank-one changes of the factor, by the
  // drop of stiffness, where there is one) and adds springs.
  void mark(std::span<const StageChange> changes);
  void commit(std::span<const StageChange> changes, std::span<const HoldingSpring> springs);

  // Unilateral constraints between faces of cracks (equilibrium_constraints.cpp). Exact ones are numbered by operators,
  // which eliminate the closed ones; closed ones with a penalty are a part of the matrix, of forces and of energies.
  const Constraints& constraints() const { return constraints_; }
  void add_constraint(Constraint constraint) { constraints_.add(std::move(constraint)); }
  void replace_open_constraint(std::size_t number, Constraint other) { constraints_.replace(number, std::move(other)); }
  void bar_constraints(std::vector<char> barred, std::vector<char> exact = {}) {
    constraints_.bar(std::move(barred), std::move(exact));
  }
  // Closes open constraints and opens closed ones: rank-one changes of the factor for those with a penalty; the next
  // solve factorizes afresh if one of them is exact.
  void switch_constraints(std::span<const int> numbers);
  // Replaces all constraints with a penalty, and the active set; the next solve factorizes afresh if that changes the
  // matrix.
  void set_constraints(Constraints constraints);
  // Replaces them without touching the factor, which then belongs to another matrix; exact ones stay as they are.
  void put_constraints(Constraints constraints) { constraints_ = std::move(constraints); }

  // Gaps of all constraints. A closed exact one has the overlap that it would have without its multiplier, negative
  // while its faces press.
  Affine gaps(const Affine& displacement) const;
  // Weights of the gap of an open constraint as a function of displacements, 2 * node + component, none on tied nodes.
  // The gap of an exact one is this and its offset, which loads inside its operator cause.
  Eigen::VectorXd gap_function(std::size_t number) const;
  void exchange_gap_offsets(Affine& others) noexcept { operators_.exchange_gap_offsets(others); }  // then set_load()

  // Puts terms into other stages without touching the factor, which then belongs to another matrix.
  void set_stages(std::span<const StageChange> changes);

  // Marks or commits the break of terms at once, with those that follow them.
  void mark_broken(std::span<const int> terms) { mark(all_broken(terms)); }
  void commit_break(std::span<const int> terms, std::span<const HoldingSpring> springs) {
    commit(all_broken(terms), springs);
  }

  // Replaces the state; the next solve factorizes afresh.
  void restore(std::vector<std::uint8_t> stages, std::vector<HoldingSpring> springs);
  void forget_factor();
  // Entries of the matrix that closed penalties have needed so far: rounding depends on them.
  PlacesMet places_met() const { return places_met_ ? *places_met_ : PlacesMet(); }
  void set_places_met(PlacesMet places);
  void forget_places_met();
  // Record of how the factor was made, empty if there is none. A record that is set is used when a factor is needed
  // (equilibrium_factor.cpp).
  std::optional<FactorOrigin> factor_origin() const;
  void set_factor_origin(FactorOrigin origin);
  bool has_current_factor();
  // Whether the factor is that of the present matrix, with the unknowns of these nodes last.
  bool factor_keeps(const std::vector<int>& nodes);

  // Displacements in equilibrium. Throws Error (unsolvable) if something can move freely.
  Affine solve();

  // Condenses and factorizes if necessary. Throws Error (unsolvable). The method must be a symmetric one.
  FactorizedSystem factorized();

  // Condenses the operators once, as forces and energies need them.
  void condense();

  // Whether all motions keep their resistance after these terms break; if not, softest_motion() finds one. The loss
  // need not show in elongations under the present load.
  bool resists_all_motions(std::span<const int> broken);

  // Motions that only these springs resist while no faces press, whichever of the springs holds which motion.
  std::vector<Eigen::VectorXd> motions_held_by(std::span<const HoldingSpring> springs);

  // Motion with the least resistance: the one that is free, after solve() has failed or displacements have run away.
  SoftMotion softest_motion();

  // Nodal forces of operators and terms (not of holding springs) under a displacement at a load factor, which rest
  // elongations and rest displacements may depend on. Forces on tied nodes are counted at their
  // masters.
  Eigen::VectorXd internal_force(const Eigen::VectorXd& displacement, double load_factor = 0) const;

  // Nodal forces of some terms; tied nodes keep their forces.
  Eigen::VectorXd force_of_terms(std::span<const int> terms, const Eigen::VectorXd& displacement,
                                 double load_factor) const;

  // Energy of operators and terms at a displacement and a load factor; and its derivative by the load factor alone,
  // from the proportional parts of rest elongations and rest displacements.
  double energy(const Eigen::VectorXd& displacement, double load_factor = 0) const;
  double energy_slope(const Eigen::VectorXd& displacement, double load_factor) const;
  // Strain energy of the proportional parts of displacements and rest elongations.
  double unit_energy(const Eigen::VectorXd& proportional) const;

  // Largest stiffness of a single degree of freedom, with all terms in their first stage.
  double largest_stiffness() const { return largest_stiffness_; }

  bool is_symmetric() const { return method_.needs_symmetry(); }
  // Sparse matrix, of which a symmetric system has only the lower triangle; for factorization and tests.
  const Eigen::SparseMatrix<double>& assemble() const;

  const SolverCounters& counters() const { return counters_; }
  // Takes account of a reciprocal condition that is known from elsewhere.
  void note_condition(double reciprocal) {
    counters_.reciprocal_condition = std::min(counters_.reciprocal_condition, reciprocal);
  }

 private:
  void eliminate_exact_constraints();
  void collect_bodies(const std::vector<DenseOperator>& operators);
  void measure_rests_of_terms() noexcept;
  double rest_motion_of(int part) const { return std::max(rest_of_terms_[part], operators_.rest_motion(part)); }
  void collect_followers();
  void condense_load();
  void factorize();
  void rebuild_factor();
  std::unique_ptr<StiffnessAssembly> assembly_with(const PlacesMet* places) const;
  const Eigen::SparseMatrix<double>& assemble_to_factorize();
  bool has_load(int part) const;

  std::vector<StageChange> all_broken(std::span<const int> terms) const;
  void enter(const StageChange& change);
  void add_pulls(int term, double size, int column, std::vector<Eigen::Triplet<double>>& entries) const;
  void change_factor(const std::vector<Eigen::Triplet<double>>& entries, int columns, linalg::Change change);

  Affine right_hand_side() const;
  void add_supports(const Affine& support, Affine& load) const;
  void add_offsets(Affine& load) const;
  void add_supports_of_penalties(const Affine& support, Affine& load) const;
  Eigen::VectorXd apply(const Eigen::VectorXd& unknowns) const;
  Eigen::VectorXd solve_column(const Eigen::VectorXd& rhs);
  // Displacements of all nodes from the unknowns, with prescribed ones at 0.
  Eigen::VectorXd displacement_of(const Eigen::VectorXd& unknowns) const;

  int node_count_;
  double largest_stiffness_ = 0, stiffness_ratio_ = 1;  // of single degrees of freedom
  const SolutionMethod& method_;
  double rest_of_terms_[2] = {0, 0};  // largest rest elongation in each part
  CondensedOperators operators_;
  std::vector<std::vector<int>> bodies_;
  std::vector<char> in_body_;  // per node
  Terms terms_;
  linalg::Adjacency followers_of_;  // of every term; empty if none follows
  NodeTies ties_;
  std::vector<std::uint8_t> stages_;
  std::vector<char> intact_;
  std::vector<double> present_stiffness_;
  std::vector<HoldingSpring> springs_;
  Constraints constraints_;
  Unknowns unknowns_;
  AppliedLoad load_;
  mutable std::unique_ptr<StiffnessAssembly> assembly_;  // once condensed
  mutable std::shared_ptr<const PlacesMet> places_met_;  // null: none
  SolverCounters counters_;
  SystemFactor factor_;
  FactorSource source_;
};

}  // namespace bempd::coupling
