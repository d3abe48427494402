#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "bem/interior.hpp"
#include "dense.hpp"
#include "error.hpp"
#include "physics/cracked_bodies.hpp"

// Operators of bodies with cracks: rigid motions, signs, linear fields, and what lies beside cracks.
namespace crack_operator_test {
namespace {

using namespace bempd;
using namespace bempd::crack_test;

const PlaneElasticity steel{210e9, 0.3, PlaneState::strain, 0.02};

struct Case {
  const char* name;
  std::vector<std::vector<Point>> cracks;
};

std::vector<Case> cases() {
  return {{"inner crack", {{{-0.5, 0}, {0.5, 0.2}}}},
          {"kinked crack", {{{-0.5, 0}, {0.1, 0}, {0.4, 0.5}}}},
          {"near-closed kink", {{{-0.5, 0}, {0.3, 0}, {-0.4, 0.1}}}},
          {"edge crack", {{{-1, 0.2}, {0, 0.2}}}},
          {"crack that ends at an edge", {{{0, 0.3}, {1, 0.1}}}},
          {"crack from a corner", {{{-1, -1.5}, {-0.2, -0.4}}}},
          {"branch", {{{-0.6, 0}, {0.4, 0}}, {{0.1, 0}, {0.4, 0.6}}}},
          {"crossing", {{{-0.6, 0}, {0.4, 0}}, {{-0.1, -0.4}, {0.1, 0.6}}}},
          {"branched edge crack", {{{1, 0}, {0, 0}, {-0.5, -0.4}}, {{0, 0}, {-0.5, 0.4}}}},
          {"two cracks from one mouth", {{{1, 0}, {0, 0.5}}, {{0.1, -0.5}, {1, 0}}}}};
}

TEST(CrackedOperator, has_three_rigid_motions_and_nothing_negative) {
  for (const Case& c : cases()) {
    const CrackedBody body({plate(1, 1.5, 0.5)}, c.cracks, steel, 0.5);
    for (const Eigen::MatrixXd* k : {&body.op->full_stiffness(), &body.op->stiffness()}) {
      EXPECT_EQ((*k - k->transpose()).cwiseAbs().maxCoeff(), 0) << c.name;
      const Eigen::VectorXd values = dense::eigenvalues(*k);
      const double largest = values[values.size() - 1];
      for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(values[i]), 1e-14 * largest) << c.name;
      EXPECT_GE(values[3], 1e-6 * largest) << c.name;
    }
  }
}

TEST(CrackedOperator, linear_fields_pass_when_the_faces_carry_their_tractions) {
  Eigen::Matrix2d stress;
  stress << 3e6, -1e6, -1e6, 2e6;
  for (const Case& c : cases()) {
    const CrackedBody body({plate(1, 1.5, 0.5)}, c.cracks, steel, 0.5);
    const bem::CrackedState state = body.solve([&](const Point&) { return stress; },
                                               [&](int, const Point&, const Point& n) -> Point { return stress * n; });
    const double displacement = state.displacements.cwiseAbs().maxCoeff();
    EXPECT_LE(state.openings.cwiseAbs().maxCoeff(), 1e-12 * displacement) << c.name;
    for (const bem::StressIntensity& tip : body.tips(state)) EXPECT_LE(tip.factors.norm(), 1e-6 * 3e6) << c.name;
    EXPECT_LE((state.tractions.segment<2>(0) - Point(1e6, -2e6)).norm(), 1e-10 * 3e6) << c.name;
  }
}

// A path round a branch crosses all of its openings and comes back to the same face, so that they sum to zero.
TEST(CrackedOperator, openings_of_a_branch_sum_to_zero) {
  int branches = 0;
  for (const Case& c : cases()) {
    const CrackedBody body({plate(1, 1.5, 0.5)}, c.cracks, steel, 0.5);
    const bem::CrackedState state = body.solve(constant_stress(1e6, 2e6, 5e5));
    const double largest = state.openings.cwiseAbs().maxCoeff();
    std::vector<Point> sums(body.lines.joints.size(), Point::Zero());
    std::vector<double> opened(body.lines.joints.size(), 0);
    for (const bem::CrackElement& e : body.cracks.elements)
      for (const int end : {0, 2}) {
        const int joint = body.cracks.joint_of_node[e.nodes[end]];
        if (joint < 0) continue;
        const Point opening = state.openings.segment<2>(2 * e.nodes[end]);
        sums[joint] += (end == 0 ? -1.0 : 1.0) * opening;
        opened[joint] = std::max(opened[joint], opening.norm());
      }
    for (std::size_t j = 0; j < sums.size(); ++j) {
      if (body.lines.joints[j].mouth) continue;
      ++branches;
      EXPECT_LE(sums[j].norm(), 1e-12 * largest) << c.name;
      EXPECT_GE(opened[j], 0.05 * largest) << c.name;
    }
  }
  EXPECT_GE(branches, 3);
}

TEST(CrackedOperator, stress_along_a_crack_does_not_see_it) {
  const CrackedBody body({plate(1, 1.5, 0.5)}, {{{-0.5, 0}, {0.5, 0}}}, steel, 0.5);
  const bem::CrackedState state = body.solve(constant_stress(5e6, 0, 0));
  EXPECT_LE(state.openings.cwiseAbs().maxCoeff(), 1e-13 * state.displacements.cwiseAbs().maxCoeff());
  for (const double t : bem::stresses_along_crack(*body.op, state)) EXPECT_NEAR(t, 5e6, 1e-10 * 5e6);
}

TEST(CrackedOperator, is_bitwise_the_same_for_any_number_of_threads) {
  const CrackedBody body({plate(1, 1.5, 0.1)}, {{{-1, 0.2}, {0, 0.2}}}, steel, 0.1);
  const bem::CrackedOperator one(body.mesh, body.cracks, steel, {.threads = 1});
  const bem::CrackedOperator two(body.mesh, body.cracks, steel, {.threads = 2});
  EXPECT_TRUE(one.stiffness() == two.stiffness());
}

TEST(CrackedOperator, a_ring_of_cracks_makes_a_piece) {
  const std::vector<Point> ring{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}};
  EXPECT_EQ(CrackedBody({plate(1, 1.5, 0.5)}, {ring}, steel, 0.5).cracks.pieces.count, 2);
}

