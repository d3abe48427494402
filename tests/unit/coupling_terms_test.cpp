// Terms of any shape, laws of several stages, rest elongations and constant forces, each against dense algebra.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "coupling/condensation.hpp"
#include "coupling/equilibrium_system.hpp"
#include "dense.hpp"
#include "error.hpp"

namespace {

using namespace bempd;
using namespace bempd::coupling;

// Nodes 0 1 2 carry a dense operator; 5 follows 0 and 1 of it; bonds join 2 to 6, a cell joins 3 4 5 6 and a contact
// presses node 4 against the edge from 1 to 2.
class Mixed {
 public:
  static constexpr int nodes = 7, dofs = 2 * nodes;
  static constexpr int cell = 4;

  Mixed() {
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(6, 6, [](Eigen::Index i, Eigen::Index j) {
      return std::sin(static_cast<double>(3 * i * j + i * i + 7 * j + 1));
    });
    op.nodes = {0, 1, 2};
    op.stiffness = std::make_shared<const Eigen::MatrixXd>(a * a.transpose() + Eigen::MatrixXd::Identity(6, 6));
    ties.add(5, {{0, 0.4}, {1, 0.6}});
    terms.add_bond(2, 3, {1, 0}, 1, 3.0);
    terms.add_bond(2, 4, {0.6, 0.8}, 2, 2.0);
    terms.add_bond(3, 4, {0, 1}, 1, 5.0);
    terms.add_bond(5, 4, {-0.8, 0.6}, 1, 4.0);
    const TermEntry of_cell[] = {{3, 0.5, -0.5}, {4, 0.5, 0.5}, {5, -0.5, 0.5}, {6, -0.5, -0.5}};
    EXPECT_EQ(terms.add_wide(of_cell, 1, 2.5), cell);
    terms.add_bond(3, 6, {0.8, 0.6}, 1, 1.5);
    terms.add_bond(4, 6, {0, 1}, 1, 2.0);
    const TermEntry contact[] = {{4, 0, 1}, {1, 0, -0.3}, {2, 0, -0.7}};
    terms.add_wide(contact, 1, 6.0);
    prescribed[0] = prescribed[13] = 1;
    for (int dof = 0; dof < dofs; ++dof) force.row(dof) << std::cos(dof), std::sin(2 * dof);
    given.row(0) << 0.1, 0.2;
    given.row(13) << -0.3, 0.05;
  }

  Eigen::VectorXd coefficients(std::size_t term) const {
    Eigen::VectorXd c = Eigen::VectorXd::Zero(dofs);
    terms.for_each_entry(term, [&](int node, double x, double y) { c.segment<2>(2 * node) += Eigen::Vector2d(x, y); });
    return c;
  }

  Eigen::MatrixXd stiffness(const std::vector<double>& present) const {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(dofs, dofs);
    matrix.topLeftCorner<6, 6>() = *op.stiffness;
    for (std::size_t t = 0; t < terms.size(); ++t) {
      matrix += present[t] * coefficients(t) * coefficients(t).transpose();
    }
    return matrix;
  }

  // Forces where nothing moves.
  Affine offsets(const std::vector<double>& present) const {
    Affine f = Affine::Zero(dofs, 2);
    if (op.rest.rows() > 0) f.topRows<6>() -= *op.stiffness * op.rest;
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (present[t] == 0) continue;
      for (int part = 0; part < 2; ++part) {
        f.col(part) += -present[t] * terms.rest(t, part) * coefficients(t);
      }
    }
    return f;
  }

  Eigen::MatrixXd expand() const {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(dofs, dofs);
    matrix.middleRows<2>(10).setZero();
    for (int c = 0; c < 2; ++c) matrix(10 + c, c) = 0.4, matrix(10 + c, 2 + c) = 0.6;
    return matrix;
  }

  Affine expected(const std::vector<double>& present) const {
    const std::vector<int> free{1, 2, 3, 4, 5, 6, 7, 8, 9, 12};
    const Eigen::MatrixXd all = expand(), k = all.transpose() * stiffness(present) * all;
    const Affine rhs = all.transpose() * (force - offsets(present)) - k * given;
    const Affine solved = dense::solve(k(free, free), rhs(free, Eigen::all));
    Affine u = given;
    for (std::size_t i = 0; i < free.size(); ++i) u.row(free[i]) = solved.row(static_cast<Eigen::Index>(i));
    return all * u;
  }

  void pull_without_elongation() {
    terms.set_rest_elongation(1, 0.2, -0.4);
    terms.set_rest_elongation(cell, 0.3);
    terms.set_rest_elongation(3, 0, 0.7);
    terms.set_rest_elongation(2, -1.1);
    terms.set_rest_elongation(7, 0.4, 0.6);
    op.rest = Affine::NullaryExpr(6, 2, [](Eigen::Index i, Eigen::Index j) { return 0.1 * std::cos(i + 2.0 * j); });
  }

  DenseOperator op;
  Terms terms;
  NodeTies ties;
  std::vector<char> prescribed = std::vector<char>(dofs, 0);
  Affine force = Affine::Zero(dofs, 2), given = Affine::Zero(dofs, 2);
};

