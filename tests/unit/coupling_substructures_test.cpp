#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "coupling/lower_blocks.hpp"
#include "coupling/substructure_factor.hpp"

// Factors by nested substructures: solutions, and what one factor takes over from another.
namespace bempd::test {

namespace {

using namespace coupling;

// Square of cells with an operator each, on the nodes of a grid; the left side is held.
class Cells {
 public:
  explicit Cells(int side) : side_(side) {
    for (int cell = 0; cell < side * side; ++cell) stiffness_.push_back(random_stiffness(cell));
  }

  int nodes() const { return (side_ + 1) * (side_ + 1); }
  std::vector<Point> positions() const {
    std::vector<Point> places;
    for (int n = 0; n < nodes(); ++n) places.emplace_back(n % (side_ + 1), n / (side_ + 1));
    return places;
  }
  std::vector<char> prescribed() const {
    std::vector<char> held(2 * static_cast<std::size_t>(nodes()), 0);
    for (int n = 0; n < nodes(); n += side_ + 1) held[2 * n] = held[2 * n + 1] = 1;
    return held;
  }
  void change(int cell, int seed) { stiffness_[cell] = random_stiffness(seed); }

  std::unique_ptr<EquilibriumSystem> system(const EquilibriumSystem* before) const {
    std::vector<DenseOperator> operators;
    for (int cell = 0; cell < side_ * side_; ++cell) operators.push_back({nodes_of(cell), stiffness_[cell]});
    auto made = std::make_unique<EquilibriumSystem>(nodes(), std::move(operators), Terms(), prescribed());
    if (before) made->take_over(*before);
    made->factor().place_nodes(positions());
    Affine force = Affine::Zero(2 * nodes(), 2);
    for (int n = side_; n < nodes(); n += side_ + 1) force(2 * n, 1) = 1, force(2 * n + 1, 0) = std::sin(n);
    made->set_load(force, Affine::Zero(2 * nodes(), 2));
    return made;
  }

  Eigen::MatrixXd whole() const {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(2 * nodes(), 2 * nodes());
    for (int cell = 0; cell < side_ * side_; ++cell) {
      std::vector<int> dofs;
      for (const int n : nodes_of(cell)) dofs.insert(dofs.end(), {2 * n, 2 * n + 1});
      sum(dofs, dofs) += *stiffness_[cell];
    }
    return sum;
  }

 private:
  std::vector<int> nodes_of(int cell) const {
    const int first = cell / side_ * (side_ + 1) + cell % side_;
    return {first, first + 1, first + side_ + 1, first + side_ + 2};
  }
  // Stiffness that resists all motions.
  static std::shared_ptr<const Eigen::MatrixXd> random_stiffness(int seed) {
    std::mt19937 random(static_cast<unsigned>(seed) + 1U);
    std::uniform_real_distribution<double> number(-1, 1);
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(8, 8, [&] { return number(random); });
    return std::make_shared<const Eigen::MatrixXd>(a * a.transpose() + 0.1 * Eigen::MatrixXd::Identity(8, 8));
  }

  int side_;
  std::vector<std::shared_ptr<const Eigen::MatrixXd>> stiffness_;
};

Affine dense_solution(const Cells& cells, const Affine& force, const std::vector<HoldingSpring>& springs = {}) {
  Eigen::MatrixXd matrix = cells.whole();
  for (const HoldingSpring& s : springs) {
    const Eigen::Vector2d way(s.cosine, s.sine);
    matrix.block<2, 2>(2 * s.node, 2 * s.node) += s.stiffness * way * way.transpose();
  }
  std::vector<int> free;
  const std::vector<char> held = cells.prescribed();
  for (int dof = 0; dof < static_cast<int>(held.size()); ++dof)
    if (!held[static_cast<std::size_t>(dof)]) free.push_back(dof);
  Affine solution = Affine::Zero(force.rows(), 2);
  const Eigen::MatrixXd own = matrix(free, free);
  const Eigen::MatrixXd load = force(free, Eigen::all);
  const Eigen::MatrixXd answer = own.llt().solve(load);
  solution(free, Eigen::all) = answer;
  return solution;
}

double off(const Affine& a, const Affine& b) { return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff(); }

std::vector<MatrixPart> chain_of(const std::vector<std::shared_ptr<const Eigen::MatrixXd>>& links) {
  std::vector<MatrixPart> parts;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const int first = static_cast<int>(k);
    parts.push_back({links[k], nullptr, {}, {}, links[k].get(), {first, first + 1}, Point(first + 0.5, 0)});
  }
  return parts;
}

std::shared_ptr<const Eigen::MatrixXd> link(double stiffness, double to_ground) {
  Eigen::MatrixXd own(2, 2);
  own << stiffness + to_ground, -stiffness, -stiffness, stiffness + to_ground;
  return std::make_shared<const Eigen::MatrixXd>(own);
}

}  // namespace

