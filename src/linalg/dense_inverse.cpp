#include "linalg/dense_inverse.hpp"

#include "linalg/dense_parts.hpp"

namespace bempd::linalg {

namespace {

constexpr Eigen::Index smallest_block = 48;

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
  check_cancelled();
  b = (-b * a.triangularView<Eigen::Lower>()).eval();
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
  check_cancelled();
  b = (c.triangularView<Eigen::Lower>().transpose() * b).eval();
  multiply_by_transpose(c);
}

}  // namespace bempd::linalg
