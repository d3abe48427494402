#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/critical_events.hpp"

namespace bempd::fracture {

// Bonds between kept nodes and the flexibility F (displacements per force) of the whole body there. Breaking a bond of
// stiffness k along b changes F by a matrix of rank one: w = F b, gamma = 1 - k b.w, F <- F + (k / gamma) w w^T, and
// the displacements by (k e / gamma) w, e being the bond's elongation (Sherman and Morrison 1950). The change of F is
// collected and added to it many columns at a time.
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

  // Global numbers of the bonds, ascending; bonds are named by their place in this list below.
  const std::vector<int>& bonds() const { return bonds_; }
  bool contains(int global_bond) const { return place_[global_bond] >= 0; }
  const std::vector<char>& intact() const { return intact_; }
  const AffineRatios& ratios() const { return ratios_; }

  // Displacements of the kept degrees of freedom.
  coupling::Affine displacement() const { return extended_.topRows(size_); }

  // Row k: value of the function k for the constant and the proportional part of the load.
  Eigen::Matrix<double, Eigen::Dynamic, 2> function_values() const;

  double elongation(int bond, double load_factor) const;
  double stiffness(int bond) const { return stiffness_[bond]; }

  // False, and nothing changed, if some motion would lose its resistance with these bonds.
  bool remove(std::span<const int> bonds);

  // The stiffness of all that is not a bond of the window, on those kept degrees of freedom that it touches.
  const Eigen::MatrixXd& outside_stiffness() const { return outside_; }
  const std::vector<int>& outside_dofs() const { return outside_dofs_; }  // places among the kept ones

 private:
  struct Pull {
    std::array<int, 4> dof;  // places in extended_
    std::array<double, 4> weight;
  };

  void collect_bonds(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                     const StretchRatios& ratios);
  void find_outside(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation);
  void update_ratios();
  Eigen::MatrixXd responses(std::span<const int> bonds) const;  // F b
  void flush();
  // `response` is F b as it was when only this many changes were pending.
  bool remove_one(int bond, Eigen::Ref<Eigen::VectorXd> response, Eigen::Index changes_known);

  Eigen::Index size_;  // kept degrees of freedom
  std::vector<int> bonds_, place_;
  std::vector<Pull> pulls_;
  std::vector<double> stiffness_;
  std::vector<double> cosine_, sine_;  // over length and critical stretch
  std::vector<char> intact_;
  AffineRatios ratios_;
  bool has_constant_part_;
  coupling::Affine extended_;       // kept displacements, then prescribed ones at ends of bonds
  std::vector<int> extended_dofs_;  // global degrees of freedom of extended_
  Eigen::MatrixXd flexibility_;     // lower triangle
  Eigen::MatrixXd pending_;         // F is flexibility_ + pending_ pending_^T
  Eigen::Index pending_count_ = 0;
  Eigen::MatrixXd outside_;
  std::vector<int> outside_dofs_;
  std::vector<coupling::CondensedFunction> functions_;
  std::vector<Eigen::VectorXd> moved_;  // of every function, on extended_dofs_; or empty
};

}  // namespace bempd::fracture
