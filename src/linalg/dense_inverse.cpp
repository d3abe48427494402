#include "linalg/dense_inverse.hpp"

#include "linalg/dense_parts.hpp"

namespace bempd::linalg {

namespace {

constexpr Eigen::Index smallest_block = 48;

// Number of rows or columns by which a triangle of n rows is multiplied between two checks for cancellation.
Eigen::Index at_once(Eigen::Index n) {
  const auto square = static_cast<double>(n) * static_cast<double>(n);
  return std::max<Eigen::Index>(64, static_cast<Eigen::Index>(operations_at_once / square));
}

}  // namespace

void invert_lower(Eigen::Ref<Eigen::MatrixXd> lower) {
  const Eigen::Index n = lower.rows(), half = n / 2;
  if (n <= smallest_block) {
    const Eigen::MatrixXd inverse = lower.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(n, n));
    lower.triangularView<Eigen::Lower>() = inverse;
    return;
  }
  auto a = lower.topLeftCorner(half, half);
  auto b = lower.bottomLeftCorner(n - half, half);
  auto c = lower.bottomRightCorner(n - half, n - half);
  invert_lower(a);
  solve_lower(c, b);
  const Eigen::Index rows = at_once(a.rows());
  for (Eigen::Index i = 0; i < b.rows(); i += rows) {
    check_cancelled();
    auto part = b.middleRows(i, std::min(rows, b.rows() - i));
    part = (-part * a.triangularView<Eigen::Lower>()).eval();
  }
  invert_lower(c);
}

void multiply_by_transpose(Eigen::Ref<Eigen::MatrixXd> lower) {
  const Eigen::Index n = lower.rows(), half = n / 2;
  if (n <= smallest_block) {
    const Eigen::MatrixXd triangle = lower.triangularView<Eigen::Lower>();
    lower.triangularView<Eigen::Lower>() = triangle.transpose() * triangle;
    return;
  }
  auto a = lower.topLeftCorner(half, half);
  auto b = lower.bottomLeftCorner(n - half, half);
  auto c = lower.bottomRightCorner(n - half, n - half);
  multiply_by_transpose(a);
  add_square(a, b.transpose());
  const Eigen::Index columns = at_once(c.rows());
  for (Eigen::Index j = 0; j < b.cols(); j += columns) {
    check_cancelled();
    auto part = b.middleCols(j, std::min(columns, b.cols() - j));
    part = (c.triangularView<Eigen::Lower>().transpose() * part).eval();
  }
  multiply_by_transpose(c);
}

}  // namespace bempd::linalg
