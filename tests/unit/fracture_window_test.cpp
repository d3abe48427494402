#include <gtest/gtest.h>

#include <cmath>

#include "fracture/window/computed_events.hpp"
#include "fracture/window/window_certificate.hpp"
#include "fracture/window/window_patience.hpp"
#include "fracture/window/window_solver.hpp"

namespace fracture_window_test {
namespace {

using namespace bempd;
using namespace bempd::fracture;
using coupling::Affine;
using coupling::Condensation;
using coupling::EquilibriumSystem;
using coupling::Terms;

// A plate of points with bonds to the eight neighbours, held at the left and moved at the right by the load factor and,
// if asked for, by a constant. The kept points are a square in it.
class Plate {
 public:
  static constexpr int side = 21;

  explicit Plate(double constant)
      : positions(places()),
        bonds(neighbours()),
        system(side * side, {}, bonds, held()),
        ratios(system.terms(), std::vector<double>(bonds.size(), 1e-2)) {
    Affine prescribed = Affine::Zero(2 * side * side, 2);
    for (int y = 0; y < side; ++y) prescribed.row(2 * node(side - 1, y)) << constant, 1;
    system.factor().place_nodes(positions);
    system.set_load(Affine::Zero(2 * side * side, 2), prescribed);
    std::vector<int> kept;
    for (int x = 4; x < 12; ++x) {
      for (int y = 6; y < 14; ++y) kept.push_back(node(x, y));
    }
    system.factor().keep_last(kept);
  }

  static int node(int x, int y) { return side * y + x; }

  std::vector<Point> positions;
  Terms bonds;
  EquilibriumSystem system;
  StretchRatios ratios;

 private:
  static std::vector<Point> places() {
    std::vector<Point> all;
    for (int i = 0; i < side * side; ++i) all.emplace_back(i % side, i / side);
    return all;
  }
  static Terms neighbours() {
    Terms all;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
          if (x + a < 0 || x + a >= side || y + b >= side) continue;
          const double length = std::hypot(a, b);
          all.first.push_back(node(x, y));
          all.second.push_back(node(x + a, y + b));
          all.cosine.push_back(a / length);
          all.sine.push_back(b / length);
          all.length.push_back(length);
          all.stiffness.push_back(a * b == 0 ? 1 + 0.1 * (x % 3) : 0.4);
        }
      }
    }
    return all;
  }
  static std::vector<char> held() {
    std::vector<char> dofs(2 * side * side, 0);
    for (int y = 0; y < side; ++y) {
      for (int c = 0; c < 2; ++c) dofs[2 * node(0, y) + c] = dofs[2 * node(side - 1, y) + c] = 1;
    }
    return dofs;
  }
};

// The most stretched bond of the window breaks again and again; every state is also solved for the whole plate.
class Window : public testing::TestWithParam<double> {
 protected:
  static constexpr int events = 60;
  static constexpr double load_factor = 1.5;

  Window() {
    first = plate.system.solve();
    condensation = std::make_unique<Condensation>(plate.system);
    window = std::make_unique<WindowSolver>(plate.system, *condensation, plate.ratios, first,
                                            std::vector<WindowSolver::Function>{});
    certificate =
        std::make_unique<WindowCertificate>(plate.system, *condensation, *window, plate.ratios, GetParam() == 0);
    states = {window->displacement()};
    for (int e = 0; e <= events; ++e) {
      const Affine displacement = whole.solve();
      largest_outside.push_back(outside(displacement));
      const Eigen::VectorXd expected = displacement.col(1)(condensation->dofs());
      worst = std::max(worst, (states.back().col(1) - expected).norm() / expected.norm());
      if (e == events) break;
      const std::vector<int> chosen = window->ratios().most_stretched(window->intact(), load_factor, 0, 1);
      const std::vector<int> bonds{window->bonds()[chosen.front()]};
      EXPECT_TRUE(break_in_window(chosen));
      states.push_back(window->displacement());
      whole.commit(whole.stages().breaking(bonds), {});
    }
  }

  bool break_in_window(const std::vector<int>& places) {
    std::vector<coupling::StageChange> changes, changes_of_system;
    for (const int place : places) {
      changes.push_back({place, 1});
      changes_of_system.push_back({window->bonds()[place], 1});
    }
    if (!window->change(changes)) return false;
    plate.system.stages().enter(changes_of_system);
    return true;
  }

