#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/window/window_settings.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Proof that the events in a window (region around crack tips or bonds close to breaking that is solved alone) are
// those of the whole body, because no bond outside the window is closer to breaking.
//
// Some states (snapshots) are computed for the whole body. Let (1 - t) a + t b with 0 <= t <= 1 be a mean of two
// snapshots a and b: each bond is stretched in it by at most the same mean of the largest stretches in a and b. A state
// between a and b differs from the mean by a displacement d of the window's nodes, to which the body outside the window
// responds without load. The strain energy of that response is d^T S d / 2, where S is the stiffness of the outside on
// the window's nodes. All bonds outside share this energy and none has a negative energy, so k e^2 <= d^T S d holds for
// the stiffness k and the elongation e of each bond.
class WindowCertificate {
 public:
  WindowCertificate(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                    const WindowSolver& window, const StretchRatios& ratios, bool proportional);

  // Index of the first state in which a check fails; the number of states if none does. `states` are the displacements
  // kept in the window after 0, 1, ... events, `breaks` the numbers of bonds broken until each state. `first` are the
  // displacements of the whole body in state 0.
  int first_violation(const std::vector<coupling::Affine>& states, const std::vector<int>& breaks,
                      const std::vector<OutsideCheck>& checks, const coupling::Affine& first);

  // Displacements of the whole body in one of the states of the last call of first_violation().
  coupling::Affine last_displacement(int state) const;

 private:
  // Number of classes of bonds outside the window. Bonds for which one unit of energy can cause a similar stretch ratio
  // are in one class and are proven together.
  static constexpr int most_classes = WindowSettings::classes;
  using Classes = Eigen::Array<double, most_classes, 1>;

  struct Snapshot {
    Classes bound;                // largest stretch ratios at all load factors checked
    std::vector<double> largest;  // largest stretch ratio for each check of the state
  };

  void collect_bonds(const coupling::EquilibriumSystem& system, const StretchRatios& ratios);
  void classify(const std::vector<double>& compliance);
  std::vector<Classes> largest_ratios(const Eigen::MatrixXd& displacements) const;
  void compute_snapshots(const std::vector<int>& states);
  void compute_together(const std::vector<int>& states);
  Eigen::MatrixXd solve(const std::vector<int>& states);
  Eigen::MatrixXd values(const std::vector<std::pair<int, double>>& wanted, const std::vector<int>& solved,
                         const Eigen::MatrixXd& whole) const;
  bool is_exceeded(int state) const;
  std::vector<int> uncertified() const;
  std::vector<int> between_snapshots(const std::vector<int>& uncertified, int round) const;
  Eigen::VectorXd on_boundary(int state, double load_factor) const;

  const coupling::Condensation& condensation_;
  const WindowSolver& window_;
  bool proportional_;
  std::vector<int> first_, second_;    // first degree of freedom of each end, of bonds outside that can break
  std::vector<double> cosine_, sine_;  // scaled so that elongations are stretch ratios
  std::vector<char> class_of_;
  Classes compliance_;  // largest stretch ratio per root of energy, of each class
  double rounding_;

  // Data of the present call of first_violation(), of no meaning between calls.
  const std::vector<coupling::Affine>* states_ = nullptr;
  const coupling::Affine* whole_first_ = nullptr;
  std::vector<std::vector<OutsideCheck>> checks_;  // checks of each state
  double lowest_ = 0, highest_ = 0;                // range of the load factors checked
  std::map<int, Snapshot> snapshots_;
  int solved_state_ = -1;  // last state, once it is computed for the whole body
  Eigen::MatrixXd solved_;
};

}  // namespace bempd::fracture
