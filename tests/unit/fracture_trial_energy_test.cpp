// The energy of a trial step against the potential energies of two equilibria, each solved by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "coupling/term_flexibility.hpp"
#include "fracture/line/trial_energy.hpp"
#include "fracture/line/trial_steps.hpp"

namespace fracture_trial_energy_test {
namespace {

using namespace bempd;
using coupling::Affine;
using coupling::EquilibriumSystem;
using coupling::Terms;

constexpr int side = 15;

int node(int x, int y) { return side * y + x; }

// Points with bonds to the eight neighbours and squares that follow some of them; the left is held, the right moved by
// the load factor and pulled by a constant, and some bonds want to be longer.
Terms plate() {
  Terms all;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
        if (x + a < 0 || x + a >= side || y + b >= side) continue;
        const Eigen::Vector2d way(a, b);
        all.add_bond(node(x, y), node(x + a, y + b), way.normalized(), way.norm(), 1 + 0.2 * std::sin(3.0 * x + y));
      }
  const int bonds = static_cast<int>(all.size());
  for (int t = 0; t < bonds; t += 7) all.set_rest_elongation(t, 1e-3, 2e-3);
  for (int x = 2; x < side - 3; x += 2) {
    const coupling::TermEntry square[]{
        {node(x, 7), 1, 0}, {node(x + 1, 7), 0, -1}, {node(x, 8), 0, 1}, {node(x + 1, 8), -1, 0}};
    const int leader[]{4 * side * 7};
    all.add_follower(all.add_wide(square, 1, 0.3), leader);
  }
  return all;
}

struct Body {
  explicit Body(bool supports_move) : system(side * side, {}, plate(), held(supports_move)) {
    Affine force = Affine::Zero(2 * side * side, 2), moved = force;
    for (int y = 0; y < side; ++y) {
      const int right = node(side - 1, y);
      if (supports_move) {
        moved.row(2 * right) << 0.05, 1;
      } else {
        force.row(2 * right) << 0.02, 0.1;
        force.row(2 * right + 1) << 0, 0.03;
      }
    }
    system.set_load(force, moved);
    system.contact().add({{{node(3, 3), 0, -1}, {node(3, 4), 0, 1}}, 5});
    const int places[]{0};
    system.contact().switch_over(places);
  }
  static std::vector<char> held(bool right_too) {
    std::vector<char> dofs(2 * side * side, 0);
    for (int y = 0; y < side; ++y)
      for (int c = 0; c < 2; ++c) {
        dofs[static_cast<std::size_t>(2 * node(0, y) + c)] = 1;
        if (right_too) dofs[static_cast<std::size_t>(2 * node(side - 1, y) + c)] = 1;
      }
    return dofs;
  }
  double potential(double load_factor) {
    const Eigen::VectorXd u = coupling::evaluate(system.solve(), load_factor);
    return system.response().energy(u, load_factor) - coupling::evaluate(system.load().force(), load_factor).dot(u);
  }