TEST(LowerBlocks, sum_up_packed_triangles_as_full_matrices) {
  const Eigen::MatrixXd some = Eigen::MatrixXd::Random(4, 4), matrix = some * some.transpose();
  const std::vector<int> places{3, 0, 4, 1};
  PackedLower packed;
  packed.take(matrix);
  EXPECT_EQ(packed.entries.size(), 10U);
  LowerBlocks full(2, 3), half(2, 3);
  full.add(matrix, places), half.add(packed, places);
  const auto below = [](const Eigen::MatrixXd& sum) { return Eigen::MatrixXd(sum.triangularView<Eigen::Lower>()); };
  EXPECT_EQ(below(full.eliminated), below(half.eliminated));
  EXPECT_EQ(full.coupling, half.coupling);
  EXPECT_EQ(below(full.remaining), below(half.remaining));
  // The unknowns at 0 and 1 are eliminated; the matrix has them as its second and its last.
  EXPECT_EQ(half.eliminated(1, 0), matrix(3, 1));
  EXPECT_EQ(half.coupling(1, 0), matrix(1, 0));
  EXPECT_EQ(half.remaining(2, 1), matrix(2, 0));
  EXPECT_EQ(half.remaining(2, 2), matrix(2, 2));
}

TEST(Substructures, solve_like_a_dense_matrix) {
  for (const int side : {3, 4, 7}) {
    const Cells cells(side);
    const auto system = cells.system(nullptr);
    const Affine solution = system->solve();
    EXPECT_LT(off(solution, dense_solution(cells, system->load().force())), 1e-10) << side;
    EXPECT_EQ(system->counters().iterations, 2) << "the factor is one of the matrix itself";
  }
}

TEST(Substructures, taken_over_give_the_same_digits_as_fresh_ones) {
  Cells cells(9);
  auto before = cells.system(nullptr);
  before->solve();
  for (const int step : {1, 2, 3, 4}) {
    cells.change(40 + step, 1000 + step);  // as beside a tip that moves on
    auto next = cells.system(before.get()), fresh = cells.system(nullptr);
    const Affine taken = next->solve(), own = fresh->solve();
    EXPECT_EQ(taken, own) << step;
    EXPECT_LT(off(taken, dense_solution(cells, next->load().force())), 1e-10);
    before = std::move(next);
  }
  // Back to a state before: the factor follows the present operators, whatever came in between.
  Cells first(9);
  EXPECT_EQ(first.system(before.get())->solve(), first.system(nullptr)->solve());
}

TEST(Substructures, serve_when_springs_and_supports_change) {
  Cells cells(6);
  const auto before = cells.system(nullptr);
  before->solve();
  const std::vector<HoldingSpring> springs = {{10, 0.6, 0.8, 3.0, 0.0}, {24, 1.0, 0.0, 2.0, 0.0}};
  before->commit({}, springs);
  EXPECT_LT(off(before->solve(), dense_solution(cells, before->load().force(), springs)), 1e-10)
      << "by the stale factor";
  before->factor().forget();
  EXPECT_LT(off(before->solve(), dense_solution(cells, before->load().force(), springs)), 1e-10) << "by a new one";
  const auto next = cells.system(before.get());
  EXPECT_EQ(next->solve(), cells.system(nullptr)->solve()) << "a factor without these springs";
}

TEST(Substructures, are_computed_only_where_parts_changed) {
  std::vector<std::shared_ptr<const Eigen::MatrixXd>> links;
  for (int k = 0; k < 64; ++k) links.push_back(link(1 + 0.1 * k, 0.01));
  const std::array<Point, 2> box = {Point(0, 0), Point(64, 0)};
  const auto first = SubstructureFactor::of(chain_of(links), box, 65, nullptr);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->taken_over(), 0U);
  links[20] = link(7, 0.01);
  const auto second = SubstructureFactor::of(chain_of(links), box, 65, first.get());
  ASSERT_TRUE(second);
  // Substructures on the way from the changed part to the whole are new, one of each size.
  EXPECT_EQ(second->substructures(), first->substructures());
  EXPECT_LE(second->substructures() - second->taken_over(), 7U);
  EXPECT_GE(second->substructures() - second->taken_over(), 5U);
}

