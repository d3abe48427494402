// Faces of cracks that press on each other, against quadratic programmes solved on their own, and against what bodies
// do that are whole, open, or taken back to where they were.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <random>

#include "contact_bodies.hpp"
#include "error.hpp"
#include "fracture/contact/gap_rule.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/edge_part.hpp"
#include "thorough.hpp"

namespace contact_test {
namespace {

using namespace bempd;
using namespace contact_bodies;

double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>() / std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
}

// --- The quadratic programme

TEST(Contact, random_bodies_agree_with_a_quadratic_programme) {
  std::mt19937 random(2024);
  double worst = 0, balance = 0;
  int bodies = 0, closed = 0, places = 0;
  std::int64_t switches = 0;
  for (int attempt = 0; bodies < bempd_tests::cases(16, 48); ++attempt) {
    ASSERT_LT(attempt, 200);
    const auto model = random_plate(random);
    if (!model) continue;
    ++bodies;
    const QuadraticProgramme programme(*model);
    for (const double load_factor : {0.7, 2.0, -1.5, 0.4, 0.0, -0.3}) {
      model->driver().advance(load_factor, fracture::Goal::load_factor);
      worst = std::max(worst, difference(displacement(*model), programme.displacement()));
      closed += static_cast<int>(model->prepared().system->constraints().closed_count());
      places += static_cast<int>(model->prepared().system->constraints().size());
    }
    const fracture::EvolutionState& state = model->prepared().evolution->state();
    balance = std::max(balance, state.worst_energy_balance_error);
    switches += state.contact_switches;
  }
  std::printf("%d bodies at 6 load factors: %d of %d places closed, %lld switches, energy balance %.1e; ", bodies,
              closed, places, static_cast<long long>(switches), balance);
  std::printf("displacements differ by %.1e (reference: quadratic programme, 0)\n", worst);
  EXPECT_GT(closed, places / 10);
  EXPECT_LT(closed, places * 9 / 10);
  EXPECT_LE(worst, 5e-12);
  EXPECT_LE(balance, 1e-12);
}

// --- Simple loads

// Uniaxial pressure and pull across a crack along the rows, by the ends that move.
TEST(Contact, a_plate_pressed_across_its_crack_is_as_good_as_whole) {
  const auto cracked = plate({24, 3}, {{{7.3, 12.5}, {16.7, 12.5}}}), whole = plate({24, 3}, {});
  const auto through = plate({24, 3}, {{{7.3, 12.5}, {16.7, 12.5}}}, "none");
  move_ends(*cracked, 0, 1), move_ends(*whole, 0, 1), move_ends(*through, 0, 1);
  double error[2];
  for (model::Model* model : {cracked.get(), through.get()}) {
    model->driver().advance(-1, fracture::Goal::load_factor);
    whole->driver().advance(-1, fracture::Goal::load_factor);
    error[model == cracked.get() ? 0 : 1] = difference(displacement(*model), displacement(*whole));
  }
  std::printf("pressed across: differs from the whole plate by %.2e, without contact by %.2e\n", error[0], error[1]);
  EXPECT_LT(error[0], 0.03);
  EXPECT_GT(error[1], 5 * error[0]);
  const coupling::Constraints& places = cracked->prepared().system->constraints();
  EXPECT_EQ(places.size(), 9U);
  EXPECT_EQ(places.closed_count(), places.size());
  const fracture::EvolutionState& pressed = cracked->prepared().evolution->state();
  EXPECT_EQ(pressed.contact_switches, 9);  // once each, at the very beginning
  EXPECT_LE(pressed.worst_energy_balance_error, 1e-13);

  cracked->driver().advance(0, fracture::Goal::load_factor);
  EXPECT_LE(displacement(*cracked).lpNorm<Eigen::Infinity>(), 1e-15);
  cracked->driver().advance(1, fracture::Goal::load_factor);
  through->driver().advance(1, fracture::Goal::load_factor);
  EXPECT_EQ(cracked->prepared().system->constraints().closed_count(), 0U);
  EXPECT_LE(difference(displacement(*cracked), displacement(*through)), 1e-12);
}

// A constant pull along the slanted crack's normal and a growing one across: places close one after another.
TEST(Contact, the_path_is_piecewise_linear_whatever_the_steps) {
  const auto coarse = plate({20, 3}, {{{5.2, 8.1}, {14.9, 12.3}}}), fine = plate({20, 3}, {{{5.2, 8.1}, {14.9, 12.3}}});
  move_ends(*coarse, 1, -1, 0.4), move_ends(*fine, 1, -1, 0.4);
  coarse->driver().advance(3, fracture::Goal::load_factor);
  for (int k = 0; k <= 60; ++k) fine->driver().advance(k / 20.0, fracture::Goal::load_factor);
  EXPECT_LE(difference(displacement(*coarse), displacement(*fine)), 1e-12);
  const fracture::EvolutionState &a = coarse->prepared().evolution->state(), &b = fine->prepared().evolution->state();
  std::printf("%lld switches on the way, %lld in 60 steps; work %.12g and %.12g\n",
              static_cast<long long>(a.contact_switches), static_cast<long long>(b.contact_switches), a.work, b.work);
  EXPECT_GT(a.contact_switches, 5);
  EXPECT_EQ(a.contact_switches, b.contact_switches);
  EXPECT_NEAR(a.work, b.work, 1e-12 * std::abs(a.work));
  EXPECT_LE(a.worst_energy_balance_error, 1e-12);
  EXPECT_LE(difference(displacement(*coarse), by_quadratic_programme(*coarse)), 1e-12);
}

// A place that has just opened shows the rounding of the gap it had while closed many times larger: zero for Newton's
// method and for the next event alike.
TEST(Contact, a_gap_that_passed_zero_by_rounding_stays_as_it_is_while_it_goes_back) {
  coupling::Constraints places;
  places.add({{{0, -1, 0}, {1, 1, 0}}, 1});
  const double load_factor = 0.5;
  const auto judge = [&](double gap, double rate) {
    coupling::Affine u = coupling::Affine::Zero(4, 2);
    u(2, 0) = gap - load_factor * rate, u(2, 1) = rate;
    u(1, 0) = 1;  // the largest displacement
    const coupling::Affine gaps = u.row(2) - u.row(0);
    const bool wrong = !fracture::wrong_constraints(places, gaps, u, load_factor, 1).empty();
    const std::optional<double> next = fracture::next_switch(places, gaps, u, load_factor, 1);
    EXPECT_EQ(wrong, next.has_value() && *next == load_factor) << gap << " " << rate;
    return wrong;
  };
  for (const bool closed : {false, true}) {
    places.set_closed(0, closed);
    const double passes = closed ? 1 : -1;
    EXPECT_FALSE(judge(passes * 1e-10, -passes));
    EXPECT_TRUE(judge(passes * 1e-10, passes));
    EXPECT_TRUE(judge(passes * 1e-10, 0));
    EXPECT_TRUE(judge(passes * 1e-6, -passes));
    EXPECT_TRUE(judge(0, passes));
    EXPECT_FALSE(judge(0, -passes));
    EXPECT_FALSE(judge(-passes * 1e-10, passes));
  }
}

// --- Growth

TEST(Contact, a_grown_crack_returns_from_pressure_to_where_it_was) {
  const auto model = plate({24, 3}, {{{7.3, 12.5}, {16.7, 12.5}}}, "faces", 1e-3);
  move_ends(*model, 0, 24e-3, 0.3);
  std::int64_t broken = 0;
  while (broken < 40) broken += model->driver().advance(10, fracture::Goal::next_event).broken_bonds;
  const double load_factor = model->load_factor();
  model->driver().advance(0.9 * load_factor, fracture::Goal::load_factor);
  const Eigen::VectorXd before = displacement(*model);
  const std::int64_t switches = model->prepared().evolution->state().contact_switches;
  model->driver().advance(-0.9 * load_factor, fracture::Goal::load_factor);
  const coupling::Constraints& places = model->prepared().system->constraints();
  const std::size_t closed = places.closed_count();
  EXPECT_LE(difference(displacement(*model), by_quadratic_programme(*model)), 5e-12);
  model->driver().advance(0.9 * load_factor, fracture::Goal::load_factor);
  const fracture::EvolutionState& state = model->prepared().evolution->state();
  std::printf("%lld bonds broken, %zu of %zu places closed under pressure, %lld switches; comes back within %.1e\n",
              static_cast<long long>(broken), closed, places.size(),
              static_cast<long long>(state.contact_switches - switches), difference(displacement(*model), before));
  EXPECT_GT(closed, 9U);
  EXPECT_GT(places.size(), 9U);
  EXPECT_LE(difference(displacement(*model), before), 1e-10);
  EXPECT_LE(state.worst_energy_balance_error, 1e-10);
}

TEST(Contact, a_state_saved_among_closed_places_goes_on_alike) {
  const auto build = [] {
    auto model = plate({24, 3}, {{{7.2, 9.3}, {16.7, 14.6}}}, "faces", 1e-3);
    move_ends(*model, 0, -24e-3, 1.2);
    return model;
  };
  const auto first = build(), second = build();
  first->driver().advance(0.1, fracture::Goal::load_factor);
  for (int k = 0; k < 12; ++k) first->driver().advance(10, fracture::Goal::next_event);
  const std::vector<std::uint8_t> bytes = model::to_bytes(first->states().save());
  second->states().restore(model::from_bytes(bytes.data(), bytes.size()));
  for (const auto* model : {&first, &second})
    for (int k = 0; k < 25; ++k) (*model)->driver().advance(10, fracture::Goal::next_event);
  const fracture::EvolutionState &a = first->prepared().evolution->state(), &b = second->prepared().evolution->state();
  EXPECT_GT(first->prepared().system->constraints().closed_count(), 3U);
  EXPECT_GT(a.faces.grown.size() + a.faces.pending.size(), 0U);  // while a window is open they wait
  EXPECT_EQ(a.stages, b.stages);
  EXPECT_EQ(a.faces.closed, b.faces.closed);
  EXPECT_EQ(a.total_displacement, b.total_displacement);
  EXPECT_LE(a.worst_energy_balance_error, 1e-10);
}

// A crack that was pressed shut and grows open: no entry of the matrix that only closed places have needed is left.
TEST(Contact, a_state_saved_after_faces_have_met_goes_on_alike_to_the_last_bit) {
  const auto build = [] {
    auto model = plate({24, 3}, {{{7.2, 9.3}, {16.7, 14.6}}}, "faces", 1e-3);
    move_ends(*model, 0, 24e-3, 0.3);
    return model;
  };
  const auto first = build();
  first->driver().advance(-1, fracture::Goal::load_factor);
  EXPECT_GT(first->prepared().system->constraints().closed_count(), 5U);
  first->driver().advance(0.5, fracture::Goal::load_factor);
  for (int k = 0; k < 4; ++k) {
    const std::vector<std::uint8_t> bytes = model::to_bytes(first->states().save());
    const auto other = build();
    other->states().restore(model::from_bytes(bytes.data(), bytes.size()));
    for (auto* model : {first.get(), other.get()}) {
      for (int event = 0; event < 3; ++event) model->driver().advance(10, fracture::Goal::next_event);
    }
    ASSERT_EQ(first->prepared().evolution->state().total_displacement,
              other->prepared().evolution->state().total_displacement)
        << "after " << k + 1 << " states";
  }
}

// The largest hoop strain a horizon away from the tip of a closed crack without friction, in degrees from its
// direction: a uniform stress without the shear on the faces, which is Westergaard's field (Tada, Paris and Irwin, The
// Stress Analysis of Cracks Handbook, part 1).
double angle_of_largest_hoop_strain(double half_length, double distance) {
  double best = -1e300, found = 0;
  for (int k = 0; k < 1800; ++k) {
    const double t = k * std::numbers::pi / 1800, c = std::cos(t), s = std::sin(t);
    const std::complex<double> z(half_length + distance * c, distance * s);
    const std::complex<double> root = std::sqrt(z - half_length) * std::sqrt(z + half_length);
    const std::complex<double> f = 0.5 * z / root, df = 0.5 * (1.0 / root - z * z / (root * root * root));
    const double xx = -0.5 - 2 * f.imag() - z.imag() * df.real(), yy = -0.5 + z.imag() * df.real();
    const double xy = -f.real() + z.imag() * df.imag();
    const double hoop = xx * s * s - 2 * xy * s * c + yy * c * c, radial = xx * c * c + 2 * xy * s * c + yy * s * s;
    if (hoop - radial / 3 > best) best = hoop - radial / 3, found = k / 10.0;
  }
  return found;
}

TEST(Contact, wings_leave_a_pressed_crack_where_the_hoop_strain_is_largest) {
  const int cells = 90;
  const double half = 20.5, middle_x = 45, level = 45.5;
  const auto model = plate({cells, 3}, {{{middle_x - half, level}, {middle_x + half, level}}}, "faces", 1e-3);
  model->options().set_text("crack.rule", "bond");
  // Moved as under a pressure of 1e-3 at 45 degrees.
  for (int edge = 1; edge <= 4; ++edge) {
    model->editable_scene().add_support(
        {std::make_shared<const regions::EdgePart>(1, edge, 0, 1), 3,
         scene::BoundaryFunction([middle_x](const Point& p, double) {
           const double direct = -0.5e-3 * (1 - 1.0 / 3), shear = -0.5e-3 * (1 + 1.0 / 3);
           const Point away = p - Point(middle_x, middle_x);
           const Point moved(direct * away.x() + shear * away.y(), shear * away.x() + direct * away.y());
           return scene::BoundaryValue{Point(0, 0), moved};
         })});
  }
  std::int64_t broken = 0;
  while (broken < 330) broken += model->driver().advance(1e9, fracture::Goal::next_event).broken_bonds;
  const model::PreparedScene& p = model->prepared();
  const coupling::Terms& terms = p.system->terms();
  double sum = 0;
  int count = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const bool was_cut = std::binary_search(p.cut_bonds.begin(), p.cut_bonds.end(), static_cast<int>(t));
    if (p.system->stages().intact()[t] || was_cut || terms.length[t] > 1.01) continue;
    const Point middle =
        0.5 * (p.discretization.positions[terms.first[t]] + p.discretization.positions[terms.second[t]]);
    const Point side = (middle.x() < middle_x ? -1 : 1) * (middle - Point(middle_x, level));
    const Point away = side - Point(half, 0);
    if (away.norm() < 3 || away.norm() > 9) continue;
    sum += std::atan2(away.y(), away.x()) * 180 / std::numbers::pi;
    ++count;
  }
  const double reference = angle_of_largest_hoop_strain(half, 3);
  std::printf(
      "%lld bonds, %d neighbours parted beside the tips, %zu places closed: %.1f degrees (reference: exact field of "
      "the "
      "closed crack, %.1f)\n",
      static_cast<long long>(broken), count, p.system->constraints().closed_count(), sum / count, reference);
  ASSERT_GE(count, 4);
  EXPECT_NEAR(sum / count, reference, 8);
}

