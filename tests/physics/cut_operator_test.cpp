#include <gtest/gtest.h>

#include "bem/boundary_loads.hpp"
#include "dense.hpp"
#include "physics/cracked_bodies.hpp"

// Operators of bodies that cracks cut into pieces.
namespace cut_operator_test {
namespace {

using namespace bempd;
using namespace bempd::crack_test;

const PlaneElasticity steel{210e9, 0.3, PlaneState::strain, 0.02};

struct Case {
  const char* name;
  std::vector<std::vector<Point>> cracks;
  int pieces;
};

std::vector<Case> cases() {
  return {{"straight cut", {{{-1, 0.2}, {1, 0.2}}}, 2},
          {"slanted cut", {{{-1, -0.3}, {1, 0.6}}}, 2},
          {"kinked cut", {{{-1, -0.3}, {0.1, 0.2}, {1, 0}}}, 2},
          {"corner cut off", {{{-1, 0.7}, {-0.4, 1.5}}}, 2},
          {"two cuts", {{{-1, 0.2}, {1, 0.2}}, {{-1, -0.5}, {1, -0.4}}}, 3},
          {"cut and a crack that ends at it", {{{-1, 0.2}, {1, 0.2}}, {{0.1, -0.6}, {0.2, 0.2}}}, 2},
          {"cut and a crack in a piece", {{{-1, 0.2}, {1, 0.2}}, {{-0.3, -0.6}, {0.4, -0.5}}}, 2},
          {"cross", {{{-1, 0.2}, {1, 0.2}}, {{0.1, -1.5}, {0.2, 1.5}}}, 4},
          {"crossing of a cut", {{{-1, 0.2}, {1, 0.2}}, {{0.1, -0.5}, {0.2, 0.7}}}, 2},
          {"star of three", {{{-1, 0.2}, {0, 0}}, {{0, 0}, {1, 0.3}}, {{0, 0}, {0, -1.5}}}, 3},
          {"fan from one mouth", {{{1, 0}, {-1, 0.5}}, {{-1, -0.5}, {1, 0}}, {{0.2, 0}, {1, 0}}}, 3}};
}

TEST(CutOperator, every_piece_has_three_rigid_motions) {
  for (const Case& c : cases()) {
    const CrackedBody body({plate(1, 1.5, 0.5)}, c.cracks, steel, 0.5);
    ASSERT_EQ(body.cracks.pieces.count, c.pieces) << c.name;
    for (const Eigen::MatrixXd* k : {&body.op->full_stiffness(), &body.op->stiffness()}) {
      const Eigen::VectorXd values = dense::eigenvalues(*k);
      const double largest = values[values.size() - 1];
      for (int i = 0; i < 3 * c.pieces; ++i) EXPECT_LE(std::abs(values[i]), 1e-14 * largest) << c.name;
      EXPECT_GE(values[3 * c.pieces], 1e-7 * largest) << c.name;
      std::printf("%s: %d pieces, zero modes up to %.1e, next %.1e\n", c.name, c.pieces,
                  values.head(3 * c.pieces).cwiseAbs().maxCoeff() / largest, values[3 * c.pieces] / largest);
    }
  }
}

TEST(CutOperator, linear_fields_pass_when_the_faces_carry_their_tractions) {
  Eigen::Matrix2d stress;
  stress << 3e6, -1e6, -1e6, 2e6;
  const double modulus = steel.young_modulus / (1 - 0.09), ratio = 0.3 / 0.7;
  Eigen::Matrix2d strain;
  strain << (stress(0, 0) - ratio * stress(1, 1)) / modulus, (1 + ratio) * stress(0, 1) / modulus,
      (1 + ratio) * stress(0, 1) / modulus, (stress(1, 1) - ratio * stress(0, 0)) / modulus;
  for (const Case& c : cases()) {
    const CrackedBody body({plate(1, 1.5, 0.5)}, c.cracks, steel, 0.5);
    const Eigen::MatrixXd& k = body.op->stiffness();
    Eigen::VectorXd u(k.rows());
    for (std::size_t n = 0; n < body.mesh.nodes.size(); ++n)
      u.segment<2>(2 * static_cast<Eigen::Index>(n)) = strain * body.mesh.nodes[n];
    const auto faces = [&](int, const Point&, const Point& n) -> Point { return stress * n; };
    const Eigen::VectorXd inner = bem::crack_forces(body.cracks, faces, steel.thickness);
    Eigen::VectorXd forces = body.op->forces_on_boundary(inner);
    bem::add_stress_forces(
        body.mesh, [&](const Point&) { return Eigen::Vector3d(stress(0, 0), stress(1, 1), stress(0, 1)); },
        steel.thickness, forces);
    EXPECT_LE((k * u - forces).cwiseAbs().maxCoeff(), 1e-10 * forces.cwiseAbs().maxCoeff()) << c.name;
    const Eigen::VectorXd openings = body.op->openings(u, inner);
    EXPECT_LE(openings.lpNorm<Eigen::Infinity>(), 1e-11 * u.lpNorm<Eigen::Infinity>()) << c.name;
    const Eigen::VectorXd tractions = body.op->tractions(u, openings);
    EXPECT_LE((tractions.segment<2>(0) - Point(1e6, -2e6)).norm(), 1e-9 * 3e6) << c.name;
    for (Eigen::Index i = 0; i < tractions.size() / 2; ++i)
      EXPECT_LE(tractions.segment<2>(2 * i).norm(), (1 + 1e-9) * 3.62e6) << c.name;
  }
}

// Growth to a cut takes what it can from the body before.
TEST(CutOperator, is_the_same_with_blocks_of_the_body_before) {
  const std::vector<CrackPath> grown{{1, {{-1, 0.2}, {0.6, 0.2}, {1, 0.2}}, 0, 1}, {2, {{-0.3, -0.6}, {0.4, -0.5}}}},
      whole{{1, {{-1, 0.2}, {0.6, 0.2}}}, {2, {{-0.3, -0.6}, {0.4, -0.5}}}},
      longer{grown[0], {2, {{-0.3, -0.6}, {0.4, -0.5}, {0.6, -0.5}}, 0, 1}};
  const CrackedBody before({plate(1, 1.5, 0.5)}, whole, steel, 0.5), cut({plate(1, 1.5, 0.5)}, grown, steel, 0.5),
      later({plate(1, 1.5, 0.5)}, longer, steel, 0.5);
  const auto expect_same = [](const CrackedBody& from, const CrackedBody& to) {
    const bem::CrackedOperator kept(to.mesh, to.cracks, steel, {}, from.op.get());
    const Eigen::MatrixXd& k = to.op->stiffness();
    EXPECT_LE((kept.stiffness() - k).cwiseAbs().maxCoeff(), 1e-11 * k.cwiseAbs().maxCoeff());
    EXPECT_LE(kept.kernel_evaluations(), to.op->kernel_evaluations());
    std::printf("%.2f of the kernels\n",
                static_cast<double>(kept.kernel_evaluations()) / static_cast<double>(to.op->kernel_evaluations()));
  };
  expect_same(before, cut);
  expect_same(cut, later);
}

}  // namespace
}  // namespace cut_operator_test