  EquilibriumSystem system;
};

// Bonds that cross the way along the middle row, from the left on.
std::vector<int> step_of(const Terms& terms) {
  std::vector<int> found;
  for (int x = 4; x < 9; ++x)
    for (std::size_t t = 0; t < terms.size(); ++t)
      if (!terms.is_wide(t) && terms.first[t] == node(x, 7) && terms.sine[t] > 0) found.push_back(static_cast<int>(t));
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (terms.is_wide(t)) found.push_back(static_cast<int>(t));
  return found;
}

TEST(TrialEnergy, is_the_difference_of_the_energies_of_two_equilibria) {
  for (const bool supports_move : {false, true}) {
    Body body(supports_move);
    const Terms& terms = body.system.terms();
    const std::vector<int> step = step_of(terms);
    const Affine displacement = body.system.solve();
    const auto count = static_cast<Eigen::Index>(step.size());
    Eigen::VectorXd stiffness(count);
    Affine elongation(count, 2);
    for (Eigen::Index k = 0; k < count; ++k) {
      const auto t = static_cast<std::size_t>(step[static_cast<std::size_t>(k)]);
      stiffness[k] = terms.stiffness[t];
      for (int part = 0; part < 2; ++part)
        elongation(k, part) = terms.elastic_elongation_part(t, displacement.col(part).data(), part);
    }
    const Eigen::MatrixXd flexibility = coupling::flexibility_of(body.system, step);
    const Eigen::MatrixXd apart = coupling::flexibility_by_temporary_factor(body.system, step);
    EXPECT_LE((flexibility - apart).norm(), 1e-11 * flexibility.norm());
    const fracture::TrialEnergy trial(stiffness, flexibility, elongation);
    ASSERT_EQ(trial.count(), count);
    for (const Eigen::Index taken : {Eigen::Index(1), Eigen::Index(7), count}) {
      Body cut(supports_move);
      cut.system.solve();
      std::vector<coupling::StageChange> changes;
      for (Eigen::Index k = 0; k < taken; ++k) changes.push_back({step[static_cast<std::size_t>(k)], 1});
      cut.system.commit(changes, {});
      for (const double load_factor : {-0.4, 1.0, 3.0}) {
        const double released = body.potential(load_factor) - cut.potential(load_factor);
        const double found = trial.released(taken, load_factor);
        std::printf("%d terms at %g: %.12g, by two equilibria %.12g\n", static_cast<int>(taken), load_factor, found,
                    released);
        EXPECT_NEAR(found, released, 1e-9 * std::abs(released));
        const Eigen::VectorXd u = coupling::evaluate(cut.system.solve(), load_factor);
        const Eigen::VectorXd left = trial.elongations_without(taken, load_factor);
        for (Eigen::Index k = 0; k < taken; ++k)
          EXPECT_NEAR(left[k],
                      terms.elastic_elongation(static_cast<std::size_t>(step[static_cast<std::size_t>(k)]), u.data(),
                                               load_factor),
                      1e-9 * left.cwiseAbs().maxCoeff());
      }
    }
    // The flexibility after a change of the matrix by low rank is that of the changed body.
    const std::vector<coupling::StageChange> first{{step[0], 1}};
    body.system.commit(first, {});
    const std::vector<int> others(step.begin() + 1, step.end());
    EXPECT_LE(
        (coupling::flexibility_of(body.system, others) - coupling::flexibility_by_temporary_factor(body.system, others))
            .norm(),
        1e-11 * flexibility.norm());
  }
}

// Flexibilities that are kept for reuse belong to the matrix: after a return to earlier stages they are those of
// before, although nothing has been factorized since.
TEST(TrialEnergy, forgets_flexibilities_of_a_state_that_was_taken_back) {
  Body body(false);
  const std::vector<int> step = step_of(body.system.terms());
  const std::vector<int> others(step.begin() + 1, step.end());
  fracture::WholeBodyTrials trials(body.system, {});
  const std::vector<std::uint8_t> stages = body.system.stages().numbers();
  const std::optional<Eigen::MatrixXd> before = trials.flexibility(others);
  ASSERT_TRUE(before.has_value());
  const std::vector<coupling::StageChange> first{{step[0], 1}};
  body.system.commit(first, {});
  const std::optional<Eigen::MatrixXd> without = trials.flexibility(others);
  ASSERT_TRUE(without.has_value());
  EXPECT_GT((*without - *before).norm(), 1e-3 * before->norm());
  body.system.restore(stages, {});
  const std::optional<Eigen::MatrixXd> again = trials.flexibility(others);
  ASSERT_TRUE(again.has_value());
  EXPECT_LE((*again - *before).norm(), 1e-11 * before->norm());
}

// A trial ends before the terms that would free a part.
TEST(TrialEnergy, ends_before_a_part_comes_free) {
  Body body(false);
  const Terms& terms = body.system.terms();
  std::vector<int> around;
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (!terms.is_wide(t) && (terms.first[t] == node(9, 9) || terms.second[t] == node(9, 9)))
      around.push_back(static_cast<int>(t));
  const auto count = static_cast<Eigen::Index>(around.size());
  Eigen::VectorXd stiffness(count);
  for (Eigen::Index k = 0; k < count; ++k)
    stiffness[k] = terms.stiffness[static_cast<std::size_t>(around[static_cast<std::size_t>(k)])];
  const fracture::TrialEnergy trial(stiffness, coupling::flexibility_of(body.system, around), Affine::Ones(count, 2));
  EXPECT_EQ(count, 8);
  EXPECT_EQ(trial.count(), 6);
}

// Growth by up to `count` spacings of 0.5, whose energy release rate is 4 at the tip and rises by the logarithm `slope`
// for each length. Growth takes an energy of one for each length, so the ratio is the root of the rate.
fracture::TrialGrowth growth(int count, double slope) {
  std::vector<fracture::TrialGrowth::Length> lengths;
  Affine elongation = Affine::Zero(count, 2);
  double before = 0;
  for (int k = 0; k < count; ++k) {
    const double length = 0.5 * (k + 1);
    const double energy = 4 * length * std::exp(slope * length / 2);
    lengths.push_back({k + 1, length, length});
    elongation(k, 1) = std::sqrt(2 * (energy - before));
    before = energy;
  }
  return {fracture::TrialEnergy(Eigen::VectorXd::Ones(count), Eigen::MatrixXd::Zero(count, count), elongation), lengths,
          Eigen::VectorXd::Ones(count)};
}

TEST(TrialGrowth, extrapolates_the_rate_to_the_tip) {
  for (const int count : {2, 3, 4})
    for (const double slope : {-0.3, 0.0, 0.4}) EXPECT_NEAR(growth(count, slope).ratio(1), 2, 1e-9);
}

}  // namespace
}  // namespace fracture_trial_energy_test