TEST(Contact, windows_and_whole_bodies_break_the_same_bonds) {
  const auto run = [](const char* solver) {
    auto model = plate({30, 3}, {{{8.3, 12.3}, {21.7, 17.6}}}, "faces", 1e-3);
    model->options().set_text("test.solver", solver);
    model->options().set_text("crack.rule", "bond");
    move_ends(*model, 0, -30e-3, 1.1);
    for (int k = 0; k < 60; ++k) model->driver().advance(10, fracture::Goal::next_event);
    return model;
  };
  const auto plain = run("plain"), window = run("window");
  const fracture::EvolutionState &a = plain->prepared().evolution->state(), &b = window->prepared().evolution->state();
  std::printf("%lld events, %lld bonds, %zu of %zu places closed, %lld switches and %lld in windows\n",
              static_cast<long long>(a.events), static_cast<long long>(a.broken_bonds),
              plain->prepared().system->constraints().closed_count(), plain->prepared().system->constraints().size(),
              static_cast<long long>(a.contact_switches), static_cast<long long>(b.contact_switches));
  EXPECT_EQ(a.stages, b.stages);
  EXPECT_EQ(plain->prepared().system->constraints().closed_count(),
            window->prepared().system->constraints().closed_count());
  EXPECT_GT(plain->prepared().system->constraints().closed_count(), 5U);
  EXPECT_LE(difference(a.total_displacement, b.total_displacement), 1e-9);
  EXPECT_LE(b.worst_energy_balance_error, 1e-9);
}

