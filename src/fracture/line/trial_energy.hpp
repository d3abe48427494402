#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/equilibrium_system.hpp"
#include "fracture/line/growing_tip.hpp"
#include "fracture/line/williams_fit.hpp"

namespace bempd::fracture {

// Stress intensity factors of a tip by path-independent sums around it, with their relative error.
struct TipFactors {
  AffineIntensity intensity;
  double error = 0;
};
// Function that finds the stress intensity factors of a tip by path-independent sums around it, from displacements;
// empty if there is no room for the sums.
using FactorsAround = std::function<std::optional<TipFactors>(const GrowingTip&, const coupling::Affine& displacement)>;

// Body for trial steps of crack lines (steps that are evaluated but not taken). The body gives the flexibility along
// some of its terms (bonds and cell squares), and the stress intensity factors of tips.
class TrialBody {
 public:
  TrialBody() = default;
  TrialBody(const TrialBody&) = delete;
  TrialBody& operator=(const TrialBody&) = delete;
  virtual ~TrialBody() = default;

  // Flexibility F = B^T K^-1 B along some intact terms, with the body's stiffness K: elongations B^T u of the terms due
  // to unit forces in them (coupling/term_flexibility.hpp). Empty if a part of the body could move freely.
  virtual std::optional<Eigen::MatrixXd> flexibility(std::span<const int> terms) = 0;
  virtual std::optional<TipFactors> factors_around(const GrowingTip& tip, const coupling::Affine& displacement) = 0;
};

// Whole body in which trial steps are evaluated. Recent flexibilities are kept as long as the body's matrix does not
// change.
class WholeBodyTrials final : public TrialBody {
 public:
  WholeBodyTrials(coupling::EquilibriumSystem& system, FactorsAround factors)
      : system_(system), factors_(std::move(factors)) {}

  std::optional<Eigen::MatrixXd> flexibility(std::span<const int> terms) override;
  std::optional<TipFactors> factors_around(const GrowingTip& tip, const coupling::Affine& displacement) override {
    return factors_ ? factors_(tip, displacement) : std::nullopt;
  }

  // Sets whether flexibilities are computed with a separate factor. This is needed if an open window (region around
  // crack tips that is solved alone) has changed terms, so that the system's factor belongs to the previous matrix.
  void use_separate_factor(bool separate) { uses_separate_factor_ = separate; }

 private:
  struct Answer {
    std::vector<int> terms;
    Eigen::MatrixXd flexibility;
  };

  coupling::EquilibriumSystem& system_;
  FactorsAround factors_;
  bool uses_separate_factor_ = false;
  std::int64_t matrix_known_ = -1;  // SolverCounters::matrices when the answers were computed
  std::vector<Answer> answers_;
};

// Energy that is released when terms (bonds and cell squares) are removed from a list, for the first 1, 2, ... terms at
// once. With the stiffnesses k and elastic elongations e of the terms, their forces f = k e and the body's flexibility
// F along them, all terms together release
//   1/2 f^T (k - k F k)^-1 f.
// This is half the sum of the squares of y, where L y = e and L L^T = k^-1 - F; the first n terms release half the sum
// of the first n squares. The formula holds for dead loads and for prescribed displacements alike.
class TrialEnergy {
 public:
  // Energy for terms with the given stiffnesses, flexibility and elastic elongations (constant and proportional part).
  TrialEnergy(const Eigen::VectorXd& stiffness, const Eigen::MatrixXd& flexibility, const coupling::Affine& elongation);

  // Number of terms, from the beginning of the list, that can be removed before some motion meets no resistance.
  Eigen::Index count() const { return count_; }

  double released(Eigen::Index terms, double load_factor) const;

  // Elastic elongations of the first `terms` terms after these terms are removed.
  Eigen::VectorXd elongations_without(Eigen::Index terms, double load_factor) const;

 private:
  Eigen::Index count_ = 0;
  Eigen::VectorXd root_stiffness_;
  Eigen::MatrixXd lower_;  // triangular factor of 1 - k^1/2 F k^1/2
  coupling::Affine y_;
};

}  // namespace bempd::fracture
