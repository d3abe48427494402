#include "linalg/least_change.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cancellation.hpp"
#include "linalg/least_squares.hpp"
#include "linalg/minimum_norm.hpp"

namespace bempd::linalg {

namespace {

using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// Residual that no further round can reduce: the rounding error of values and equations of order one.
constexpr double rounding = 5e-16;

// Solver for the shortest x with B x = r, which has the form x = B^T lambda; r must be such that there is a solution.
class MinimumNormSolver {
 public:
  using Step = SparseMinimumNorm::Step;
  virtual ~MinimumNormSolver() = default;
  virtual Step solve(VectorXd r) const = 0;
};

// Solver by complete orthogonal decomposition, for a few equations that may be nearly dependent.
class DenseSolver final : public MinimumNormSolver {
 public:
  explicit DenseSolver(const Sparse& b)
      : rows_(Eigen::MatrixXd(b), dependent), columns_(Eigen::MatrixXd(b.transpose()), dependent) {}
  Step solve(VectorXd r) const override {
    const VectorXd change = rows_.solve(r);
    return {columns_.solve(change), change};
  }

 private:
  static constexpr double dependent = 1e-13;
  LeastSquares rows_, columns_;
};

class SparseSolver final : public MinimumNormSolver {
 public:
  explicit SparseSolver(const Sparse& b) { solver_.factorize(b); }
  Step solve(VectorXd r) const override { return solver_.solve(std::move(r), rounding); }

 private:
  SparseMinimumNorm solver_{1e-12};
};

double largest(const VectorXd& v) { return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>(); }

struct Candidate {
  VectorXd values, lambda;
  double residual = 0;
};

// Scales of the values, with zeros for the values that are held at their lower bound (`held`).
VectorXd free_scales(const LeastChange& problem, const std::vector<char>& held) {
  VectorXd scale = problem.scale;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i]) scale[i] = 0;
  return scale;
}

Candidate starting_candidate(const LeastChange& problem, const std::vector<char>& held) {
  Candidate c{problem.start, VectorXd::Zero(problem.target.size()), 0};
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i]) c.values[i] = problem.lower * problem.scale[i];
  return c;
}

// Refines a candidate by at most `most` steps, and ends when a step does not reduce the residual by half.
template <class Solver>
void refine(const LeastChange& problem, const VectorXd& free_scale, const Solver& solve, int most, Candidate& c) {
  VectorXd missing = problem.target - problem.constraints * c.values;
  c.residual = largest(missing);
  for (int round = 0; round < most && c.residual > rounding; ++round) {
    const SparseMinimumNorm::Step step = solve(missing);
    const VectorXd next = c.values + free_scale.cwiseProduct(step.change);
    missing = problem.target - problem.constraints * next;
    const double residual = largest(missing), before = c.residual;
    if (!(residual < before)) break;
    c.values = next;
    c.lambda += step.lambda;
    c.residual = residual;
    if (residual > 0.5 * before) break;
  }
}

// Least change with the values marked in `held` fixed at their lower bound.
Candidate solve_with_held(const LeastChange& problem, const std::vector<char>& held) {
  Candidate c = starting_candidate(problem, held);
  const VectorXd free_scale = free_scales(problem, held);
  Sparse scaled;
  scaled = problem.constraints * free_scale.asDiagonal();
  std::unique_ptr<MinimumNormSolver> solver;
  if (scaled.rows() <= 80) {
    solver = std::make_unique<DenseSolver>(scaled);
  } else {
    solver = std::make_unique<SparseSolver>(scaled);
  }
  refine(
      problem, free_scale, [&](const VectorXd& r) { return solver->solve(r); }, 30, c);
  return c;
}

// Flags of the values that the multipliers of a candidate would take below their lower bound; `held` are the flags so
// far.
std::vector<char> held_by(const LeastChange& problem, const Candidate& c, const std::vector<char>& held) {
  const VectorXd pull = problem.constraints.transpose() * c.lambda;
  const bool bounded = std::isfinite(problem.lower);
  std::vector<char> next(held.size(), 0);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const double wanted = problem.start[i] + problem.scale[i] * problem.scale[i] * pull[i];
    // A margin prevents rounding from moving a value in and out of the set for ever.
    const double margin = held[i] ? 1e-12 : -1e-12;
    next[i] = bounded && wanted < (problem.lower + margin) * problem.scale[i];
  }
  return next;
}

}  // namespace

// Solves by primal-dual active sets (Hintermueller, Ito, Kunisch 2002), a semismooth Newton method for the dual
// problem, in which x = max(lower * scale, start + scale^2 A^T lambda) with one multiplier lambda per equation of A x =
// b.
LeastChangeResult solve_least_change(const LeastChange& problem) {
  assert(problem.constraints.cols() == problem.start.size() && problem.start.size() == problem.scale.size());
  LeastChangeResult result;
  std::vector<char> held(problem.start.size(), 0);
  for (int round = 0; round < 30; ++round) {
    check_cancelled();
    const Candidate c = solve_with_held(problem, held);
    result.values = c.values;
    result.residual = c.residual;
    const std::vector<char> next = held_by(problem, c, held);
    if (next == held) break;
    held = next;
  }
  return result;
}

// Solves a long problem by active sets. A rough solution usually tells which values are held at their lower bound.
// Exact solutions are computed once the set of held values stays the same, or after some rounds.
LeastChangeResult solve_long_least_change(const LeastChange& problem) {
  if (problem.target.size() <= 80) return solve_least_change(problem);
  constexpr double shift = 3e-15;
  constexpr int rough_rounds = 5, last_round = 29;
  SparseMinimumNorm solver(shift);
  Candidate c;
  std::vector<char> held(problem.start.size(), 0);
  std::vector<std::vector<char>> seen;  // sets after the rough rounds, where each follows from the last
  for (int round = 0; round <= last_round; ++round) {
    check_cancelled();
    if (round >= rough_rounds) {
      const auto same = std::find(seen.begin(), seen.end(), held);
      if (same != seen.end()) {  // the rounds would repeat for ever
        held = same[(last_round - round) % (seen.end() - same)];
        round = last_round;
      }
      seen.push_back(held);
    }
    c = starting_candidate(problem, held);
    const VectorXd free_scale = free_scales(problem, held);
    Sparse scaled;
    scaled = problem.constraints * free_scale.asDiagonal();
    solver.factorize(scaled);
    const auto solve = [&](const VectorXd& r) { return solver.solve(r, rounding); };
    std::vector<char> next;
    if (round < rough_rounds) {
      refine(problem, free_scale, solve, 1, c);
      next = held_by(problem, c, held);
    }
    if (round >= rough_rounds || next == held) {
      refine(problem, free_scale, solve, 30, c);
      next = held_by(problem, c, held);
    }
    if (next == held) break;
    held = next;
  }
  return {c.values, c.residual};
}

}  // namespace bempd::linalg
