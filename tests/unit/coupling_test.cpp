#include <gtest/gtest.h>

#include "coupling/equilibrium_system.hpp"
#include "coupling/rigid_motion.hpp"
#include "dense.hpp"
#include "error.hpp"
#include "unit/coupling_chain.hpp"

namespace {

using namespace bempd;
using namespace bempd::coupling;
using namespace bempd::test;

// Node 3 follows nodes 1 and 2 of the operator: the reduced matrix is T^T K T.
TEST(EquilibriumSystem, tied_nodes_follow_their_masters_also_after_breaks) {
  const Chain chain;
  NodeTies ties;
  ties.add(3, {{1, 0.3}, {2, 0.7}});
  EquilibriumSystem system(Chain::nodes, {chain.op}, chain.bonds, chain.prescribed, ties);
  EXPECT_TRUE(system.dense_bodies().contain(3));
  Affine force = Affine::Zero(10, 2), given = Affine::Zero(10, 2);
  for (int dof = 0; dof < 10; ++dof) force.row(dof) << std::cos(dof), std::sin(2 * dof);
  given.row(0) << 0.1, 0.2;
  given.row(9) << -0.3, 0.05;
  system.set_load(force, given);
  Eigen::MatrixXd expand = Eigen::MatrixXd::Identity(10, 10);
  expand.middleRows<2>(6).setZero();
  for (int c = 0; c < 2; ++c) expand(6 + c, 2 + c) = 0.3, expand(6 + c, 4 + c) = 0.7;
  const std::vector<int> free{1, 2, 3, 4, 5, 8};
  const auto expected = [&] {
    const Eigen::MatrixXd k = expand.transpose() * chain.full(system.stages().intact()) * expand;
    Affine u = given;
    const Affine rhs = expand.transpose() * force - k * given;
    const Affine solved = dense::solve(k(free, free), rhs(free, Eigen::all));
    for (std::size_t i = 0; i < free.size(); ++i) u.row(free[i]) = solved.row(static_cast<Eigen::Index>(i));
    return Affine(expand * u);
  };
  EXPECT_LE((system.solve() - expected()).cwiseAbs().maxCoeff(), 1e-10);

  const int broken[] = {0, 3};
  system.commit(system.stages().breaking(broken), {});
  const Affine solution = system.solve();
  EXPECT_LE((solution - expected()).cwiseAbs().maxCoeff(), 1e-10);

  // Nothing is left on the tied node, and the free unknowns balance.
  Eigen::VectorXd unbalanced = system.response().internal_force(solution.col(0)) - system.load().force().col(0);
  EXPECT_EQ(unbalanced.segment<2>(6).norm(), 0);
  for (int dof : free) EXPECT_LE(std::abs(unbalanced[dof]), 1e-10) << dof;
}

TEST(EquilibriumSystem, condensed_solution_equals_the_full_one_also_after_breaks) {
  const Chain chain;
  EquilibriumSystem system(Chain::nodes, {chain.op}, chain.bonds, chain.prescribed);
  Affine force = Affine::Zero(10, 2), given = Affine::Zero(10, 2);
  for (int dof = 0; dof < 10; ++dof) force.row(dof) << std::cos(dof), std::sin(2 * dof);
  given.row(0) << 0.1, 0.2;
  given.row(9) << -0.3, 0.05;
  system.set_load(force, given);
  EXPECT_LE((system.solve() - expected_solution(chain, system.stages().intact(), force, given)).cwiseAbs().maxCoeff(),
            1e-10);

  // Bond 3 ends on the prescribed node 4 in y, so its break changes the load too.
  const int broken[] = {0, 3};
  system.commit(system.stages().breaking(broken), {});
  const Affine after = system.solve();
  EXPECT_LE((after - expected_solution(chain, system.stages().intact(), force, given)).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_EQ(system.counters().dense_factorizations, 1);
  const Eigen::VectorXd residual = system.response().internal_force(after.col(1)) - force.col(1);
  for (int dof = 0; dof < 10; ++dof) {
    if (!chain.prescribed[dof]) {
      EXPECT_LE(std::abs(residual[dof]), 1e-10) << dof;
    }
  }
}

TEST(EquilibriumSystem, restored_state_solves_as_before_the_break) {
  const Chain chain;
  EquilibriumSystem system(Chain::nodes, {chain.op}, chain.bonds, chain.prescribed);
  Affine force = Affine::Zero(10, 2);
  force.col(1).setOnes();
  system.set_load(force, Affine::Zero(10, 2));
  const Affine before = system.solve();
  const std::vector<std::uint8_t> stages = system.stages().numbers();
  const int broken[] = {4};
  system.commit(system.stages().breaking(broken), {});
  EXPECT_GT((system.solve() - before).cwiseAbs().maxCoeff(), 1e-6);
  system.restore(stages, {});
  EXPECT_LE((system.solve() - before).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(EquilibriumSystem, softest_motion_is_the_one_that_nothing_resists) {
  Chain chain;
  chain.prescribed[9] = 0;
  EquilibriumSystem system(Chain::nodes, {chain.op}, chain.bonds, chain.prescribed);
  const int broken[] = {3, 4};  // node 4 hangs on one bond along x
  system.commit(system.stages().breaking(broken), {});
  const SoftMotion soft = system.motions().softest();
  EXPECT_LE(soft.resistance, 1e-15);
  EXPECT_NEAR(std::abs(soft.motion[9]), 1.0, 1e-9);
  EXPECT_LE(soft.motion.head(9).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(EquilibriumSystem, a_part_that_moves_freely_is_unsolvable) {
  Chain chain;
  chain.prescribed[9] = 0;
  EquilibriumSystem system(Chain::nodes, {chain.op}, chain.bonds, chain.prescribed);
  const int broken[] = {3, 4};
  system.commit(system.stages().breaking(broken), {});
  Affine force = Affine::Zero(10, 2);
  force.col(1).setOnes();
  system.set_load(force, Affine::Zero(10, 2));
  try {
    system.solve();
    FAIL() << "solved a mechanism";
  } catch (const Error& error) {
    EXPECT_EQ(error.failure(), Failure::unsolvable);
  }
}

const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const std::vector<int> corners{0, 1, 2, 3};

TEST(RigidMotion, names_what_supports_leave_free) {
  EXPECT_EQ(RigidMotion(square, corners, {}).describe(), "translate in x and y, and rotate");
  EXPECT_EQ(RigidMotion(square, corners, {{0, 1, 0}, {3, 1, 0}}).describe(), "translate in y");
  EXPECT_EQ(RigidMotion(square, corners, {{0, 1, 0}, {0, 0, 1}}).describe(), "rotate");
  EXPECT_EQ(RigidMotion(square, corners, {{0, 0, 1}, {1, 0, 1}}).describe(), "translate in x");
  EXPECT_EQ(RigidMotion(square, corners, {{0, 1, 0}, {0, 0, 1}, {1, 0, 1}}).free_count(), 0);
  EXPECT_EQ(RigidMotion(square, corners, {{0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {3, 0, 1}}).describe(), "rotate");
}

TEST(RigidMotion, missing_supports_complete_the_given_ones) {
  std::vector<HeldDirection> held{{0, 1, 0}};
  const RigidMotion motion(square, corners, held);
  EXPECT_EQ(motion.free_count(), 2);
  std::vector<HeldDirection> candidates;
  for (int node : corners) candidates.insert(candidates.end(), {{node, 1, 0}, {node, 0, 1}});
  for (const HeldDirection& h : motion.missing_supports(square, candidates)) held.push_back(h);
  EXPECT_EQ(held.size(), 3u);
  EXPECT_EQ(RigidMotion(square, corners, held).free_count(), 0);
}

TEST(RigidMotion, forces_in_equilibrium_do_no_work_on_it) {
  const RigidMotion motion(square, corners, {});
  Eigen::VectorXd force = Eigen::VectorXd::Zero(8);
  force << -1, -2, 1, -2, 1, 2, -1, 2;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(motion.work(k, square, corners, force), 0, 1e-14);
  force[0] += 1;
  double largest = 0;
  for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(motion.work(k, square, corners, force)));
  EXPECT_GT(largest, 0.1);
}

}  // namespace