  double difference_from_whole() {
    const Affine expected = whole.solve()(condensation->dofs(), Eigen::all);
    return (window->displacement() - expected).norm() / expected.norm();
  }

  double outside(const Affine& displacement) {
    StretchRatios ratios(plate.bonds, std::vector<double>(plate.bonds.size(), 1e-2));
    ratios.update(displacement);
    double largest = 0;
    for (std::size_t b = 0; b < plate.bonds.size(); ++b) {
      if (!window->contains(static_cast<int>(b))) largest = std::max(largest, ratios.at(b, load_factor));
    }
    return largest;
  }

  // Limits so near to the largest outside ratio that the certificate must tell them apart.
  int first_violation(int violated) {
    std::vector<OutsideCheck> checks;
    std::vector<int> breaks;
    const double scale = GetParam() == 0 ? load_factor : 1;
    for (int e = 0; e <= events; ++e) {
      breaks.push_back(e);
      const double limit = largest_outside[e] * (e == violated ? 1 - 1e-6 : 1 + 1e-6);
      if (e < events) checks.push_back({e, load_factor / scale, limit / scale});
    }
    return certificate->first_violation(states, breaks, checks, first);
  }

  Plate plate{GetParam()};
  Plate reference{GetParam()};
  EquilibriumSystem& whole = reference.system;
  Affine first;
  std::unique_ptr<Condensation> condensation;
  std::unique_ptr<WindowSolver> window;
  std::unique_ptr<WindowCertificate> certificate;
  std::vector<Affine> states;
  std::vector<double> largest_outside;
  double worst = 0;
};

TEST_P(Window, displacements_are_those_of_the_whole_plate) { EXPECT_LT(worst, 1e-11); }

TEST_P(Window, certificate_finds_the_first_state_in_which_a_bond_outside_is_too_hot) {
  EXPECT_GE(first_violation(-1), events);
  for (const int violated : {0, 1, 17, 39, 40, 41, events - 1}) EXPECT_EQ(first_violation(violated), violated);
}

TEST_P(Window, certificate_of_a_last_state_gives_its_displacements) {
  first_violation(-1);
  const Affine last = certificate->last_displacement(events), expected = whole.solve();
  EXPECT_LT((last - expected).norm(), 1e-11 * expected.norm());
}

TEST_P(Window, a_bond_that_alone_resists_a_motion_is_refused) {
  const int corner = Plate::node(7, 9);
  std::vector<int> places;
  for (std::size_t b = 0; b < window->bonds().size(); ++b) {
    const int bond = window->bonds()[b];
    if (!window->intact()[b]) continue;
    if (plate.bonds.first[bond] == corner || plate.bonds.second[bond] == corner) places.push_back(static_cast<int>(b));
  }
  const Affine before = window->displacement();
  EXPECT_FALSE(break_in_window(places));
  EXPECT_EQ(window->displacement(), before);
  for (const int b : places) EXPECT_TRUE(window->intact()[b]);
}

TEST_P(Window, places_close_and_open_in_it_as_in_the_whole_plate) {
  const Affine open = window->displacement();
  for (const int y : {9, 11}) {
    const std::vector<coupling::TermEntry> pull{
        {Plate::node(6, y), -1, 0.2}, {Plate::node(7, y), 0.7, 0}, {Plate::node(7, y + 1), 0.3, -0.2}};
    whole.contact().add({pull, 4.0 + y});
  }
  const auto switch_both = [&](bool first_closes, bool second_closes) {
    const std::vector<WindowSolver::Switch> switches{{whole.constraints()[0], first_closes},
                                                     {whole.constraints()[1], second_closes}};
    whole.contact().switch_over(std::vector{0, 1});
    return window->switch_constraints(switches);
  };
  whole.contact().switch_over(std::vector{0});
  ASSERT_TRUE(window->rows().follows(whole.constraints()[0]));
  EXPECT_TRUE(window->switch_constraints(std::vector<WindowSolver::Switch>{{whole.constraints()[0], true}}));
  EXPECT_LT(difference_from_whole(), 1e-11);
  EXPECT_GT((window->displacement() - open).norm(), 1e-4 * open.norm());
  const Eigen::VectorXd at = coupling::evaluate(whole.solve(), load_factor);
  const double gap = whole.constraints()[0].gap(at.data());
  EXPECT_NEAR(window->rows().gap(whole.constraints()[0], load_factor), gap, 1e-11 * at.lpNorm<Eigen::Infinity>());
  EXPECT_TRUE(switch_both(false, true));
  EXPECT_LT(difference_from_whole(), 1e-11);
  EXPECT_TRUE(switch_both(true, false));
  whole.contact().switch_over(std::vector{0});
  EXPECT_TRUE(window->switch_constraints(std::vector<WindowSolver::Switch>{{whole.constraints()[0], false}}));
  EXPECT_LT((window->displacement() - open).norm(), 1e-11 * open.norm());
}

