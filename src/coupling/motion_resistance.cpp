#include "coupling/motion_resistance.hpp"

#include <cmath>

#include "cancellation.hpp"
#include "error.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::coupling {

namespace {

// Limit on stiffness * elongation of a broken term, when forces of order 1 pull along the broken terms in the body
// without these terms. The value would be 1 if a spring with the term's stiffness were the only resistance. Beyond the
// limit hardly anything resists, so the motion counts as free.
constexpr double suspicious_response = 1e8;

// Share of a motion's energy that the rest of the body may carry if the motion is to count as resisted by springs only.
constexpr double resisted_by_others = 1e-6;

// Nodal forces that pull along all the terms `along` at once, with uneven sizes, so that they hardly cancel in any
// motion.
Eigen::VectorXd uneven_pull(const Terms& terms, const NodeTies& ties, int node_count, std::span<const int> along) {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(2 * node_count);
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double size = std::sin(1.0 + static_cast<double>(i));
    terms.for_each_entry(static_cast<std::size_t>(along[i]), [&](int node, double x, double y) {
      pull.segment<2>(2 * node) += size * Eigen::Vector2d(x, y);
    });
  }
  ties.collect(pull);
  return pull;
}

// Nodal forces s along a spring, of the size of the root of its stiffness, so that s s^T is its stiffness matrix.
Eigen::VectorXd pull_of(const HoldingSpring& spring, const NodeTies& ties, int node_count) {
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(2 * node_count);
  pull.segment<2>(2 * spring.node) = std::sqrt(spring.stiffness) * Eigen::Vector2d(spring.cosine, spring.sine);
  ties.collect(pull);
  return pull;
}

}  // namespace

bool MotionResistance::resists_all(std::span<const int> broken) {
  if (!factor_.exists()) return true;
  if (factor_.is_current()) return factor_.pivots_are_sound();
  // A factor from before the breaks does not show a loss of resistance. A motion that was resisted by a single broken
  // term needs no test, because it grows without bound under the present load. A motion that was resisted by several
  // broken terms shows under uneven pulls along these terms.
  if (broken.size() < 2) return true;
  const Terms& terms = parts_.terms;
  const Eigen::VectorXd pull = uneven_pull(terms, parts_.ties, parts_.node_count, broken);
  Eigen::VectorXd response;
  try {
    response = parts_.displacement_of(factor_.solve(pull(parts_.unknowns.dof_of)));
  } catch (const Error&) {
    return false;
  }
  if (factor_.is_current()) return factor_.pivots_are_sound();
  for (int t : broken) {
    const double elongation = terms.elongation(static_cast<std::size_t>(t), response.data());
    if (!(std::abs(elongation) * terms.stiffness[t] < suspicious_response)) return false;
  }
  return true;
}

// Finds the motions by an eigenvalue problem. K is the matrix with the springs; the columns of S are unit vectors along
// the springs times the roots of their stiffnesses. A motion m that only the springs resist has K m = S S^T m, so that
// S^T K^-1 S y = y with y = S^T m: it belongs to an eigenvalue 1 of S^T K^-1 S, while all other eigenvalues are less.
std::vector<Eigen::VectorXd> MotionResistance::motions_held_by(std::span<const HoldingSpring> springs) {
  parts_.condense();
  // The matrix is summed without constraints, so that fragments held by contact of crack faces alone count as free.
  const SystemMatrix::Matrix& matrix = matrix_.assemble_without_constraints();
  const std::unique_ptr<SystemSolver> solver = shifted_solver(parts_.method, matrix, stiff_diagonal(matrix));
  Eigen::MatrixXd pulls = Eigen::MatrixXd::Zero(parts_.unknowns.count(), static_cast<Eigen::Index>(springs.size()));
  for (Eigen::Index k = 0; k < pulls.cols(); ++k)
    pulls.col(k) =
        pull_of(springs[static_cast<std::size_t>(k)], parts_.ties, parts_.node_count)(parts_.unknowns.dof_of);
  Eigen::MatrixXd answers = pulls;
  check_cancelled();
  solver->factorization().solve_in_place(answers);
  const linalg::SymmetricModes modes = linalg::symmetric_modes(pulls.transpose() * answers);
  std::vector<Eigen::VectorXd> motions;
  for (Eigen::Index k = 0; k < pulls.cols(); ++k) {
    if (modes.values[k] >= 1 - resisted_by_others)
      motions.push_back(parts_.displacement_of(answers * modes.vectors.col(k)));
  }
  return motions;
}

SoftMotion MotionResistance::softest() {
  parts_.condense();
  double resistance = 0;
  const Eigen::VectorXd vector = softest_vector(parts_.method, matrix_.assemble(), resistance);
  return {parts_.displacement_of(vector), resistance};
}

}  // namespace bempd::coupling
