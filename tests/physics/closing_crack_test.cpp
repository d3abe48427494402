// Cracks in boundary element regions whose faces press on each other, against bodies without cracks, exact fields,
// quadratic programmes solved on their own, and paths taken in other steps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "closing_cracks.hpp"
#include "contact_bodies.hpp"
#include "error.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/boundary/boundary_region.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/places/single_point.hpp"

namespace closing_crack_test {
namespace {

using namespace bempd;
using namespace closing_cracks;
using std::numbers::pi;

constexpr auto to_load_factor = fracture::Goal::load_factor;

double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>() / std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
}

Eigen::VectorXd displacement(model::Model& model) { return contact_bodies::displacement(model); }
const fracture::EvolutionState& state(model::Model& model) { return model.prepared().evolution->state(); }
std::size_t closed(model::Model& model) { return model.prepared().system->constraints().closed_exact_count(); }

double largest_stress_error(model::Model& model, const Eigen::Vector3d& exact) {
  const std::vector<Point> places{{0.3, 0.01}, {-0.2, -0.05}, {0.9, 1e-4}, {1.2, 0.4}, {-1.5, -1}, {0, 1e-7}};
  double worst = 0;
  for (const regions::PointValue& value : model.results().evaluate(places, true))
    worst = std::max(worst, (value.stress - exact).lpNorm<Eigen::Infinity>());
  return worst;
}

TEST(ClosingCrack, pressed_straight_is_as_good_as_none) {
  const std::vector<std::vector<Point>> kinds[] = {
      {{{-0.8, 0}, {0.9, 0}}}, {{{-2, 0}, {0.4, 0}}}, {{{-0.8, 0}, {0.9, 0}}, {{-0.5, 1}, {0.5, 1}}}};
  for (const auto& cracks : kinds) {
    const auto cracked = plate(2, 0.5, cracks), through = plate(2, 0.5, cracks, "none");
    for (model::Model* model : {cracked.get(), through.get()}) {
      pull(*model, uniform(0, 0), uniform(0.3, 1));
      model->driver().advance(-1, to_load_factor);
    }
    const double error = largest_stress_error(*cracked, {-0.3, -1, 0});
    std::printf("pressed across: %zu of %zu places closed, stress off by %.1e, without contact by %.1e\n",
                closed(*cracked), cracked->prepared().system->constraints().exact_count(), error,
                largest_stress_error(*through, {-0.3, -1, 0}));
    EXPECT_LE(error, 1e-10);
    EXPECT_EQ(closed(*cracked), cracked->prepared().system->constraints().exact_count());
    EXPECT_EQ(openings(*cracked)(Eigen::seq(1, Eigen::last, 2)).cwiseAbs().maxCoeff(), 0);
    EXPECT_LE(openings(*cracked).cwiseAbs().maxCoeff(), 1e-10);
    for (const regions::TipValues& tip : cracked->cracks().tips()) {
      EXPECT_EQ(tip.factors.x(), 0);
      EXPECT_LE(std::abs(tip.factors.y()), 1e-6);
      EXPECT_NEAR(tip.stress_along, -0.3, 1e-6);
    }
    const Point a(1.7, 1.9), b(-1.8, -1.6);
    const auto values = cracked->results().evaluate({a, b}, false);
    const Point moved = values[0].displacement - values[1].displacement;
    EXPECT_NEAR(moved.x(), (-0.3 + 0.3) * (a - b).x(), 1e-10);
    EXPECT_NEAR(moved.y(), (-1 + 0.3 * 0.3) * (a - b).y(), 1e-10);
    // The crack is open again when it is pulled.
    cracked->driver().advance(1, to_load_factor), through->driver().advance(1, to_load_factor);
    EXPECT_EQ(closed(*cracked), 0U);
    EXPECT_LE(difference(displacement(*cracked), displacement(*through)), 1e-12);
    EXPECT_LE(state(*cracked).worst_energy_balance_error, 1e-12);
    cracked->driver().advance(0, to_load_factor);
    EXPECT_LE(displacement(*cracked).lpNorm<Eigen::Infinity>(), 1e-13);
  }
}

// An infinite plate under uniaxial pressure, its crack at an angle to that: faces without friction slide as under the
// shear alone.
TEST(ClosingCrack, an_inclined_one_under_pressure_only_slides) {
  for (const double degrees : {30.0, 45.0, 65.0}) {
    const double angle = degrees * pi / 180;
    const Point along(std::cos(angle), std::sin(angle));
    const auto model = plate(1000, 500, {{-along, along}});
    pull(*model, uniform(0, 0), uniform(1, 0));
    model->driver().advance(-1, to_load_factor);
    const double shear = std::sin(angle) * std::cos(angle);
    for (const regions::TipValues& tip : model->cracks().tips()) {
      const double exact = shear * std::sqrt(pi);
      std::printf("%g degrees: K_I %g, K_II %.7f of the exact one, T %.7f\n", degrees, tip.factors.x(),
                  tip.factors.y() / exact, tip.stress_along);
      EXPECT_EQ(tip.factors.x(), 0);
      EXPECT_NEAR(tip.factors.y() / exact, 1, 1e-4);
      EXPECT_NEAR(tip.stress_along, -std::cos(angle) * std::cos(angle), 1e-4);
      EXPECT_NEAR(tip.kink_angle * 180 / pi, -70.53, 0.01);
    }
    const Point opening = model->cracks().openings(1, {0.5})[0];
    EXPECT_NEAR(opening.y(), 0, 1e-14);
    EXPECT_NEAR(std::abs(opening.x()), 4 * shear, 4e-3);
  }
}

// Bending closes a part of a crack; kinked, branched and edge cracks under uniform and linear stresses, with pressure
// in them.
TEST(ClosingCrack, random_bodies_agree_with_a_quadratic_programme) {
  const std::vector<std::vector<Point>> kinds[] = {{{{-1.2, 0.1}, {1.1, 0.1}}},
                                                   {{{-2, 0.3}, {-0.2, -0.1}}},
                                                   {{{-1, -0.5}, {0.1, 0}, {0.5, 0.9}}},
                                                   {{{-1, 0}, {1, 0}}, {{0.2, 0}, {0.6, 0.8}}},
                                                   {{{-1, -0.4}, {1, 0.4}}, {{-0.5, 0.6}, {0.6, -0.7}}},
                                                   {{{-1, 1}, {0.5, 1.1}}, {{-0.7, -0.9}, {0.7, -1}}}};
  std::mt19937 random(17);
  std::uniform_real_distribution<double> size(-1, 1);
  double worst = 0, balance = 0;
  std::size_t shut = 0, places = 0;
  for (const auto& cracks : kinds) {
    for (int repeat = 0; repeat < 1; ++repeat) {
      const auto model = plate(2, 1, cracks);
      double c[12];
      for (double& number : c) number = size(random);
      const double pressure = 0.3 * size(random), growing = 0.3 * size(random);
      pull(
          *model, [&c](const Point& x) { return stress(c[0] + c[1] * x.y(), c[2] + c[3] * x.x(), c[4]); },
          [&c](const Point& x) { return stress(c[6] + c[7] * x.y(), c[8] + c[9] * x.x(), c[10]); });
      press_faces(*model, 1, pressure, growing);
      for (const double load_factor : {0.7, -1.5, 0.4}) {
        model->driver().advance(load_factor, to_load_factor);
        const double in_crack = pressure + load_factor * growing;
        const auto& lines = model->results().region(1).crack_elements()->lines()->lines;
        const Solved exact = by_quadratic_programme(*model, [&](int line, const Point&, const Point& normal) -> Point {
          return lines[static_cast<std::size_t>(line)].crack == 0 ? Point(-in_crack * normal) : Point::Zero();
        });
        const double scale = exact.displacements.lpNorm<Eigen::Infinity>();
        worst = std::max({worst, (displacement(*model) - exact.displacements).lpNorm<Eigen::Infinity>() / scale,
                          (openings(*model) - exact.openings).lpNorm<Eigen::Infinity>() / scale});
        shut += closed(*model), places += model->prepared().system->constraints().exact_count();
      }
      balance = std::max(balance, state(*model).worst_energy_balance_error);
    }
  }
  std::printf("6 bodies at 3 load factors: %zu of %zu places closed, energy balance %.1e; differ by %.1e\n", shut,
              places, balance, worst);
  EXPECT_GT(shut, places / 10);
  EXPECT_LT(shut, places * 9 / 10);
  EXPECT_LE(worst, 1e-10);
  EXPECT_LE(balance, 1e-11);
}

// A constant pull and growing bending with pressure: places close one after another, whatever the steps.
TEST(ClosingCrack, the_path_is_piecewise_linear) {
  const auto coarse = plate(2, 1, {{{-1.2, 0.1}, {1.1, 0.3}}}), fine = plate(2, 1, {{{-1.2, 0.1}, {1.1, 0.3}}});
  for (model::Model* model : {coarse.get(), fine.get()}) {
    pull(*model, uniform(0, 0.5), [](const Point& x) { return stress(0, -0.3 - 0.7 * x.x()); });
    press_faces(*model, 1, 0.1, 0.05);
  }
  coarse->driver().advance(3, to_load_factor);
  for (int k = 0; k <= 60; ++k) fine->driver().advance(k / 20.0, to_load_factor);
  EXPECT_LE(difference(displacement(*coarse), displacement(*fine)), 1e-11);
  const fracture::EvolutionState &a = state(*coarse), &b = state(*fine);
  std::printf("%lld switches on the way, %lld in 60 steps; work %.12g and %.12g\n",
              static_cast<long long>(a.contact_switches), static_cast<long long>(b.contact_switches), a.work, b.work);
  EXPECT_GT(a.contact_switches, 5);
  EXPECT_EQ(a.contact_switches, b.contact_switches);
  EXPECT_NEAR(a.work, b.work, 1e-11 * std::abs(a.work));
  EXPECT_LE(a.worst_energy_balance_error, 1e-12);
  EXPECT_LE(b.worst_energy_balance_error, 1e-12);
  // A state brings the closed places back.
  const model::SavedState saved = fine->states().save();
  const Eigen::VectorXd before = displacement(*fine);
  fine->driver().advance(-2, to_load_factor);
  fine->states().restore(saved);
  EXPECT_EQ(displacement(*fine), before);
  EXPECT_EQ(closed(*fine), closed(*coarse));
  coarse->driver().advance(0.2, to_load_factor), fine->driver().advance(0.2, to_load_factor);
  EXPECT_LE(difference(displacement(*coarse), displacement(*fine)), 1e-11);
}

// Proportional loads from rest open or close no place on the way.
TEST(ClosingCrack, under_proportional_loads_what_is_closed_stays_so) {
  const auto model = plate(2, 1, {{{-1.2, 0.1}, {1.1, 0.3}}});
  pull(*model, uniform(0, 0), [](const Point& x) { return stress(0, -0.1 - 0.7 * x.x()); });
  model->driver().advance(1e-6, to_load_factor);
  const std::vector<char> at_first = model->prepared().system->constraints().closed();
  const std::int64_t switches = state(*model).contact_switches;
  EXPECT_GT(closed(*model), 2U);
  EXPECT_LT(closed(*model), at_first.size());
  model->driver().advance(5, to_load_factor);
  EXPECT_EQ(model->prepared().system->constraints().closed(), at_first);
  EXPECT_EQ(state(*model).contact_switches, switches);
}

// A crack that bending closes at one end: the energy release rate of the other one is what its growth releases.
TEST(ClosingCrack, energy_is_released_by_growth_beside_closed_faces) {
  const auto grown = [](const char* contact) {
    auto model = plate(2, 0.5, {{{-0.9, 0}, {0.9, 0}}}, contact, 1);
    pull(*model, uniform(0, 0), [](const Point& x) { return stress(0, 0.2 + x.x()); });
    model->growth().set_frozen(1, 0, true);
    const model::GrowthResult result = model->growth().grow(0.01);
    const double by_rates = model->cracks().extensions()[0].released_energy;
    std::printf("contact %s: load factor %.5f, released over the integral of the rates - 1: %.1e\n", contact,
                result.load_factor, result.released_energy / by_rates - 1);
    EXPECT_NEAR(result.released_energy / by_rates, 1, 1e-3);
    return model;
  };
  const auto presses = grown("faces"), passes = grown("none");
  EXPECT_GT(closed(*presses), 0U);
  EXPECT_EQ(presses->cracks().tips()[0].factors.x(), 0);
  EXPECT_LT(passes->cracks().tips()[0].factors.x(), 0);
  EXPECT_GT(presses->cracks().tips()[1].factors.x(), 0);
  EXPECT_GT(std::abs(presses->load_factor() / passes->load_factor() - 1), 5e-3);
}

// A lattice whose crack grows on boundary elements with one that is closed: bonds break by the same books.
TEST(ClosingCrack, beside_a_lattice_that_breaks) {
  const auto run = [](const char* solver, const std::vector<std::vector<Point>>& cracks) {
    auto model = std::make_unique<model::Model>();
    model->options().set_text("test.solver", solver);
    scene::Scene& scene = model->editable_scene();
    scene::Material material;
    material.elasticity = {1, 1.0 / 3, PlaneState::stress, 1};
    material.critical_stretch = 1e-3;
    const int id = scene.add_material(material);
    regions::add_boundary_region(scene, id, {{0, 0}, {24, 0}, {24, 10}, {0, 10}}, 2);
    regions::add_peridynamic_region(scene, id, {{0, 10}, {24, 10}, {24, 22}, {0, 22}}, 1, 3);
    for (const auto& crack : cracks) scene.add_crack(crack);
    contact_bodies::hold(*model, 1, 2, 0, 0);
    return model;
  };
  const auto bend = [](model::Model& model) {
    contact_bodies::hold(model, 1, 1, 0, 0);
    const auto top = std::make_shared<const regions::EdgePart>(2, 3, 0, 1);
    model.editable_scene().add_support({top, 1, scene::SampledValues{{0.0}, {0.0}}});
    // The displacement is given from right to left.
    model.editable_scene().add_support({top, 2, scene::SampledValues{{0.0, 0.0}, {-0.06, 0.03}}});
  };
  const std::vector<Point> grows{{0, 16.5}, {7.3, 16.5}}, closes{{15, 4.2}, {22, 5.8}};
  const auto plain = run("plain", {grows, closes}), window = run("window", {grows, closes});
  for (model::Model* model : {plain.get(), window.get()}) {
    bend(*model);
    for (int k = 0; k < 40; ++k) model->driver().advance(10, fracture::Goal::next_event);
  }
  const fracture::EvolutionState &a = state(*plain), &b = state(*window);
  std::printf("%lld bonds, %zu of %zu places closed, energy balance %.1e\n", static_cast<long long>(a.broken_bonds),
              closed(*plain), plain->prepared().system->constraints().exact_count(), a.worst_energy_balance_error);
  EXPECT_GT(closed(*plain), 5U);
  EXPECT_EQ(a.stages, b.stages);
  EXPECT_LE(difference(a.total_displacement, b.total_displacement), 1e-10);
  EXPECT_LE(a.worst_energy_balance_error, 1e-11);
  // The run goes on in the same way from a state with closed places.
  const auto other = run("plain", {grows, closes});
  bend(*other);
  const std::vector<std::uint8_t> bytes = model::to_bytes(plain->states().save());
  other->states().restore(model::from_bytes(bytes.data(), bytes.size()));
  for (model::Model* model : {plain.get(), other.get()})
    for (int k = 0; k < 5; ++k) model->driver().advance(10, fracture::Goal::next_event);
  EXPECT_EQ(displacement(*plain), displacement(*other));
  // Straight across the pressure it is as if it were not there.
  const auto pressed = run("plain", {{{4, 4.5}, {20, 4.5}}});
  pressed->editable_scene().add_support(
      {std::make_shared<const regions::SinglePoint>(Point(0, 0)), 1, scene::SampledValues{{0.0}, {0.0}}});
  pressed->editable_scene().add_load(
      {std::make_shared<const regions::EdgePart>(2, 3, 0, 1), 2, scene::SampledValues{{0.0}, {-1e-4}}});
  pressed->driver().advance(1, to_load_factor);
  EXPECT_EQ(closed(*pressed), pressed->prepared().system->constraints().exact_count());
  for (const regions::PointValue& value : pressed->results().evaluate({{5, 4.6}, {12, 3}, {21, 6}, {8, 9}}, true))
    EXPECT_LE((value.stress - Eigen::Vector3d(0, -1e-4, 0)).norm(), 1e-10 * 1e-4);
}

// Wings of an inclined crack under pressure leave at the angle of the largest hoop stress of pure sliding and turn to
// the pressure.
TEST(ClosingCrack, wings_grow_from_an_inclined_crack) {
  const double angle = pi / 4;
  const Point along(std::cos(angle), std::sin(angle));
  const auto model = plate(20, 4, {{-along, along}}, "faces", 1);
  model->options().set_text("crack.direction", "chord");
  model->options().set("crack.tie_share", 0.01);  // both
  pull(*model, uniform(0, 0), uniform(0, -1));
  double last = 0;
  const double first = 2 / std::sqrt(3) * 0.5 * std::sqrt(pi);  // largest hoop factor of pure sliding (Erdogan and Sih)
  EXPECT_NEAR(model->cracks().tips()[0].critical_load_factor * first, 1, 0.005);
  EXPECT_NEAR(model->cracks().tips()[0].straight_load_factor * 0.5 * std::sqrt(pi), 1, 0.01);
  for (int step = 0; step < 6; ++step) {
    const model::GrowthResult grown = model->growth().grow(0.2);
    EXPECT_EQ(grown.tips, 2);
    EXPECT_GT(grown.load_factor, last);  // wings grow stably
    if (step == 0) {
      EXPECT_NEAR(grown.load_factor * first, 1, 0.005);
    }
    last = grown.load_factor;
  }
  const Point d = model->cracks().tips()[1].direction;
  const double off = std::atan2(std::abs(d.x()), std::abs(d.y())) * 180 / pi;
  std::printf("wings of 1.2: load factor %.3f, %.1f degrees from the pressure's direction\n", last, off);
  EXPECT_LE(off, 6);
  EXPECT_NEAR(model->cracks().openings(1, {0.5})[0].y(), 0, 1e-14);
  EXPECT_LE(state(*model).worst_energy_balance_error, 1e-10);
}

}  // namespace
}  // namespace closing_crack_test
