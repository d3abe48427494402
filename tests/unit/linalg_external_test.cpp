// Systems that a solver from outside eliminates: here a dense one.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>
#include <numeric>

#include "linalg/external_cholesky.hpp"
#include "unit/linalg_matrices.hpp"

namespace {

using namespace bempd::linalg;
using namespace bempd::test;

class DenseSolver final : public ExternalSolver {
 public:
  void analyse(std::int64_t factor, const Matrix& lower, const Plan& plan) override {
    ++analyses;
    Part& part = parts[factor];
    std::vector<int> order = plan.order;
    if (order.empty()) {
      order.resize(static_cast<std::size_t>(lower.rows()));
      std::iota(order.begin(), order.end(), 0);
    }
    part.eliminated.assign(order.begin(), order.end() - plan.kept);
    part.kept.assign(order.end() - plan.kept, order.end());
  }
  bool factorize(std::int64_t factor, const Matrix& lower, int kept, Outcome& outcome) override {
    Part& part = parts.at(factor);
    EXPECT_EQ(static_cast<int>(part.kept.size()), kept);
    const Eigen::MatrixXd whole = Matrix(lower.selfadjointView<Eigen::Lower>());
    EXPECT_GE(whole.diagonal().minCoeff(), 0.5);
    EXPECT_LE(whole.diagonal().maxCoeff(), 2.0);
    part.inverse.compute(whole(part.eliminated, part.eliminated));
    if (part.inverse.info() != Eigen::Success) return false;
    part.coupling = whole(part.eliminated, part.kept);
    outcome.schur = whole(part.kept, part.kept) - part.coupling.transpose() * part.inverse.solve(part.coupling);
    outcome.smallest_pivot = part.inverse.matrixLLT().diagonal().cwiseAbs2().minCoeff();
    outcome.entries = static_cast<std::int64_t>(part.eliminated.size());
    return true;
  }
  void solve(std::int64_t factor, Eigen::MatrixXd& values) override {
    const Part& part = parts.at(factor);
    const Eigen::MatrixXd solutions = part.inverse.solve(Eigen::MatrixXd(values(part.eliminated, Eigen::all)));
    values(part.eliminated, Eigen::all) = solutions;
    values(part.kept, Eigen::all).setConstant(std::nan(""));
  }
  void reduce(std::int64_t factor, Eigen::MatrixXd& values, Eigen::MatrixXd& kept) override {
    Part& part = parts.at(factor);
    part.half = part.inverse.solve(Eigen::MatrixXd(values(part.eliminated, Eigen::all)));
    kept = values(part.kept, Eigen::all) - part.coupling.transpose() * part.half;
    values.setConstant(std::nan(""));
  }
  void expand(std::int64_t factor, const Eigen::MatrixXd& kept, Eigen::MatrixXd& values) override {
    const Part& part = parts.at(factor);
    values(part.eliminated, Eigen::all) = part.half - part.inverse.solve(Eigen::MatrixXd(part.coupling * kept));
  }
  void forget(std::int64_t factor) noexcept override { parts.erase(factor); }
  void end() noexcept override {}

  struct Part {
    std::vector<int> eliminated, kept;
    Eigen::LLT<Eigen::MatrixXd> inverse;
    Eigen::MatrixXd coupling, half;
  };
  std::map<std::int64_t, Part> parts;
  int analyses = 0;
};

// Spring lattice whose unknowns have stiffnesses from 1e-9 to 1e9.
SparseMatrix stiff_and_soft(int side) {
  const SpringLattice lattice(side, 3, 0.1);
  const SparseMatrix matrix = lattice.stiffness(lattice.intact());
  const Eigen::VectorXd units =
      waves(static_cast<int>(matrix.rows())).unaryExpr([](double w) { return std::pow(10, 4.5 * w); });
  return lower_triangle(units.asDiagonal() * matrix * units.asDiagonal());
}

std::vector<int> with_last(int count, const std::vector<int>& kept) {
  std::vector<int> order;
  for (const int i : shuffled(count, 3))
    if (std::find(kept.begin(), kept.end(), i) == kept.end()) order.push_back(i);
  order.insert(order.end(), kept.begin(), kept.end());
  return order;
}

class ExternalCholesky : public testing::TestWithParam<int> {
 protected:
  ExternalCholesky() {
    for (int k = 0; k < GetParam(); ++k) kept.push_back((7 * k + 3) % n);
    for (SparseCholesky* factor : {external.get(), own.get()}) {
      if (GetParam() > 0) factor->set_elimination_order(with_last(n, kept), GetParam());
      EXPECT_TRUE(factor->factorize(lower));
    }
  }
  const SparseMatrix lower = stiff_and_soft(6);
  const int n = static_cast<int>(lower.rows());
  std::vector<int> kept;
  const std::shared_ptr<DenseSolver> solver = std::make_shared<DenseSolver>();
  const std::unique_ptr<SparseCholesky> external = external_cholesky(solver, ""), own = own_cholesky(false);
  const Eigen::MatrixXd sides = Eigen::Map<const Eigen::MatrixXd>(waves(70 * n).eval().data(), n, 70);