double difference(const Affine& a, const Affine& b) { return (a - b).cwiseAbs().maxCoeff(); }

TEST(Terms, of_many_nodes_have_one_elongation_and_their_own_nodes) {
  const Mixed mixed;
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(Mixed::dofs, -1, 2).array().sin();
  for (std::size_t t = 0; t < mixed.terms.size(); ++t) {
    EXPECT_NEAR(mixed.terms.elongation(t, u.data()), mixed.coefficients(t).dot(u), 1e-15) << t;
    int visited = 0;
    mixed.terms.for_each_node(t, [&](int) { ++visited; });
    EXPECT_EQ(visited, t == Mixed::cell ? 4 : t == 7 ? 3 : 2) << t;
  }
}

TEST(Terms, shares_of_the_critical_elongation_are_those_of_single_terms) {
  Mixed mixed;
  mixed.pull_without_elongation();
  const std::size_t count = mixed.terms.size();
  const std::vector<double> critical{0.1, 0.2, 0.3, 0.4, 0.5, HUGE_VAL, 0.7, 0.8};
  std::vector<double> shares[2] = {std::vector<double>(count), std::vector<double>(count)};
  const Affine u = mixed.force;
  mixed.terms.critical_shares(u, mixed.terms.critical_scales(critical), shares[0], shares[1]);
  for (std::size_t t = 0; t < count; ++t) {
    for (int part = 0; part < 2; ++part) {
      const double elastic = mixed.coefficients(t).dot(u.col(part)) - mixed.terms.rest(t, part);
      EXPECT_NEAR(shares[part][t], elastic / (mixed.terms.length[t] * critical[t]), 1e-13) << t;
    }
  }
}

TEST(EquilibriumSystem, terms_of_many_nodes_take_part_in_everything) {
  const Mixed mixed;
  EquilibriumSystem system(Mixed::nodes, {mixed.op}, mixed.terms, mixed.prescribed, mixed.ties);
  std::vector<Point> places;
  for (int n = 0; n < Mixed::nodes; ++n) places.emplace_back(n % 3, n / 3);
  system.factor().place_nodes(places);
  system.factor().keep_last({3, 4});
  system.set_load(mixed.force, mixed.given);
  EXPECT_LE(difference(system.solve(), mixed.expected(system.stages().stiffness())), 1e-11);

  const Condensation condensation(system);
  ASSERT_EQ(condensation.dofs().size(), 4u);
  const Affine before = system.solve();
  EXPECT_LE(difference(condensation.displacement(before(condensation.dofs(), Eigen::all)), before), 1e-11);

  const int broken[] = {Mixed::cell, 1};
  system.commit(system.stages().breaking(broken), {});
  EXPECT_TRUE(system.motions().resists_all(broken));
  const Affine after = system.solve();
  EXPECT_LE(difference(after, mixed.expected(system.stages().stiffness())), 1e-11);
  EXPECT_GT(difference(after, before), 1e-3);
  EXPECT_EQ(system.counters().sparse_factorizations, 1);
  const Eigen::VectorXd unbalanced = system.response().internal_force(after.col(1)) - system.load().force().col(1);
  for (int dof = 0; dof < Mixed::dofs; ++dof) {
    if (mixed.prescribed[dof]) continue;
    EXPECT_LE(std::abs(unbalanced[dof]), 1e-11) << dof;
  }
}

TEST(EquilibriumSystem, rest_elongations_load_it_also_after_breaks) {
  Mixed mixed;
  mixed.pull_without_elongation();
  EquilibriumSystem system(Mixed::nodes, {mixed.op}, mixed.terms, mixed.prescribed, mixed.ties);
  system.set_load(mixed.force, mixed.given);
  EXPECT_LE(difference(system.solve(), mixed.expected(system.stages().stiffness())), 1e-11);
  const int broken[] = {2, 3};
  system.commit(system.stages().breaking(broken), {});
  const Affine after = system.solve();
  EXPECT_LE(difference(after, mixed.expected(system.stages().stiffness())), 1e-11);
  const double load_factor = 1.7;
  const Eigen::VectorXd unbalanced = system.response().internal_force(evaluate(after, load_factor), load_factor) -
                                     evaluate(system.load().force(), load_factor);
  for (int dof = 0; dof < Mixed::dofs; ++dof) {
    if (mixed.prescribed[dof]) continue;
    EXPECT_LE(std::abs(unbalanced[dof]), 1e-11) << dof;
  }
}

// Alone, without loads and supports that move, they are a load too.
TEST(EquilibriumSystem, rest_displacement_of_an_operator_alone_moves_it) {
  Mixed mixed;
  mixed.op.rest = Affine::Constant(6, 2, 0.25);
  mixed.force.setZero(), mixed.given.setZero();
  EquilibriumSystem system(Mixed::nodes, {mixed.op}, mixed.terms, mixed.prescribed, mixed.ties);
  const Affine u = system.solve();
  EXPECT_LE(difference(u, mixed.expected(system.stages().stiffness())), 1e-11);
  EXPECT_GT(u.cwiseAbs().maxCoeff(), 0.1);
}

