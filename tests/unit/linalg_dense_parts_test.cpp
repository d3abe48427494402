// Dense algebra in parts: the numbers of a single call, and a request to stop is heard.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <atomic>

#include "cancellation.hpp"
#include "linalg/dense_inverse.hpp"
#include "linalg/dense_parts.hpp"

namespace {

using namespace bempd::linalg;
using Eigen::MatrixXd;

// Size above which work is done in parts.
constexpr Eigen::Index large = 1300;

const MatrixXd& positive() {
  static const MatrixXd matrix = [] {
    std::srand(7);
    const MatrixXd random = MatrixXd::Random(large, large);
    return MatrixXd(random * random.transpose() + large * MatrixXd::Identity(large, large));
  }();
  return matrix;
}

double difference(const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() / b.norm(); }

MatrixXd some(Eigen::Index rows, Eigen::Index columns) { return MatrixXd::Random(rows, columns); }

// Programs of tests have the engine's definition too, not Eigen's own, which would free the memory twice here.
TEST(DenseStorage, is_empty_where_there_is_no_memory_for_its_new_size) {
  MatrixXd matrix = MatrixXd::Ones(3, 3);
  Eigen::VectorXd vector = Eigen::VectorXd::Ones(3);
  constexpr Eigen::Index far = Eigen::Index{1} << 24;
  EXPECT_THROW(matrix.resize(far, far), std::bad_alloc);
  EXPECT_THROW(vector.resize(far * far), std::bad_alloc);
  EXPECT_EQ(matrix.size(), 0);
  EXPECT_EQ(vector.size(), 0);
  matrix.resize(2, 2);
}

TEST(DenseParts, factorize_as_a_single_call_does) {
  DenseCholesky in_parts;
  in_parts.compute(positive());
  const Eigen::LLT<MatrixXd> whole(positive());
  ASSERT_EQ(in_parts.info(), Eigen::Success);
  EXPECT_LT(difference(in_parts.matrixL(), whole.matrixL()), 1e-13);
  EXPECT_NEAR(in_parts.rcond(), whole.rcond(), 1e-12);
}

// The last panel is a single column here, with nothing below it.
TEST(DenseParts, leave_no_empty_matrix_to_the_blas) {
  constexpr Eigen::Index size = 5 * 256 + 1;
  DenseCholesky in_parts;
  testing::internal::CaptureStderr();
  in_parts.compute(positive().topLeftCorner(size, size));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  const Eigen::LLT<MatrixXd> whole(positive().topLeftCorner(size, size));
  EXPECT_LT(difference(in_parts.matrixL(), whole.matrixL()), 1e-13);
}

TEST(DenseParts, keep_every_digit_of_what_is_small) {
  const MatrixXd small = positive().topLeftCorner(300, 300);
  DenseCholesky in_parts;
  in_parts.compute(small);
  const Eigen::LLT<MatrixXd> whole(small);
  EXPECT_EQ(MatrixXd(in_parts.matrixL()), MatrixXd(whole.matrixL()));
  MatrixXd x = some(300, 20);
  const MatrixXd y = whole.matrixL().solve(x);
  solve_lower(in_parts.lower(), x);
  EXPECT_EQ(x, y);
}

TEST(DenseParts, refuse_what_is_not_positive_definite) {
  MatrixXd indefinite = positive();
  indefinite(large - 1, large - 1) = -1;
  DenseCholesky in_parts;
  in_parts.compute(indefinite);
  EXPECT_NE(in_parts.info(), Eigen::Success);
}

TEST(DenseParts, solve_from_all_sides) {
  const Eigen::LLT<MatrixXd> factor(positive());
  const MatrixXd& lower = factor.matrixLLT();
  MatrixXd x = some(large, 500);
  MatrixXd known = factor.matrixL().solve(x);
  solve_lower(lower, x);
  EXPECT_LT(difference(x, known), 1e-13);
  known = factor.matrixU().solve(x);
  solve_upper(lower, x);
  EXPECT_LT(difference(x, known), 1e-13);
  MatrixXd rows = some(500, large);
  known = factor.matrixL().solve(rows.transpose()).transpose();
  solve_upper_from_right(lower, rows);
  EXPECT_LT(difference(rows, known), 1e-13);
}

TEST(DenseParts, add_products) {
  const MatrixXd a = some(1100, 900), b = some(900, 700);
  MatrixXd sum = some(1100, 700);
  const MatrixXd known = sum - 0.5 * (a * b);
  add_product(sum, a, b, -0.5);
  EXPECT_LT(difference(sum, known), 1e-13);
  MatrixXd square = MatrixXd::Zero(900, 900);
  add_square(square, a.transpose(), 2);
  MatrixXd same = MatrixXd::Zero(900, 900);
  same.triangularView<Eigen::Lower>() = 2 * a.transpose() * a;
  EXPECT_LT(difference(square.triangularView<Eigen::Lower>(), same), 1e-13);
}

TEST(DenseParts, invert) {
  MatrixXd inverse = Eigen::LLT<MatrixXd>(positive()).matrixLLT();
  invert_from_cholesky(inverse);
  const MatrixXd product = inverse.selfadjointView<Eigen::Lower>() * positive();
  EXPECT_LT(difference(product, MatrixXd::Identity(large, large)), 1e-12);
}

TEST(DenseParts, hear_a_request_to_stop) {
  const std::atomic<bool> request{true};
  const bempd::CancellationScope scope(&request);
  DenseCholesky factor;
  EXPECT_THROW(factor.compute(positive()), bempd::Error);
  const MatrixXd lower = MatrixXd::Identity(large, large);
  MatrixXd x = some(large, 500), rows = some(500, large), sum = MatrixXd::Zero(large, large);
  EXPECT_THROW(solve_lower(lower, x), bempd::Error);
  EXPECT_THROW(solve_upper(lower, x), bempd::Error);
  EXPECT_THROW(solve_upper_from_right(lower, rows), bempd::Error);
  EXPECT_THROW(add_product(sum, lower, lower), bempd::Error);
  EXPECT_THROW(add_square(sum, lower), bempd::Error);
}

}  // namespace
