#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/window/left_behind.hpp"

namespace bempd::fracture {

// Bonds between kept nodes and the flexibility F (displacements per force) of the whole body there. Breaking a bond of
// stiffness k along b changes F by a matrix of rank one: w = F b, gamma = 1 - k b.w, F <- F + (k / gamma) w w^T, and
// the displacements by (k e / gamma) w, e being the bond's elongation (Sherman and Morrison 1950). The change of F is
// collected and added to it many columns at a time.
//
// Functions of the displacements are carried along like displacements on which no force acts: rows of F. Where nothing
// breaks any more, the window can stop following displacements from event to event; they are found afterwards.
class ActiveWindow {
 public:
  // A function of all displacements u -> x^T K u, x being nonzero on prescribed degrees of freedom only (energies and
  // reactions), or u -> f^T u with loads f.
  struct Function {
    Eigen::VectorXd weights;  // of degrees of freedom
    Eigen::VectorXd moved;    // x, or empty
  };

  ActiveWindow(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
               const StretchRatios& ratios, const coupling::Affine& displacement,
               const std::vector<Function>& functions);

  // Whether this bond is between kept nodes, and was intact when the window was opened.
  bool contains(int global_bond) const { return contained_[global_bond] != 0; }

  // Global numbers of the bonds watched, ascending; bonds are named by their place in this list below, which narrow()
  // changes.
  const std::vector<int>& bonds() const { return bonds_; }
  const std::vector<char>& intact() const { return intact_; }
  const AffineRatios& ratios() const { return ratios_; }

  // No longer follows the displacements of kept degrees of freedom that are marked, nor watches bonds that end on them.
  void narrow(const std::vector<char>& leaves);
  int followed() const { return static_cast<int>(size_); }
  std::size_t breaks() const { return left_behind_.breaks(); }

  // Displacements of the kept degrees of freedom: at once, or those that are followed now and all of many states later.
  coupling::Affine displacement() const { return complete({state()}).front(); }
  LeftBehind::State state() const;
  std::vector<coupling::Affine> complete(const std::vector<LeftBehind::State>& states) const {
    return left_behind_.complete(states, has_constant_part_);
  }
  const LeftBehind& left_behind() const { return left_behind_; }

  // Row k: value of the function k for the constant and the proportional part of the load.
  Eigen::Matrix<double, Eigen::Dynamic, 2> function_values() const { return extended_.middleRows(size_, functions_); }

  double elongation(int bond, double load_factor) const;
  double stiffness(int bond) const { return stiffness_[bond]; }

  // False, and nothing changed, if some motion would lose its resistance with these bonds.
  bool remove(std::span<const int> bonds);

  // The stiffness of all that is not a bond of the window, on those kept degrees of freedom that it touches.
  const Eigen::MatrixXd& outside_stiffness() const { return outside_; }
  const std::vector<int>& outside_dofs() const { return outside_dofs_; }  // places among the kept ones

 private:
  struct Pull {
    std::array<int, 4> dof;  // rows of extended_
    std::array<double, 4> weight;
  };

  void collect_bonds(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                     const StretchRatios& ratios);
  void find_outside(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation);
  void collect_functions(const coupling::Condensation& condensation, const std::vector<Function>& functions,
                         Eigen::Index dofs);
  bool is_prescribed(int row) const { return row >= size_; }
  bool is_supported(int bond) const;
  LeftBehind::Form form(const Pull& pull, double x, double y) const;
  Eigen::MatrixXd response_of(const std::vector<int>& left, const std::vector<int>& stay) const;
  void keep_rows(const std::vector<int>& stay);
  void keep_bonds(const std::vector<char>& watched);
  void update_ratios();
  Eigen::MatrixXd responses(std::span<const int> bonds) const;  // F b
  void flush();
  // `response` is F b as it was when only this many changes were pending.
  bool remove_one(int bond, Eigen::Ref<Eigen::VectorXd> response, Eigen::Index changes_known);
  void detach_functions(const Pull& pull, double stiffness, Eigen::Ref<Eigen::VectorXd> response);

  Eigen::Index kept_;            // degrees of freedom
  Eigen::Index size_;            // of them followed
  Eigen::Index functions_;       // count
  std::vector<int> followed_;    // which of the kept ones, ascending
  std::vector<char> contained_;  // per global bond
  std::vector<int> bonds_;
  std::vector<Pull> pulls_;
  std::vector<double> stiffness_;
  std::vector<double> cosine_, sine_;  // over length and critical stretch
  std::vector<char> intact_;
  AffineRatios ratios_;
  bool has_constant_part_;
  coupling::Affine extended_;         // followed displacements, values of functions, prescribed ones at ends of bonds
  std::vector<int> prescribed_dofs_;  // those, global degrees of freedom
  Eigen::MatrixXd flexibility_;       // lower triangle, and below it the rows of functions
  Eigen::MatrixXd pending_;           // F is flexibility_ + pending_ pending_^T
  Eigen::Index pending_count_ = 0;
  std::vector<Eigen::VectorXd> moved_;  // of every function, on prescribed_dofs_; or empty
  LeftBehind left_behind_;
  Eigen::MatrixXd outside_;
  std::vector<int> outside_dofs_;
};

}  // namespace bempd::fracture
