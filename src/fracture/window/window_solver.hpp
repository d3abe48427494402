#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/window/dropped_dofs.hpp"
#include "fracture/window/flexibility.hpp"
#include "fracture/window/outside_stiffness.hpp"
#include "fracture/window/window_balance.hpp"
#include "fracture/window/window_rows.hpp"
#include "fracture/window/window_terms.hpp"

namespace bempd::fracture {

// Equilibrium of a window (region around crack tips or bonds close to breaking that is solved alone): terms between the
// window's nodes, and the flexibility F (displacements per force) of the whole body on these nodes. A term with the
// elongation e = b.u may lose the stiffness k, all of its stiffness or a part. F is then changed by a matrix of rank
// one (Sherman and Morrison 1950):
//   w = F b,  gamma = 1 - k b.w,  F <- F + (k / gamma) w w^T,  and the displacements u by (k e / gamma) w.
//
// Functions of the displacements are rows of F too, like displacements on which no force acts. Where nothing breaks any
// more, the window can stop following displacements; they are completed afterwards.
class WindowSolver {
 public:
  // Function of all displacements u: either x^T K u with the stiffness K, where x is nonzero on prescribed degrees of
  // freedom only (energies and reactions), or f^T u for loads f.
  struct Function {
    Eigen::VectorXd weights;  // f or K x, by degrees of freedom
    Eigen::VectorXd moved;    // x, or empty
  };

  WindowSolver(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
               const StretchRatios& ratios, const coupling::Affine& displacement,
               const std::vector<Function>& functions);

  // Whether a bond connects nodes of the window and was intact when the window was opened.
  bool contains(int global_bond) const { return terms_.contained(global_bond); }

  // Numbers in the system of the bonds that the window watches, ascending. Other functions of this class call a bond by
  // its position in this list, which narrow() changes.
  const std::vector<int>& bonds() const { return terms_.numbers(); }
  const std::vector<char>& intact() const { return terms_.intact(); }
  const AffineRatios& ratios() const { return terms_.ratios(); }

  // Stops following the displacements of the window's degrees of freedom with the flag `leaves`, and stops watching
  // bonds that end on them.
  void narrow(const std::vector<char>& leaves);
  int followed() const { return static_cast<int>(size()); }
  std::size_t breaks() const { return dropped_.breaks(); }

  // Displacements of all degrees of freedom of the window's nodes, followed or dropped.
  coupling::Affine displacement() const { return complete({state()}).front(); }
  // State with the displacements of the followed degrees of freedom only. complete() adds the dropped ones, for many
  // states together.
  DroppedDofs::State state() const;
  std::vector<coupling::Affine> complete(const std::vector<DroppedDofs::State>& states) const {
    return dropped_.complete(states, has_constant_part_);
  }
  const DroppedDofs& dropped() const { return dropped_; }

  // Present values that the window follows: displacements of its degrees of freedom, and values of the functions given
  // to the constructor (row k for function k). Gaps of constraints are computed from these displacements.
  const WindowRows& rows() const { return rows_; }

  bool ratio_is_known(int bond) const { return terms_.ratio_is_known(static_cast<std::size_t>(bond)); }

  double elongation(int bond, double load_factor) const {
    return rows_.elongation(terms_.pull(static_cast<std::size_t>(bond)), load_factor);
  }
  double stiffness_lost(const coupling::StageChange& change) const {
    return terms_.stiffness(static_cast<std::size_t>(change.term)) - terms_.stiffness_after(change);
  }

  // Changes the damage stages of terms, named by their positions in the list of bonds(). Returns false and changes
  // nothing if some motion would lose its resistance, or if a term would become stiffer.
  bool change(std::span<const coupling::StageChange> changes);

  // Contact constraint that closes or opens.
  struct Switch {
    const coupling::Constraint& constraint;
    bool closes;
  };
  // Closes or opens constraints. Returns false and changes nothing if some motion would lose its resistance.
  bool switch_constraints(std::span<const Switch> switches);

  // Unbalanced forces on the degrees of freedom of the window's nodes, due to rounding errors in the flexibility, for
  // the present damage stages of the terms in the system.
  coupling::Affine unbalanced() const;
  // Corrects the displacements by the response to the unbalanced forces `force`, from unbalanced(). The values of the
  // functions stay unchanged.
  void balance(coupling::Affine force);

  // Position of a term of the system in the list of bonds(); -1 if the window does not watch the term.
  int place_of(int global_term) const { return terms_.place_of(global_term); }

  // Stiffness of everything but the bonds of the window, on the degrees of freedom outside_dofs() that it touches.
  const Eigen::MatrixXd& outside_stiffness() const { return outside_.matrix; }
  const std::vector<int>& outside_dofs() const { return outside_.dofs; }  // places among the kept degrees of freedom

 private:
  Eigen::Index size() const { return flexibility_.size(); }
  void collect_functions(const coupling::Condensation& condensation, const std::vector<Function>& functions,
                         Eigen::Index dofs);
  void update_ratios() { terms_.update_ratios(rows_.values(), has_constant_part_); }
  // Loss of stiffness of a term or a constraint; negative for a gain.
  struct Loss {
    Pull pull;
    double stiffness;
  };
  bool lose(const std::vector<Loss>& losses);
  // Applies one loss of stiffness to the flexibility F and the displacements; false if a motion would lose its
  // resistance. `response` is F b for b of `loss.pull`, when only the first `changes_known` changes were pending.
  bool lose_one(const Loss& loss, Eigen::Ref<Eigen::VectorXd> response, Eigen::Index changes_known);
  void detach_functions(const Pull& pull, double stiffness, Eigen::Ref<Eigen::VectorXd> response);

  Eigen::Index kept_;       // number of kept degrees of freedom
  Eigen::Index functions_;  // number of functions
  WindowTerms terms_;
  WindowRows rows_;
  bool has_constant_part_;
  OutsideStiffness outside_;
  Flexibility flexibility_;
  WindowBalance balance_;
  std::vector<Eigen::VectorXd> moved_;  // Function::moved at the prescribed ends of bonds; or empty
  DroppedDofs dropped_;
};

}  // namespace bempd::fracture