  // Largest difference of two solutions, each unknown in its own unit.
  double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const {
    const Eigen::VectorXd units = lower.diagonal().cwiseSqrt();
    return relative_difference(units.asDiagonal() * a, units.asDiagonal() * b);
  }
};

TEST_P(ExternalCholesky, solves_as_the_own_one) {
  Eigen::MatrixXd expected = sides, solution = sides;
  own->solve_in_place(expected);
  external->solve_in_place(solution);
  EXPECT_LT(difference(solution, expected), 1e-11);
  EXPECT_GT(external->factor_nonzeros(), 0);
  EXPECT_GT(external->smallest_pivot_ratio(), 1e-4);
  const std::vector<int> some{5, n - 1, 0, 31};
  const Eigen::MatrixXd scale = lower.diagonal()(some).cwiseSqrt().asDiagonal();
  EXPECT_LT(
      relative_difference(scale * external->inverse_block(some) * scale, scale * own->inverse_block(some) * scale),
      1e-11);
}

TEST_P(ExternalCholesky, condenses_onto_kept_unknowns_and_back) {
  if (kept.empty()) return;
  const auto count = static_cast<int>(kept.size());
  const Eigen::MatrixXd factor = external->trailing_factor(count);
  Eigen::MatrixXd whole = sides, halves = sides;
  external->solve_in_place(whole);
  external->solve_forward(halves);
  EXPECT_LT(relative_difference(external->inverse_block(kept), own->inverse_block(kept)), 1e-10);
  // The Schur complement is the inverse of the inverse's block.
  const Eigen::MatrixXd block = own->inverse_block(kept), units = lower.diagonal()(kept).cwiseSqrt().asDiagonal();
  const Eigen::MatrixXd unit = units * block * (factor * factor.transpose()) * units.inverse();
  EXPECT_LT((unit - Eigen::MatrixXd::Identity(count, count)).cwiseAbs().maxCoeff(), 1e-9);
  const std::vector<int>& order = external->elimination_order();
  for (const int known : {0, count / 2, count}) {
    Eigen::MatrixXd unknowns = halves.transpose();
    unknowns.rightCols(known) = Eigen::MatrixXd(whole.transpose()(Eigen::all, order)).rightCols(known);
    external->solve_backward(unknowns, known);
    Eigen::MatrixXd found(n, unknowns.rows());
    found(order, Eigen::all) = unknowns.transpose();
    EXPECT_LT(difference(found, whole), 1e-10) << known;
  }
}

TEST_P(ExternalCholesky, has_products_of_halves_as_the_own_one) {
  if (kept.empty()) return;
  const SparseCholesky::TwoColumns loads = sides.leftCols(2);
  const auto products = [&](const SparseCholesky& factor) {
    Eigen::MatrixXd functions = sides;
    SparseCholesky::TwoColumns forces = loads;
    factor.solve_forward(functions);
    factor.solve_forward(forces);
    return factor.eliminated_products(functions, forces, static_cast<int>(kept.size()));
  };
  const Eigen::MatrixXd expected = products(*own);
  if (static_cast<int>(kept.size()) == n) {
    EXPECT_EQ(products(*external).cwiseAbs().maxCoeff(), 0);
  } else {
    EXPECT_LT(relative_difference(products(*external), expected), 1e-10);
  }
}

// Changes of two kinds, one after the other, as a run makes them, against factors of the changed matrices.
TEST_P(ExternalCholesky, follows_changes) {
  SparseMatrix changed = lower;
  const Eigen::VectorXd units = lower.diagonal().cwiseSqrt();
  const Eigen::VectorXd weights = waves(3 * n);
  for (int round = 0; round < 4; ++round) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < 5; ++k)
      for (int e = 0; e < 3; ++e) {
        const int unknown = (11 * round + 7 * k + 5 * e) % n;
        entries.emplace_back(unknown, k, 0.1 * units[unknown] * weights[(k + 3 * e + round) % n]);
      }
    SparseMatrix columns(n, 5);
    columns.setFromTriplets(entries.begin(), entries.end());
    const Change change = round % 2 == 0 ? Change::remove : Change::add;
    const SparseMatrix square = lower_triangle(columns * columns.transpose());
    changed = change == Change::add ? SparseMatrix(changed + square) : SparseMatrix(changed - square);
    ASSERT_TRUE(external->update(columns, change) && own->factorize(changed)) << round;
    Eigen::MatrixXd expected = sides, solution = sides;
    own->solve_in_place(expected);
    external->solve_in_place(solution);
    EXPECT_LT(difference(solution, expected), 1e-10) << round;
    std::vector<int> some = kept.empty() ? std::vector<int>{1, 4} : kept;
    const Eigen::MatrixXd scale = units(some).asDiagonal();
    EXPECT_LT(
        relative_difference(scale * external->inverse_block(some) * scale, scale * own->inverse_block(some) * scale),
        1e-9);
  }
  EXPECT_GT(external->smallest_pivot_ratio(), 1e-4);
}