// Forces are balanced, too, with a place whose stiffness the window has gained, and with points left behind.
TEST_P(Window, forces_are_in_balance_and_are_put_back_to_it) {
  const coupling::Constraint place{{{Plate::node(6, 9), -1, 0}, {Plate::node(7, 9), 1, 0}}, 3};
  EXPECT_TRUE(window->switch_constraints(std::vector<WindowSolver::Switch>{{place, true}}));
  std::vector<char> leaves;
  for (const int dof : condensation->dofs()) leaves.push_back(plate.positions[dof / 2].x() < 5.5 ? 1 : 0);
  window->narrow(leaves);
  const std::vector<int> chosen = window->ratios().most_stretched(window->intact(), load_factor, 0, 1);
  EXPECT_TRUE(break_in_window(chosen));
  const Affine exact = window->displacement();
  EXPECT_LT(window->unbalanced().lpNorm<Eigen::Infinity>(), 1e-13);  // of forces about 1
  Affine force = Affine::Zero(exact.rows(), 2);
  for (Eigen::Index i = 0; i < force.rows(); ++i)
    if (leaves[static_cast<std::size_t>(i)] == 0) force(i, 1) = 1e-6 * std::sin(1.0 + static_cast<double>(i));
  window->balance(force);
  EXPECT_GT((window->displacement() - exact).norm(), 1e-7 * exact.norm());
  EXPECT_GT(window->unbalanced().lpNorm<Eigen::Infinity>(), 5e-7);
  window->balance(window->unbalanced());
  EXPECT_LT((window->displacement() - exact).norm(), 1e-11 * exact.norm());
}

TEST(ComputedEvents, a_return_restores_the_stages_of_the_position) {
  Plate plate(0);
  ComputedEvents events(plate.system);
  const std::vector<std::uint8_t> whole = plate.system.stages().numbers();
  for (const int bond : {5, 9}) {
    ForecastEvent event;
    event.event.changes = {plate.system.terms().breaking(bond)};
    event.back = {{bond, whole[static_cast<std::size_t>(bond)]}};
    plate.system.stages().enter(event.event.changes);
    events.add(event);
  }
  events.take_back(0);
  EXPECT_EQ(plate.system.stages().numbers(), whole);
  EXPECT_FALSE(events.have_changed_terms());
  events.take();
  const std::vector<std::uint8_t> first = plate.system.stages().numbers();
  EXPECT_NE(first[5], whole[5]);
  EXPECT_EQ(first[9], whole[9]);
  events.take();
  EXPECT_TRUE(events.are_all_taken() && events.next() == nullptr && events.have_changed_terms());
  EXPECT_EQ(events.stages(1), first);
  EXPECT_EQ(events.stages(0), whole);
  events.return_to(1);
  EXPECT_EQ(plate.system.stages().numbers(), first);
  EXPECT_EQ(events.next()->event.changes.front().term, 9);
  events.keep_first(1);
  EXPECT_TRUE(events.are_all_taken());
  EXPECT_EQ(plate.system.stages().numbers(), first);
}

TEST(WindowPatience, doubles_after_a_window_without_use) {
  WindowPatience patience;
  EXPECT_FALSE(patience.waits());
  patience.note_useless();
  EXPECT_EQ(patience.events(), 2);
  patience.note_useless();
  EXPECT_EQ(patience.events(), 4);
  for (int event = 0; event < 4; ++event) patience.note_event();
  EXPECT_FALSE(patience.waits());
  for (int k = 0; k < 64; ++k) patience.note_useless();
  EXPECT_EQ(patience.events(), WindowSettings::most_patience);
  patience.note_useful();
  EXPECT_EQ(patience.patience(), 1);
}

INSTANTIATE_TEST_SUITE_P(Loads, Window, testing::Values(0.0, 0.4));

}  // namespace
}  // namespace fracture_window_test