// The internal force is the gradient of the energy; central differences of a quadratic function are exact.
TEST(EquilibriumSystem, energy_is_the_potential_of_internal_forces) {
  Mixed mixed;
  mixed.pull_without_elongation();
  EquilibriumSystem system(Mixed::nodes, {mixed.op}, mixed.terms, mixed.prescribed);
  system.set_load(mixed.force, mixed.given);
  system.solve();
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(Mixed::dofs, -1, 2).array().cos();
  const double load_factor = 0.6;
  const Eigen::VectorXd force = system.response().internal_force(u, load_factor);
  for (int dof = 0; dof < Mixed::dofs; ++dof) {
    const Eigen::VectorXd step = 0.5 * Eigen::VectorXd::Unit(Mixed::dofs, dof);
    EXPECT_NEAR(system.response().energy(u + step, load_factor) - system.response().energy(u - step, load_factor),
                force[dof], 1e-12)
        << dof;
  }
}

TEST(Terms, know_whether_all_that_are_wide_follow_others) {
  Terms terms;
  EXPECT_TRUE(terms.wide_terms_only_follow());
  const int bond = terms.add_bond(0, 1, {1, 0}, 1, 1);
  const std::array<TermEntry, 3> entries{TermEntry{0, 1, 0}, {1, -1, 0}, {2, 0, 1}};
  const int follower = terms.add_wide(entries, 1, 1);
  EXPECT_FALSE(terms.wide_terms_only_follow());
  terms.add_follower(follower, std::array{bond});
  EXPECT_TRUE(terms.wide_terms_only_follow());
  terms.add_wide(entries, 1, 1);
  EXPECT_FALSE(terms.wide_terms_only_follow());
}

TEST(TermLaw, stages_follow_each_other_until_the_term_is_gone) {
  const TermLaw law({{1, 1}, {0.4, 3}});
  EXPECT_EQ(law.broken_stage(), 2);
  EXPECT_EQ(law.after_critical(0), 1);
  EXPECT_EQ(law.after_critical(1), 2);
  EXPECT_EQ(law.after_critical(2), 2);
  EXPECT_EQ(law.stiffness_share(1), 0.4);
  EXPECT_EQ(law.stiffness_share(2), 0);
  EXPECT_EQ(law.critical_share(1), 3);
  EXPECT_EQ(law.critical_share(2), HUGE_VAL);
  EXPECT_THROW(TermLaw({}), Error);
  EXPECT_THROW(TermLaw({{1, 0}}), Error);
  EXPECT_THROW(TermLaw({{std::nan(""), 1}}), Error);
}

TEST(EquilibriumSystem, stages_change_the_factor_by_the_drop_of_stiffness) {
  Mixed mixed;
  const int softening = mixed.terms.add_law(TermLaw({{1, 1}, {0.4, 3}, {0.1, 5}}));
  const int hardening = mixed.terms.add_law(TermLaw({{0.5, 1}, {2, 3}}));
  mixed.terms.set_law(2, softening);
  mixed.terms.set_law(Mixed::cell, hardening);
  EquilibriumSystem system(Mixed::nodes, {mixed.op}, mixed.terms, mixed.prescribed, mixed.ties);
  EXPECT_EQ(system.stages().stiffness()[Mixed::cell], 0.5 * 2.5);
  EXPECT_EQ(system.stages().stiffness()[1], 2.0);
  system.set_load(mixed.force, mixed.given);
  const Affine before = system.solve();
  EXPECT_LE(difference(before, mixed.expected(system.stages().stiffness())), 1e-11);

  const StageChange changes[] = {system.stages().after_critical(2), system.stages().after_critical(Mixed::cell),
                                 system.stages().after_critical(1)};
  system.stages().mark(changes);
  system.commit(changes, {});
  EXPECT_EQ(system.stages().stiffness()[2], 0.4 * 5.0);
  EXPECT_EQ(system.stages().stiffness()[Mixed::cell], 2 * 2.5);
  EXPECT_EQ(system.stages().stiffness()[1], 0);
  EXPECT_TRUE(system.stages().intact()[2] && system.stages().intact()[Mixed::cell]);
  EXPECT_FALSE(system.stages().intact()[1]);
  EXPECT_EQ(system.stages().numbers()[2], 1);
  const Affine after = system.solve();
  EXPECT_LE(difference(after, mixed.expected(system.stages().stiffness())), 1e-11);
  EXPECT_EQ(system.counters().sparse_factorizations, 1);
  EXPECT_EQ(system.counters().factor_updates, 3);

  // Stages that are set leave the factor alone; coming back, it is the present matrix' again.
  const StageChange there[] = {{2, 3}}, back[] = {{2, 1}};
  system.stages().enter(there);
  EXPECT_FALSE(system.stages().intact()[2]);
  system.stages().enter(back);
  EXPECT_EQ(difference(system.solve(), after), 0);

  system.restore(std::vector<std::uint8_t>(mixed.terms.size(), 0), {});
  EXPECT_LE(difference(system.solve(), before), 1e-12);
}

}  // namespace
