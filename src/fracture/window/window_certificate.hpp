#pragma once

#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/window/window_settings.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Proves that the events in a window are those of the whole body, because no bond outside is closer to breaking.
//
// Some states (snapshots) are computed for the whole body. Between two of them, a and b, take the mean (1 - t) a + t b
// with 0 <= t <= 1: no bond is stretched more in it than the same mean of the largest stretches in a and b. A state
// differs from the mean by a displacement d of the window's nodes, to which the outside responds without load.
// The strain energy of that response is d^T S d / 2, where S is the stiffness of the outside on the window's nodes. All
// bonds outside share it and none has a negative energy, so k e^2 <= d^T S d holds for the elongation e of each.
class WindowCertificate {
 public:
  WindowCertificate(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                    const WindowSolver& window, const StretchRatios& ratios, bool proportional);

  // Returns the index of the first state with a failed check, or the number of states. `states` are the kept
  // displacements after 0, 1, ... events, `breaks` the numbers of bonds broken until each. `first` is state 0 of the
  // whole body.
  int first_violation(const std::vector<coupling::Affine>& states, const std::vector<int>& breaks,
                      const std::vector<OutsideCheck>& checks, const coupling::Affine& first);

  // Displacements of the whole body in one of the states of the last call of first_violation().
  coupling::Affine last_displacement(int state) const;

 private:
  // Classes of bonds outside the window: bonds with a similar stretch ratio per root of energy are proven together.
  static constexpr int most_classes = WindowSettings::classes;
  using Classes = Eigen::Array<double, most_classes, 1>;

  struct Snapshot {
    Classes bound;                // of the stretch ratios at all load factors checked
    std::vector<double> largest;  // per own check
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
  std::vector<int> first_, second_;    // of bonds outside that can break
  std::vector<double> cosine_, sine_;  // scaled so that ratios come out
  std::vector<char> class_of_;
  Classes compliance_;  // largest stretch ratio per root of energy, of each class
  double rounding_;

  // Data of the present call of first_violation().
  const std::vector<coupling::Affine>* states_ = nullptr;
  const coupling::Affine* whole_first_ = nullptr;
  std::vector<std::vector<OutsideCheck>> checks_;  // per state
  double lowest_ = 0, highest_ = 0;                // load factors checked
  std::map<int, Snapshot> snapshots_;
  int solved_state_ = -1;  // the last one of the question, once it is computed
  Eigen::MatrixXd solved_;
};

}  // namespace bempd::fracture