class BesideACrack : public ::testing::Test {
 protected:
  BesideACrack() : body({plate(1, 1.5, 0.25)}, {{{-0.4, -0.2}, {0.4, 0.3}}}, steel, 0.25) {
    state = body.solve(constant_stress(0, 1e6, 2e5));
    evaluator = std::make_unique<bem::InteriorEvaluator>(body.mesh, steel, state.displacements, state.tractions);
    evaluator->set_cracks(
        bem::CrackField(body.op->boundary(), body.cracks, steel.effective_poisson_ratio(), state.openings));
    along = Point(0.8, 0.5).normalized();
    left = Point(-along.y(), along.x());
  }
  // Opening at a node that is not next to a tip, and where it lies.
  std::pair<Point, Point> node(int n) const { return {body.cracks.nodes[n], state.openings.segment<2>(2 * n)}; }

  CrackedBody body;
  bem::CrackedState state;
  std::unique_ptr<bem::InteriorEvaluator> evaluator;
  Point along, left;
};

TEST_F(BesideACrack, displacements_jump_by_the_opening) {
  const double size = state.openings.cwiseAbs().maxCoeff();
  for (const int n : {1, 4, 5, 8, 9, 15}) {
    const auto [place, opening] = node(n);
    const Point jump =
        evaluator->displacement_at(place + 1e-9 * left) - evaluator->displacement_at(place - 1e-9 * left);
    EXPECT_LE((jump - opening).norm(), 1e-7 * size) << n;
  }
}

TEST_F(BesideACrack, stresses_stay_finite_and_nearly_free_of_traction) {
  // Middles of elements, 1e-1 to 1e-8 of their length away, on either side.
  for (const int n : {5, 7, 9, 11}) {
    for (const double gap : {1e-2, 1e-4, 1e-6, 1e-8, -1e-8, -1e-4}) {
      const Eigen::Vector3d s = evaluator->at(node(n).first + 0.1 * gap * left).stress;
      Eigen::Matrix2d stress;
      stress << s[0], s[2], s[2], s[1];
      EXPECT_LE((stress * left).norm(), (0.02 + 10 * std::abs(gap)) * 1e6) << n << " " << gap;
    }
  }
}

TEST_F(BesideACrack, the_field_ahead_of_a_tip_is_that_of_its_factors) {
  const bem::StressIntensity tip = body.tips(state)[1];
  const Point place = body.cracks.tips[1].place;
  for (const double r : {1e-5, 1e-7}) {
    const Eigen::Vector3d s = evaluator->at(place + r * along).stress;
    Eigen::Matrix2d stress;
    stress << s[0], s[2], s[2], s[1];
    const double scale = std::sqrt(2 * std::numbers::pi * r);
    EXPECT_NEAR(scale * left.dot(stress * left), tip.factors.x(), 4e-3 * tip.factors.norm());
    EXPECT_NEAR(scale * along.dot(stress * left), tip.factors.y(), 4e-3 * tip.factors.norm());
  }
}

TEST_F(BesideACrack, stress_at_a_tip_is_refused) {
  EXPECT_THROW(evaluator->at({0.4, 0.3}), Error);
  EXPECT_NO_THROW(evaluator->displacement_at({0.4, 0.3}));
}

}  // namespace
}  // namespace crack_operator_test
