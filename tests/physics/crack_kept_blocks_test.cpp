// Bodies whose cracks have grown, built on what was known of them before, against the same built from nothing.
#include <gtest/gtest.h>

#include "physics/cracked_bodies.hpp"

namespace bempd::crack_test {
namespace crack_kept_blocks_test {
namespace {

const PlaneElasticity steel{210e9, 0.3, PlaneState::stress, 0.01};

using Paths = std::vector<CrackPath>;  // with what has grown at their starts and ends

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

// Every state of growth from the one before, which itself was built so.
void expect_same(const std::vector<Paths>& states, double element, double most_kernels) {
  std::unique_ptr<bem::CrackedOperator> before;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const CrackedBody body({plate(1, 1.5, element)}, states[k], steel, element);
    auto grown =
        std::make_unique<bem::CrackedOperator>(body.mesh, body.cracks, steel, bem::AssemblyOptions{}, before.get());
    EXPECT_LE(difference(grown->stiffness(), body.op->stiffness()), 1e-12) << k;
    EXPECT_LE(difference(grown->full_stiffness(), body.op->full_stiffness()), 1e-12) << k;
    EXPECT_LE(difference(grown->matrices().double_layer, body.op->matrices().double_layer), 1e-12) << k;
    EXPECT_EQ((grown->full_stiffness() - grown->full_stiffness().transpose()).cwiseAbs().maxCoeff(), 0) << k;
    if (before) {
      const double share = static_cast<double>(grown->kernel_evaluations()) / body.op->kernel_evaluations();
      std::printf("%d elements: %.2f of the kernels of a body built from nothing\n",
                  static_cast<int>(grown->elements().size()), share);
      EXPECT_LT(share, most_kernels) << k;
    }
    before = std::move(grown);
  }
}

TEST(KeptBlocks, give_the_operator_of_a_crack_that_grows_at_both_ends) {
  const Point a{-0.6, 0.15}, b{-0.5, 0.15}, c{-0.4, 0.1}, d{0.3, -0.1}, e{0.4, -0.1}, f{0.5, -0.05};
  expect_same({{{1, {c, d}}}, {{1, {b, c, d, e}, 1, 1}}, {{1, {a, b, c, d, e, f}, 2, 2}}}, 0.25, 0.6);
}

TEST(KeptBlocks, give_the_operator_where_a_tip_reaches_an_edge_and_another_crack) {
  const Point a{-0.4, 0.1}, b{0.6, 0}, c{0.9, 0}, d{1, 0}, p{0, 0.9}, q{0, 0.5}, r{0, 0.2}, s{0, 0.06};
  expect_same({{{1, {a, b}}, {2, {q, p}}},
               {{1, {a, b, c}, 0, 1}, {2, {r, q, p}, 1}},
               {{1, {a, b, c, d}, 0, 2}, {2, {s, r, q, p}, 2}}},
              0.25, 1);
}

TEST(KeptBlocks, know_nodes_by_place_whatever_their_numbers) {
  const CrackedBody one({plate(1, 1.5, 0.5)}, {{{-0.4, 0}, {0.3, 0}}, {{-0.2, 0.6}, {0.2, 0.6}}}, steel, 0.5);
  const CrackedBody other({plate(1, 1.5, 0.5)}, {{{-0.2, 0.6}, {0.2, 0.6}}, {{-0.4, 0}, {0.3, 0}}}, steel, 0.5);
  const bem::CrackedOperator from_other(one.mesh, one.cracks, steel, {}, other.op.get());
  EXPECT_LE(difference(from_other.full_stiffness(), one.op->full_stiffness()), 1e-13);
  EXPECT_EQ(from_other.kernel_evaluations(), 0);
  const bem::CrackedOperator again(one.mesh, one.cracks, steel, {}, &from_other);
  EXPECT_LE(difference(again.full_stiffness(), one.op->full_stiffness()), 1e-13);
  EXPECT_LE(difference(again.stiffness(), one.op->stiffness()), 1e-13);
}

TEST(KeptBlocks, are_not_taken_from_a_body_of_another_material_or_size) {
  const std::vector<std::vector<Point>> crack{{{-0.4, 0}, {0.3, 0}}};
  const CrackedBody body({plate(1, 1.5, 0.5)}, crack, steel, 0.5);
  const CrackedBody soft({plate(1, 1.5, 0.5)}, crack, {1e9, 0.2, PlaneState::stress, 0.01}, 0.5);
  const CrackedBody large({plate(2, 3, 0.5)}, crack, steel, 0.5);
  for (const CrackedBody* other : {&soft, &large}) {
    const bem::CrackedOperator built(body.mesh, body.cracks, steel, {}, other->op.get());
    EXPECT_TRUE(built.stiffness() == body.op->stiffness());
  }
}

}  // namespace
}  // namespace crack_kept_blocks_test
}  // namespace bempd::crack_test