// Faces meet in the last part of a torn plate, at one event after the other: windows go on.
TEST(Contact, windows_switch_places_as_whole_bodies_do) {
  const auto run = [](const char* solver) {
    auto model = plate({39, 4}, {{{15.4, 19.5}, {23.6, 19.5}}}, "faces", 1e-3);
    model->options().set_text("test.solver", solver);
    model->options().set_text("crack.rule", "bond");
    move_ends(*model, 0, 1);
    model->driver().advance(1e9, fracture::Goal::separation);
    return model;
  };
  const auto plain = run("plain"), window = run("window");
  const fracture::EvolutionState &a = plain->prepared().evolution->state(), &b = window->prepared().evolution->state();
  const auto factorizations = window->prepared().system->counters().sparse_factorizations;
  std::printf("%lld events, %lld switches and %lld in windows, %lld factorizations\n", static_cast<long long>(a.events),
              static_cast<long long>(a.contact_switches), static_cast<long long>(b.contact_switches),
              static_cast<long long>(factorizations));
  EXPECT_EQ(a.stages, b.stages);
  EXPECT_EQ(a.faces.closed, b.faces.closed);
  EXPECT_GT(a.contact_switches, 5);
  EXPECT_EQ(a.contact_switches, b.contact_switches);
  EXPECT_LE(factorizations, 2);
  ASSERT_EQ(a.history.size(), b.history.size());
  double energy = 0, released = 0;
  for (std::size_t i = 0; i < a.history.size(); ++i) {
    ASSERT_EQ(a.history[i].total_broken_bonds, b.history[i].total_broken_bonds) << "event " << i + 1;
    EXPECT_NEAR(b.history[i].load_factor, a.history[i].load_factor, 1e-9 * a.history[i].load_factor);
    energy = std::max(energy, a.history[i].released_energy);
    released = std::max(released, std::abs(a.history[i].released_energy - b.history[i].released_energy));
  }
  EXPECT_LE(released, 1e-9 * energy);
  EXPECT_LE(b.worst_energy_balance_error, 1e-9);
}

// --- What is said

TEST(Contact, is_of_faces_or_none) {
  EXPECT_THROW(plate({10, 3}, {})->options().set_text("contact", "sticky"), Error);
  EXPECT_THROW(plate({10, 3}, {})->options().set_text("contact", "rough"), Error);
}

}  // namespace
}  // namespace contact_test