// A motion that keeps nothing, or next to nothing: the factor stays the one of before.
TEST_P(ExternalCholesky, does_not_follow_a_removal_that_leaves_a_motion_free) {
  const Eigen::VectorXd motion = waves(n);
  const Eigen::VectorXd force = lower.selfadjointView<Eigen::Lower>() * motion;
  Eigen::MatrixXd before = sides;
  external->solve_in_place(before);
  for (const double left : {0.0, 1e-12, 1e-10}) {
    const SparseMatrix column = (force * std::sqrt((1 - left) / motion.dot(force))).sparseView();
    EXPECT_FALSE(external->update(column, Change::remove)) << left;
    Eigen::MatrixXd after = sides;
    external->solve_in_place(after);
    EXPECT_EQ((after - before).cwiseAbs().maxCoeff(), 0) << left;
  }
  const SparseMatrix column = (force * std::sqrt((1 - 1e-6) / motion.dot(force))).sparseView();
  EXPECT_TRUE(external->update(column, Change::remove));
  EXPECT_NEAR(external->smallest_pivot_ratio(), 1e-6, 1e-8);
  EXPECT_TRUE(external->factorize(lower));
  EXPECT_GT(external->smallest_pivot_ratio(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Kept, ExternalCholesky, testing::Values(0, 1, 20, 72));

TEST(ExternalSolver, keeps_its_analysis_while_the_pattern_stays) {
  const auto solver = std::make_shared<DenseSolver>();
  const auto factor = external_cholesky(solver, "");
  const SparseMatrix lower = stiff_and_soft(4);
  EXPECT_TRUE(factor->factorize(lower) && factor->factorize(SparseMatrix(2 * lower)));
  EXPECT_EQ(solver->analyses, 1);
  factor->set_elimination_order(with_last(static_cast<int>(lower.rows()), {3}), 1);
  EXPECT_TRUE(factor->factorize(lower));
  EXPECT_EQ(solver->analyses, 2);
  EXPECT_EQ(solver->parts.size(), 1u);
}

TEST(ExternalSolver, refuses_matrices_that_are_not_positive_definite) {
  const auto factor = external_cholesky(std::make_shared<DenseSolver>(), "");
  SparseMatrix lower = stiff_and_soft(4);
  const int last = static_cast<int>(lower.rows()) - 1;
  for (const int kept : {0, 1, last + 1}) {
    std::vector<int> order(static_cast<std::size_t>(last) + 1);
    std::iota(order.begin(), order.end(), 0);
    factor->set_elimination_order(order, kept);
    for (const double bad : {-1.0, 0.0, 1e-20, std::nan("")}) {
      SparseMatrix spoilt = lower;
      spoilt.coeffRef(last, last) = bad;
      EXPECT_FALSE(factor->factorize(spoilt)) << kept << ' ' << bad;
    }
    EXPECT_TRUE(factor->factorize(lower));
  }
}

}  // namespace
