#include "fracture/line/trial_energy.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/term_flexibility.hpp"
#include "error.hpp"

namespace bempd::fracture {

namespace {

// Least pivot of the matrix 1 - k^1/2 F k^1/2 (stiffnesses k, flexibility F). With a smaller pivot, rounding decides
// whether the body resists all motions.
constexpr double smallest_trial_pivot = 1e-7;

// Largest number of flexibility matrices kept for reuse: about as many trial paths and directions are evaluated before
// the matrix of the system changes.
constexpr std::size_t most_answers_kept = 32;

}  // namespace

std::optional<Eigen::MatrixXd> WholeBodyTrials::flexibility(std::span<const int> terms) {
  try {
    if (uses_separate_factor_) return coupling::flexibility_by_temporary_factor(system_, terms);
    if (system_.counters().matrices != matrix_known_ || answers_.size() >= most_answers_kept) answers_.clear();
    for (const Answer& answer : answers_)
      if (std::equal(answer.terms.begin(), answer.terms.end(), terms.begin(), terms.end())) return answer.flexibility;
    answers_.push_back({{terms.begin(), terms.end()}, coupling::flexibility_of(system_, terms)});
    matrix_known_ = system_.counters().matrices;
    return answers_.back().flexibility;
  } catch (const Error& error) {
    if (error.failure() != Failure::unsolvable) throw;
    return std::nullopt;
  }
}

// Factorizes 1 - k^1/2 F k^1/2 (stiffnesses k, flexibility F) row by row, so that the factorization ends before the
// first pivot that is too small.
TrialEnergy::TrialEnergy(const Eigen::VectorXd& stiffness, const Eigen::MatrixXd& flexibility,
                         const coupling::Affine& elongation)
    : root_stiffness_(stiffness.cwiseSqrt()), y_(root_stiffness_.asDiagonal() * elongation) {
  const Eigen::Index terms = stiffness.size();
  lower_ = -(root_stiffness_.asDiagonal() * flexibility * root_stiffness_.asDiagonal());
  lower_.diagonal().array() += 1;
  for (count_ = 0; count_ < terms; ++count_) {
    const Eigen::Index n = count_;
    if (n > 0) {
      Eigen::VectorXd row = lower_.row(n).head(n);
      lower_.topLeftCorner(n, n).triangularView<Eigen::Lower>().solveInPlace(row);
      lower_.row(n).head(n) = row;
    }
    const double pivot = lower_(n, n) - lower_.row(n).head(n).squaredNorm();
    if (!(pivot > smallest_trial_pivot)) break;
    lower_(n, n) = std::sqrt(pivot);
    y_.row(n) = (y_.row(n) - lower_.row(n).head(n) * y_.topRows(n)).eval() / lower_(n, n);
  }
}

double TrialEnergy::released(Eigen::Index terms, double load_factor) const {
  return 0.5 * (y_.topRows(terms) * Eigen::Vector2d(1, load_factor)).squaredNorm();
}

// Elongations after terms are removed: k^-1/2 z with z = (1 - k^1/2 F k^1/2)^-1 k^1/2 e, where k are the stiffnesses, F
// the flexibility and e the elastic elongations before.
Eigen::VectorXd TrialEnergy::elongations_without(Eigen::Index terms, double load_factor) const {
  Eigen::VectorXd z = y_.topRows(terms) * Eigen::Vector2d(1, load_factor);
  lower_.topLeftCorner(terms, terms).triangularView<Eigen::Lower>().transpose().solveInPlace(z);
  return z.cwiseQuotient(root_stiffness_.head(terms));
}

}  // namespace bempd::fracture