TEST(Substructures, know_their_last_right_hand_side) {
  std::vector<std::shared_ptr<const Eigen::MatrixXd>> links;
  for (int k = 0; k < 64; ++k) links.push_back(link(1 + 0.1 * k, 0.01));
  const std::array<Point, 2> box = {Point(0, 0), Point(64, 0)};
  const auto solved = [&](const SubstructureFactor* before, const Eigen::MatrixXd& rhs) {
    const auto factor = SubstructureFactor::of(chain_of(links), box, 65, before);
    Eigen::MatrixXd values = rhs;
    factor->solve_in_place(values);
    return values;
  };
  const auto first = SubstructureFactor::of(chain_of(links), box, 65, nullptr);
  Eigen::MatrixXd rhs = Eigen::VectorXd::LinSpaced(65, -1, 2), other = rhs;
  other.row(30) *= 2;
  Eigen::MatrixXd two(65, 2), once = rhs;
  two << rhs, other;
  first->solve_in_place(once);
  links[20] = link(7, 0.01);
  const Eigen::MatrixXd fresh = solved(nullptr, rhs), fresh_of_other = solved(nullptr, other);
  EXPECT_NE(fresh, once);
  EXPECT_EQ(solved(first.get(), rhs), fresh);
  EXPECT_EQ(solved(first.get(), other), fresh_of_other);
  EXPECT_LT((solved(first.get(), two).col(1) - fresh_of_other).cwiseAbs().maxCoeff(),
            1e-12 * fresh.cwiseAbs().maxCoeff());
  EXPECT_EQ(solved(first.get(), rhs), fresh);
}

TEST(Substructures, that_change_are_joined_last) {
  std::vector<std::shared_ptr<const Eigen::MatrixXd>> links;
  for (int k = 0; k < 256; ++k) links.push_back(link(1 + 0.1 * k, 0.01));
  const std::array<Point, 2> box = {Point(0, 0), Point(256, 0)};
  const auto factor_of = [&](const SubstructureFactor* before) {
    std::vector<MatrixPart> parts = chain_of(links);
    for (const std::size_t k : {20, 90, 200}) parts[k].changes = true;
    return SubstructureFactor::of(std::move(parts), box, 257, before);
  };
  const auto first = factor_of(nullptr);
  ASSERT_TRUE(first);
  links[20] = link(7, 0.01);
  const auto second = factor_of(first.get()), fresh = factor_of(nullptr);
  ASSERT_TRUE(second && fresh);
  EXPECT_EQ(second->substructures() - second->taken_over(), 2U) << "the one of the changing parts, and the whole";
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(257, 257);
  for (int k = 0; k < 256; ++k) matrix.block<2, 2>(k, k) += *links[static_cast<std::size_t>(k)];
  const Eigen::MatrixXd load = Eigen::VectorXd::LinSpaced(257, -1, 2);
  Eigen::MatrixXd taken = load, own = load;
  second->solve_in_place(taken);
  fresh->solve_in_place(own);
  EXPECT_EQ(taken, own);
  EXPECT_LT((matrix * taken - load).norm(), 1e-10 * load.norm());
}

TEST(Substructures, are_taken_over_with_equal_constraints) {
  const auto matrix = link(2, 0.5);
  const auto constraints = [](double gap, double place) {
    return std::make_shared<const ExactConstraints>(ExactConstraints{
        Eigen::MatrixXd::Constant(1, 2, gap), Eigen::MatrixXd::Constant(1, 1, 0.3), {Point(place, 0)}});
  };
  const auto part = [&](std::shared_ptr<const ExactConstraints> one, std::vector<Eigen::Index> closed) {
    return MatrixPart{matrix, std::move(one), std::move(closed), {}, matrix.get(), {0, 1}, Point(0, 0)};
  };
  EXPECT_TRUE(part(constraints(1, 2), {0}).is_made_as(part(constraints(1, 2), {0})));
  EXPECT_FALSE(part(constraints(1, 2), {0}).is_made_as(part(constraints(1.5, 2), {0})));
  EXPECT_FALSE(part(constraints(1, 2), {0}).is_made_as(part(constraints(1, 2.5), {0})));
  EXPECT_FALSE(part(constraints(1, 2), {0}).is_made_as(part(nullptr, {})));
  EXPECT_FALSE(part(constraints(1, 2), {0}).is_made_as(part(constraints(1, 2), {})));
}

TEST(Substructures, refuse_a_matrix_that_resists_nothing) {
  std::vector<std::shared_ptr<const Eigen::MatrixXd>> links(20, link(1, 0));
  const std::array<Point, 2> box = {Point(0, 0), Point(20, 0)};
  EXPECT_FALSE(SubstructureFactor::of(chain_of(links), box, 21, nullptr));
  links[3] = link(1, 1e-3);
  const auto factor = SubstructureFactor::of(chain_of(links), box, 21, nullptr);
  ASSERT_TRUE(factor);
  EXPECT_GT(factor->smallest_pivot_ratio(), 1e-8);
}

}  // namespace bempd::test
