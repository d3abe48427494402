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
#include "coupling/substructures.hpp"
#include "coupling/system_factor.hpp"
#include "coupling/unknowns.hpp"
#include "geometry/point.hpp"
#include "linalg/adjacency.hpp"

namespace bempd::coupling {

// Motion with little resistance: displacements (2 * node + component, the largest 1), and the energy that they need
// over that of the same displacements with the matrix's diagonal alone.
struct SoftMotion {
  Eigen::VectorXd motion;
  double resistance;
};

// View of a system with a factor. Its references into the system are valid as long as the system keeps this factor.
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

// Equilibrium of all nodes as one sparse system: dense operators, condensed onto the unknowns they share, terms and
// holding springs. The method that the operators name solves it. Nothing is condensed or factorized before the first
// solve().
class EquilibriumSystem {
 public:
  // Creates the system. Masters of tied nodes belong to dense operators; tied nodes carry terms only and cannot be
  // prescribed.
  EquilibriumSystem(int node_count, std::vector<DenseOperator> operators, Terms terms,
                    const std::vector<char>& prescribed_dofs, NodeTies ties = {});
  EquilibriumSystem(const EquilibriumSystem&) = delete;
  EquilibriumSystem& operator=(const EquilibriumSystem&) = delete;

  // Sets the positions of the nodes. A symmetric system derives from them an order of elimination with less fill.
  void place_nodes(const std::vector<Point>& positions);

  // Takes over what this system has in common with `before`, that of a scene with shorter cracks.
  void take_over(const EquilibriumSystem& before) {
    operators_.take_over(before.operators_);
    substructures_.take_over(before.substructures_);
  }

  // Makes the next factorization eliminate the unknowns of these nodes last, and drops the present factor.
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
  // Stiffness of every term in its present stage.
  const std::vector<double>& present_stiffness() const { return present_stiffness_; }
  // Whether there can be forces at zero displacement: by rest elongations or displacements, or closed exact
  // constraints.
  bool has_offsets() const {
    return terms_.have_offsets() || operators_.have_rest(0) || operators_.have_rest(1) ||
           constraints_.closed_exact_count() > 0;
  }
  // Stage change of a term that has reached the critical elongation of its present stage.
  StageChange after_critical(int term) const {
    return {term, terms_.law_of(static_cast<std::size_t>(term)).after_critical(stages_[term])};
  }
  // Critical elongation of a term in its present stage, as a share of the term's nominal critical elongation.
  double critical_share(int term) const {
    return terms_.law_of(static_cast<std::size_t>(term)).critical_share(stages_[term]);
  }
  double stiffness_after(const StageChange& change) const;
  // Completes `changes` with the breaks of all terms that follow broken ones; sorted by terms, each once.
  std::vector<StageChange> with_followers(std::vector<StageChange> changes) const;
  // Number of terms that the changes break, without those that merely follow others.
  std::int64_t count_broken(std::span<const StageChange> changes) const;
  const std::vector<HoldingSpring>& springs() const { return springs_; }

  // Sets the loads: forces on free degrees of freedom [N] and displacements of prescribed ones [m], 2 * node +
  // component.
  void set_load(Affine force, Affine prescribed);
  const AppliedLoad& load() const { return load_; }
  const Affine& force() const { return load_.force(); }
  const Affine& prescribed() const { return load_.prescribed(); }
  // Largest displacement that free swelling of terms and operators (by heat, for instance) would cause [m]: of the
  // proportional part; then |constant part| + |load factor * proportional part|.
  double rest_motion() const { return rest_motion_of(1); }
  double rest_motion(double load_factor) const { return rest_motion_of(0) + std::abs(load_factor) * rest_motion_of(1); }
  const NodeTies& ties() const { return ties_; }

  // Rest elongations and displacements, and their exchange with others of the same sizes; set_load() has to follow.
  Rests rests() const { return {terms_.rest_elongation, operators_.rests()}; }
  void exchange_rests(Rests& others) noexcept;
  const CondensedOperators& operators() const { return operators_; }

  // Changes the stages of terms in two calls, so that fragments can be found and held before the matrix loses their
  // resistance. mark() marks the terms; commit() changes the matrix and its factor (rank-one changes) and adds springs.
  void mark(std::span<const StageChange> changes);
  void commit(std::span<const StageChange> changes, std::span<const HoldingSpring> springs);

  // Unilateral constraints between crack faces (equilibrium_constraints.cpp). Operators number the exact ones, and
  // eliminate the closed ones of these. Closed ones with a penalty are a part of the matrix, the forces and the
  // energies.
  const Constraints& constraints() const { return constraints_; }
  void add_constraint(Constraint constraint) { constraints_.add(std::move(constraint)); }
  void replace_open_constraint(std::size_t number, Constraint other) { constraints_.replace(number, std::move(other)); }
  void bar_constraints(std::vector<char> barred, std::vector<char> exact = {}) {
    constraints_.bar(std::move(barred), std::move(exact));
  }
  // Closes those of the numbered constraints that are open and opens the closed ones. Penalties are rank-one changes of
  // the factor; if one of the constraints is exact, the next solve factorizes afresh.
  void switch_constraints(std::span<const int> numbers);
  // Replaces all constraints and the active set. If that changes the matrix, the next solve factorizes afresh.
  void set_constraints(Constraints constraints);
  // Replaces all constraints but not the factor, which then belongs to another matrix. Exact ones must stay the same.
  void put_constraints(Constraints constraints) { constraints_ = std::move(constraints); }

