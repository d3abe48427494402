#include "bem/opening_schur_complement.hpp"

#include <algorithm>
#include <utility>

#include "bem/galerkin_assembly.hpp"
#include "error.hpp"
#include "linalg/dense_parts.hpp"

namespace bempd::bem {

namespace {

// Ratio of a pivot of the factorization to the diagonal entry of the matrix, below which a piece of the body can move
// without a force.
constexpr double least_pivot = 1e-12;

std::vector<Eigen::Index> components_of(const std::vector<int>& nodes) {
  std::vector<Eigen::Index> all;
  for (const int node : nodes) all.insert(all.end(), {2 * Eigen::Index{node}, 2 * Eigen::Index{node} + 1});
  return all;
}

}  // namespace

// Orders the opening nodes, first the nodes whose rows of the factor are copied from `before`; returns the number of
// components of these first nodes.
Eigen::Index OpeningSchurComplement::take_over(const OpeningSchurComplement& before, Eigen::Index displacements,
                                               const std::vector<int>& kept) {
  const int first = static_cast<int>(displacements / 2), count = static_cast<int>(kept.size());
  if (before.stiffness_.rows() != displacements) return 0;
  for (int node = 0; node < first; ++node)
    if (kept[node] != node) return 0;
  std::vector<int> now;
  for (int node = first; node < count; ++node) {
    if (kept[node] < 0) continue;
    if (kept[node] >= static_cast<int>(now.size())) now.resize(static_cast<std::size_t>(kept[node]) + 1, -1);
    now[kept[node]] = node;
  }
  std::vector<char> placed(count, 0);
  for (const int old : before.order_) {
    if (old >= static_cast<int>(now.size()) || now[old] < 0) break;
    order_.push_back(now[old]);
    placed[now[old]] = 1;
  }
  const auto known = static_cast<Eigen::Index>(2 * order_.size());
  for (int node = first; node < count; ++node)
    if (!placed[node]) order_.push_back(node);
  return known;
}

void OpeningSchurComplement::compute(const Eigen::MatrixXd& full, Eigen::Index displacements,
                                     const OpeningSchurComplement* before, const std::vector<int>& kept) {
  order_.clear();
  const Eigen::Index known = before ? take_over(*before, displacements, kept) : 0;
  if (known == 0) {
    order_.clear();
    for (Eigen::Index node = displacements / 2; 2 * node < full.rows(); ++node)
      order_.push_back(static_cast<int>(node));
  }
  const Eigen::Index size = full.rows() - displacements;
  factor_ = Eigen::MatrixXd::Zero(size, size);
  half_.resize(size, displacements);
  if (known > 0) {
    factor_.topLeftCorner(known, known) = before->factor_.topLeftCorner(known, known);
    half_.topRows(known) = before->half_.topRows(known);
  }
  if (known < size) factorize(full, displacements, known);
  const auto add_square = [&](const Eigen::MatrixXd& half, double sign) {
    if (half.rows() > known) linalg::add_square(stiffness_, half.bottomRows(half.rows() - known).transpose(), sign);
  };
  stiffness_ = known > 0 ? before->stiffness_ : Eigen::MatrixXd(full.topLeftCorner(displacements, displacements));
  if (known > 0) add_square(before->half_, 1);
  add_square(half_, -1);
  copy_lower_to_upper(stiffness_);
}

// Computes the rows of L and of L^-1 K_wu from row `known` on, where K_ww = L L^T for the openings w; earlier rows have
// been copied.
void OpeningSchurComplement::factorize(const Eigen::MatrixXd& full, Eigen::Index displacements, Eigen::Index known) {
  const std::vector<Eigen::Index> rows = components_of(order_);
  const std::vector<Eigen::Index> front(rows.begin(), rows.begin() + known), fresh(rows.begin() + known, rows.end());
  const auto left = static_cast<Eigen::Index>(fresh.size());
  Eigen::MatrixXd own = full(fresh, fresh), to_displacements = full(fresh, Eigen::seqN(0, displacements));
  const Eigen::VectorXd diagonal = own.diagonal();
  if (known > 0) {
    Eigen::MatrixXd across = full(front, fresh);
    factor_.topLeftCorner(known, known).triangularView<Eigen::Lower>().solveInPlace(across);
    own.selfadjointView<Eigen::Lower>().rankUpdate(across.transpose(), -1);
    to_displacements -= across.transpose() * half_.topRows(known);
    factor_.bottomLeftCorner(left, known) = across.transpose();
  }
  linalg::DenseCholesky cholesky;
  cholesky.compute(std::move(own));
  const Eigen::ArrayXd pivots = cholesky.matrixLLT().diagonal().array().square();
  require(cholesky.info() == Eigen::Success && (pivots > least_pivot * diagonal.array()).all(),
          "cracks cut a piece out of a body that nothing holds; leave a ligament or end one of them earlier");
  factor_.bottomRightCorner(left, left).triangularView<Eigen::Lower>() = cholesky.matrixL();
  linalg::solve_lower(cholesky.lower(), to_displacements);
  half_.bottomRows(left) = to_displacements;
}

Eigen::MatrixXd OpeningSchurComplement::solve(const Eigen::Ref<const Eigen::MatrixXd>& forces) const {
  if (order_.empty()) return Eigen::MatrixXd(0, forces.cols());
  std::vector<Eigen::Index> rows = components_of(order_);
  const Eigen::Index first = *std::min_element(rows.begin(), rows.end());
  for (Eigen::Index& row : rows) row -= first;
  Eigen::MatrixXd ordered = forces(rows, Eigen::all), result(forces.rows(), forces.cols());
  factor_.triangularView<Eigen::Lower>().solveInPlace(ordered);
  factor_.triangularView<Eigen::Lower>().transpose().solveInPlace(ordered);
  result(rows, Eigen::all) = ordered;
  return result;
}

}  // namespace bempd::bem
