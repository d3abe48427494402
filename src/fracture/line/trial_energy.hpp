#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "coupling/affine.hpp"
#include "coupling/equilibrium_system.hpp"

namespace bempd::fracture {

// What trial steps ask of a body: how soft it is along some of its terms.
class TrialBody {
 public:
  TrialBody() = default;
  TrialBody(const TrialBody&) = delete;
  TrialBody& operator=(const TrialBody&) = delete;
  virtual ~TrialBody() = default;

  // F = B^T K^-1 B of terms that are there (coupling/term_flexibility.hpp); null where a part could move freely.
  virtual std::optional<Eigen::MatrixXd> flexibility(std::span<const int> terms) = 0;
};

// The whole body. What was asked last is kept as long as the body's matrix does not change.
class WholeBodyTrials final : public TrialBody {
 public:
  explicit WholeBodyTrials(coupling::EquilibriumSystem& system) : system_(system) {}

  std::optional<Eigen::MatrixXd> flexibility(std::span<const int> terms) override;

  // Makes answers come from a factor of their own from now on: an open window has changed terms, and the system's
  // factor belongs to the matrix before.
  void stand_apart(bool apart) { is_apart_ = apart; }

 private:
  struct Answer {
    std::vector<int> terms;
    Eigen::MatrixXd flexibility;
  };

  coupling::EquilibriumSystem& system_;
  bool is_apart_ = false;
  std::int64_t matrix_known_ = -1;  // the state of the matrix by what its solver has counted
  std::vector<Answer> answers_;
};

// Energy that is released where terms are taken away, for every number of the first ones at once. With f = k e the
// pulls of the terms and F the body's flexibility along them, all of them release 1/2 f^T (k - k F k)^-1 f: half the
// sum of squares of y, where L y = e and L L^T = k^-1 - F, and the first n of them half the sum of the first n squares.
// The formula holds for dead loads and for supports alike.
class TrialEnergy {
 public:
  // The elongations are elastic ones, their constant and proportional part.
  TrialEnergy(const Eigen::VectorXd& stiffness, const Eigen::MatrixXd& flexibility, const coupling::Affine& elongation);

  // How many of the first terms can be taken away before some motion meets no resistance.
  Eigen::Index count() const { return count_; }

  double released(Eigen::Index terms, double load_factor) const;

  // Elongations of the first terms once these are gone.
  Eigen::VectorXd elongations_without(Eigen::Index terms, double load_factor) const;

 private:
  Eigen::Index count_ = 0;
  Eigen::VectorXd root_stiffness_;
  Eigen::MatrixXd lower_;  // of 1 - k^1/2 F k^1/2
  coupling::Affine y_;
};

}  // namespace bempd::fracture