  // Gaps of all constraints. For a closed exact one it is the gap that it would have without its multiplier: negative
  // while its faces press.
  Affine gaps(const Affine& displacement) const;
  // Gap of an open constraint as a linear function of displacements: its weights, 2 * node + component, 0 at tied
  // nodes. The gap of an exact one has a constant offset besides, which loads inside its operator cause.
  Eigen::VectorXd gap_function(std::size_t number) const;
  void exchange_gap_offsets(Affine& others) noexcept { operators_.exchange_gap_offsets(others); }  // then set_load()

  // Puts terms into other stages without touching the factor, which then belongs to another matrix.
  void set_stages(std::span<const StageChange> changes);

  // Marks or commits the break of `terms` and of all terms that follow them.
  void mark_broken(std::span<const int> terms) { mark(all_broken(terms)); }
  void commit_break(std::span<const int> terms, std::span<const HoldingSpring> springs) {
    commit(all_broken(terms), springs);
  }

  // Replaces the stages of all terms and the holding springs; the next solve factorizes afresh.
  void restore(std::vector<std::uint8_t> stages, std::vector<HoldingSpring> springs);
  void forget_factor();
  void release_solver() { factor_.release(); }  // and a forgotten factor, to which nothing refers any more
  // Entries of the matrix that closed penalties have needed so far, told by nodes: rounding depends on this pattern.
  PlacesMet places_met() const { return places_met_ ? *places_met_ : PlacesMet(); }
  void set_places_met(PlacesMet places);
  void forget_places_met();
  // How the factor was made, empty without one; set_factor_origin() has it made so again when it is first needed.
  std::optional<FactorOrigin> factor_origin() const;
  void set_factor_origin(FactorOrigin origin);
  bool has_current_factor();
  // Whether the factor is a fresh one of the present matrix, not a changed one, with the unknowns of these nodes last.
  bool factor_keeps(const std::vector<int>& nodes);

  // Solves for the displacements in equilibrium. Throws Error (unsolvable) if some part of the body can move freely.
  Affine solve();

  // Condenses and factorizes where necessary. The system must be symmetric. Throws Error (unsolvable).
  FactorizedSystem factorized();

  // Condenses the operators if they are not yet condensed; forces and energies need it.
  void condense();

  // Whether every motion still meets resistance after the terms `broken` have broken; if not, softest_motion() finds
  // one that does not. The loss need not show in elongations under the present load.
  bool resists_all_motions(std::span<const int> broken);

  // Motions that nothing but these springs resists, with all constraints open. A motion need not belong to one spring.
  std::vector<Eigen::VectorXd> motions_held_by(std::span<const HoldingSpring> springs);

  // Motion with the least resistance: the free one, after solve() has failed or displacements have grown without bound.
  SoftMotion softest_motion();

  // Nodal forces of operators, terms and closed penalties (not of holding springs) at a displacement. The load factor
  // matters where rest elongations or rest displacements depend on it. Forces on tied nodes are moved to their masters.
  Eigen::VectorXd internal_force(const Eigen::VectorXd& displacement, double load_factor = 0) const;

  // Nodal forces of the numbered terms alone; forces on tied nodes are not moved to their masters.
  Eigen::VectorXd force_of_terms(std::span<const int> terms, const Eigen::VectorXd& displacement,
                                 double load_factor) const;

  // Energy of operators, terms and closed penalties at a displacement and a load factor; then its derivative by the
  // load factor at a fixed displacement, which the proportional parts of rest elongations and rest displacements cause.
  double energy(const Eigen::VectorXd& displacement, double load_factor = 0) const;
  double energy_slope(const Eigen::VectorXd& displacement, double load_factor) const;
  // Strain energy of the proportional part of a displacement, with the proportional parts of rest elongations.
  double unit_energy(const Eigen::VectorXd& proportional) const;

  // Largest stiffness of a single degree of freedom [N/m], with all terms in their first stage.
  double largest_stiffness() const { return largest_stiffness_; }

  bool is_symmetric() const { return method_.needs_symmetry(); }
  // Sums up the sparse matrix, of a symmetric system the lower triangle only; for factorization and tests.
  const Eigen::SparseMatrix<double>& assemble() const;

  const SolverCounters& counters() const { return counters_; }
  // Takes account of a reciprocal condition number that was found elsewhere: the least one is reported.
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
  // Displacements of all nodes from the unknowns; prescribed displacements are set to 0.
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
  Substructures substructures_;
};

}  // namespace bempd::coupling
