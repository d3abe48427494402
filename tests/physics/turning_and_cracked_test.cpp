// Forces per volume in boundary elements with cracks, those that grow with the place, and heat beside cracks: against
// superposition and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "closing_cracks.hpp"
#include "contact_bodies.hpp"
#include "geometry/turning.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/crack_faces.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/places/heated_region.hpp"
#include "regions/places/single_point.hpp"
#include "regions/places/turning_region.hpp"
#include "regions/places/whole_region.hpp"

namespace turning_and_cracked_test {
namespace {

using namespace bempd;
using namespace closing_cracks;
using std::numbers::pi;

constexpr auto to_load_factor = fracture::Goal::load_factor;
constexpr double weight = 0.4;

// A crack that stays as it is, whatever its tips carry.
void set_growth(model::Model& model, bool grows) {
  for (const int end : {0, 1}) model.growth().set_frozen(1, end, !grows);
}

// A bar 2 wide and 6 high whose lower or upper edge is held.
std::unique_ptr<model::Model> bar(const std::vector<Point>& crack, int held, const char* contact = "faces") {
  auto model = std::make_unique<model::Model>();
  model->options().set_text("contact", contact);
  scene::Scene& scene = model->editable_scene();
  scene::Material material;
  material.elasticity = {1, 0.3, PlaneState::stress, 0.5};
  material.fracture_energy = 1;
  material.thermal_expansion = 0.1;
  regions::add_boundary_region(scene, scene.add_material(material), {{-1, 0}, {1, 0}, {1, 6}, {-1, 6}}, 0.5);
  if (!crack.empty()) {
    scene.add_crack(crack);
    set_growth(*model, false);
  }
  contact_bodies::hold(*model, held, 1, 0, 0);
  contact_bodies::hold(*model, held, 2, 0, 0);
  return model;
}

void add_weight(model::Model& model) {
  model.editable_scene().add_load(
      {std::make_shared<const regions::WholeRegion>(1), 2, scene::SampledValues{{0.0}, {-weight}}});
}

// Pressure and shear along a crack that a stress takes off its faces, linear from its start to its end.
void pull_faces(model::Model& model, const Stress& stress, const std::vector<Point>& crack) {
  const Point along = (crack[1] - crack[0]).normalized(), normal(along.y(), -along.x());  // outward of the left face
  std::vector<double> pressure, shear;
  for (const Point& end : crack) {
    const Point traction = -stress(end) * normal;
    pressure.push_back(-traction.dot(normal)), shear.push_back(traction.dot(left_of(normal)));
  }
  const std::vector<double> none{0, 0};
  const auto faces = std::make_shared<const regions::CrackFaces>(1);
  model.editable_scene().add_load({faces, 1, scene::SampledValues{none, pressure}});
  model.editable_scene().add_load({faces, 2, scene::SampledValues{none, shear}});
}

void expect_same_cracks(model::Model& one, model::Model& other) {
  ASSERT_EQ(one.cracks().tips().size(), other.cracks().tips().size());
  double scale = 0;
  for (const regions::TipValues& tip : other.cracks().tips()) scale = std::max(scale, tip.factors.norm());
  for (std::size_t t = 0; t < one.cracks().tips().size(); ++t) {
    const regions::TipValues &a = one.cracks().tips()[t], &b = other.cracks().tips()[t];
    std::printf("K %.9f %.9f and %.9f %.9f\n", a.factors.x(), a.factors.y(), b.factors.x(), b.factors.y());
    // The difference quotient that makes them is exact to some 1e-7.
    EXPECT_LE((a.factors - b.factors).norm(), 1e-6 * scale);
    EXPECT_NEAR(a.critical_load_factor, b.critical_load_factor, 1e-6 * b.critical_load_factor);
  }
  const std::vector<double> fractions{0.2, 0.5, 0.7};
  for (int k = 0; k < 3; ++k) {
    const Point a = one.cracks().openings(1, fractions)[k], b = other.cracks().openings(1, fractions)[k];
    EXPECT_LE((a - b).norm(), 1e-9 * b.norm());
  }
}

// Loads on the faces are the tractions of the hanging bar without a crack: sigma_yy = weight times height.
TEST(WeightAndCracks, as_the_tractions_that_the_sound_bar_has_there) {
  const Stress sound = [](const Point& x) { return stress(0, weight * x.y()); };
  for (const std::vector<Point>& crack :
       {std::vector<Point>{{-0.6, 3}, {0.5, 3}}, {{-0.4, 2}, {0.5, 2.7}}, {{-1, 2.5}, {-0.2, 2.3}}}) {
    const auto hangs = bar(crack, 3, "none"), pulled = bar(crack, 3, "none"), whole = bar({}, 3);
    add_weight(*hangs), add_weight(*whole);
    // The held edge has a field of its own in the bar without a crack: another force at the same places.
    for (model::Model* model : {hangs.get(), whole.get()}) model->driver().advance(1, to_load_factor);
    const Stress of_whole = [&](const Point& x) {
      const Eigen::Vector3d s = whole->results().evaluate({x}, true)[0].stress;
      return stress(s[0], s[1], s[2]);
    };
    pull_faces(*pulled, of_whole, crack);
    pulled->driver().advance(1, to_load_factor);
    const Eigen::Vector3d here = whole->results().evaluate({crack[0] + Point(0.1, 0)}, true)[0].stress;
    EXPECT_NEAR(here[1], sound(crack[0])(1, 1), 0.02 * weight);
    for (std::size_t t = 0; t < hangs->cracks().tips().size(); ++t) {
      const Point a = hangs->cracks().tips()[t].factors, b = pulled->cracks().tips()[t].factors;
      std::printf("K %.6f %.6f, by tractions %.6f %.6f\n", a.x(), a.y(), b.x(), b.y());
      EXPECT_LE((a - b).norm(), 2e-3 * b.norm());  // the held edge's field is not linear along the crack
    }
    EXPECT_LE(hangs->prepared().evolution->state().worst_energy_balance_error, 1e-12);
  }
}

// Factors agree to all digits where the field of the bar without a crack is a polynomial on all edges, which are held
// by it.
TEST(WeightAndCracks, as_the_tractions_of_an_exact_field) {
  const double nu = 0.3;
  const auto moved = [=](const Point& p) -> Point {
    return {-nu * weight * p.x() * p.y(), 0.5 * weight * (p.y() * p.y() - 36 + nu * p.x() * p.x())};
  };
  const std::vector<Point> crack{{-0.4, 2}, {0.5, 2.7}};
  const auto build = [&](bool hangs) {
    auto model = std::make_unique<model::Model>();
    scene::Scene& scene = model->editable_scene();
    scene::Material material;
    material.elasticity = {1, nu, PlaneState::stress, 0.5};
    material.fracture_energy = 1;
    regions::add_boundary_region(scene, scene.add_material(material), {{-1, 0}, {1, 0}, {1, 6}, {-1, 6}}, 0.5);
    scene.add_crack(crack);
    set_growth(*model, false);
    scene.add_support(
        {std::make_shared<const regions::EdgePart>(1, 3, 0, 1), 3, scene::BoundaryFunction([=](const Point& p, double) {
           return scene::BoundaryValue{Point::Zero(), hangs ? moved(p) : Point::Zero()};
         })});
    if (hangs) {
      add_weight(*model);
    } else {
      pull_faces(
          *model, [](const Point& x) { return stress(0, weight * x.y()); }, crack);
    }
    model->driver().advance(1, to_load_factor);
    return model;
  };
  const auto hangs = build(true), pulled = build(false);
  expect_same_cracks(*hangs, *pulled);
  // Stress, also beside the crack, and T differ by the sound bar's.
  for (const Point& x : {Point(0.3, 3.5), Point(0.1, 2.4), Point(-0.9, 1)}) {
    const Eigen::Vector3d a = hangs->results().evaluate({x}, true)[0].stress,
                          b = pulled->results().evaluate({x}, true)[0].stress;
    EXPECT_LE((a - b - Eigen::Vector3d(0, weight * x.y(), 0)).norm(), 1e-8 * weight);
  }
  const Point along = (crack[1] - crack[0]).normalized();
  for (int t = 0; t < 2; ++t) {
    const double sound = weight * hangs->cracks().tips()[t].place.y() * along.y() * along.y();
    EXPECT_NEAR(hangs->cracks().tips()[t].stress_along, pulled->cracks().tips()[t].stress_along + sound, 1e-7 * weight);
  }
}

// What growth releases over the integral of the energy release rate.
double release(model::Model& model) {
  set_growth(model, true);
  const model::GrowthResult grown = model.growth().grow(0.01);
  double by_rates = 0;
  for (const fracture::CrackExtension& e : model.cracks().extensions()) {
    by_rates += e.released_energy;
    EXPECT_LE(std::abs(e.angle), 0.02);  // straight on, so that the rates before and after belong together
  }
  return grown.released_energy / by_rates;
}

// Energies have what weight and rotation do inside: growth releases what it does under a traction, where both meshes
// differ by some 1e-3 of it.
TEST(WeightAndCracks, growth_releases_the_integral_of_the_rate) {
  const std::vector<Point> crack{{-0.5, 3}, {0.5, 3}};
  const auto pulled = bar(crack, 3), hangs = bar(crack, 3), turns = bar(crack, 3);
  add_weight(*hangs);
  turns->editable_scene().add_load(
      {std::make_shared<const regions::TurningRegion>(1, Point(0, 7)), 1, scene::SampledValues{{0.0}, {0.7}}});
  pulled->editable_scene().add_load(
      {std::make_shared<const regions::EdgePart>(1, 1, 0, 1), 2, scene::SampledValues{{0.0}, {-1.0}}});
  const double expected = release(*pulled), weight_releases = release(*hangs), rotation_releases = release(*turns);
  std::printf("released over the integral of the rates - 1: %.2e by a traction, %.2e by weight, %.2e by rotation\n",
              expected - 1, weight_releases - 1, rotation_releases - 1);
  EXPECT_NEAR(expected, 1, 5e-3);
  EXPECT_NEAR(weight_releases, expected, 5e-5);
  EXPECT_NEAR(rotation_releases, expected, 5e-5);
}

// A bar that stands: its weight presses a level crack, which is as if it were not there, and a slanted one slides.
TEST(WeightAndCracks, weight_closes_them) {
  const std::vector<Point> level{{-0.6, 3}, {0.5, 3}}, slanted{{-0.4, 2}, {0.5, 2.7}};
  const auto pressed = bar(level, 1), whole = bar({}, 1), slides = bar(slanted, 1), passes = bar(slanted, 1, "none");
  for (model::Model* model : {pressed.get(), whole.get(), slides.get(), passes.get()}) {
    add_weight(*model);
    model->driver().advance(1, to_load_factor);
    EXPECT_LE(model->prepared().evolution->state().worst_energy_balance_error, 1e-12);
  }
  EXPECT_EQ(pressed->prepared().system->constraints().closed_exact_count(),
            pressed->prepared().system->constraints().exact_count());
  EXPECT_EQ(pressed->cracks().tips()[0].factors.x(), 0);
  for (const Point& x : {Point(0.3, 3.5), Point(0.1, 2.9), Point(-0.9, 1)}) {
    const Eigen::Vector3d a = pressed->results().evaluate({x}, true)[0].stress,
                          b = whole->results().evaluate({x}, true)[0].stress;
    // All but the shear that the held edge leaves there, on which its faces slide.
    EXPECT_LE((a - b).norm(), 3e-3 * weight);
  }
  EXPECT_EQ(slides->cracks().tips()[0].factors.x(), 0);
  EXPECT_LT(passes->cracks().tips()[0].factors.x(), 0);
  EXPECT_GT(std::abs(slides->cracks().tips()[0].factors.y()), 0.1 * weight);
}

void heat(model::Model& model, const std::function<double(const Point&)>& temperature) {
  model.editable_scene().add_load(
      {std::make_shared<const regions::HeatedRegion>(1), 1, scene::BoundaryFunction([=](const Point& x, double) {
         return scene::BoundaryValue{Point(0, 0), Point(temperature(x), 0)};
       })});
}

double linear(const Point& x) { return 1 + 0.7 * x.x() - 0.4 * x.y(); }

TEST(HeatAndCracks, free_expansion_leaves_them_alone) {
  auto model = plate(2, 0.5, {{{-1, -0.2}, {0.8, 0.4}}, {{2, 1}, {1, 1.2}}});
  model->editable_scene();
  heat(*model, linear);
  model->driver().advance(1, to_load_factor);
  const double size = contact_bodies::displacement(*model).lpNorm<Eigen::Infinity>();
  EXPECT_EQ(model->prepared().system->constraints().closed_exact_count(), 0U);
  EXPECT_LE(openings(*model).lpNorm<Eigen::Infinity>(), 1e-12 * size);
  for (const regions::TipValues& tip : model->cracks().tips()) EXPECT_LE(tip.factors.norm(), 1e-10);
  for (const regions::PointValue& value : model->results().evaluate({{0.1, 0.2}, {1.5, -1}, {1.2, 1.1}}, true))
    EXPECT_LE(value.stress.norm(), 1e-10);
}

// Heat between held edges is the free expansion and edges that move back by it.
TEST(HeatAndCracks, held_ends_are_moved_back_by_the_free_expansion) {
  const std::vector<Point> crack{{-0.4, 2}, {0.5, 2.7}};
  const double e = 0.1;  // of one degree
  const auto expansion = [e](const Point& x) -> Point {
    return e * Point(x.x() + 0.35 * (x.x() * x.x() - x.y() * x.y()) - 0.4 * x.x() * x.y(),
                     x.y() + 0.7 * x.x() * x.y() - 0.2 * (x.y() * x.y() - x.x() * x.x()));
  };
  for (const double sign : {-1.0, 1.0}) {
    const auto heated = bar(crack, 3), moved = bar(crack, 3);
    contact_bodies::hold(*heated, 1, 1, 0, 0), contact_bodies::hold(*heated, 1, 2, 0, 0);
    heat(*heated, [sign](const Point& x) { return sign * linear(x); });
    auto& scene = moved->editable_scene();
    scene.remove_support(1), scene.remove_support(2);
    for (const int edge : {1, 3})
      scene.add_support({std::make_shared<const regions::EdgePart>(1, edge, 0, 1), 3,
                         scene::BoundaryFunction([=](const Point& x, double) {
                           return scene::BoundaryValue{Point::Zero(), Point(-sign * expansion(x))};
                         })});
    for (model::Model* model : {heated.get(), moved.get()}) {
      model->driver().advance(1, to_load_factor);
      EXPECT_LE(model->prepared().evolution->state().worst_energy_balance_error, 1e-11);
    }
    EXPECT_EQ(heated->prepared().system->constraints().closed(), moved->prepared().system->constraints().closed());
    expect_same_cracks(*heated, *moved);
  }
}

// Timoshenko and Goodier, Theory of Elasticity, 3rd ed., section 30: a disc of radius R in plane stress,
//   sigma_r = (3 + nu) / 8 k (R^2 - r^2),  u = k r (1 - nu) ((3 + nu) R^2 - (1 + nu) r^2) / (8 E),  k = density
//   omega^2.
TEST(Rotation, of_a_disc) {
  const double nu = 0.3, radius = 2, k = 0.7;
  model::Model model;
  scene::Scene& scene = model.editable_scene();
  scene::Material material;
  material.elasticity = {1, nu, PlaneState::stress, 0.5};
  const Point centre(3, -1);
  regions::add_boundary_disc(scene, scene.add_material(material), centre, radius, 0.8);
  for (const auto& [place, component] :
       {std::pair(Point(2, 0), 2), std::pair(Point(-2, 0), 2), std::pair(Point(0, 2), 1)})
    scene.add_support(
        {std::make_shared<const regions::SinglePoint>(centre + place), component, scene::SampledValues{{0.0}, {0.0}}});
  scene.add_load(
      {std::make_shared<const regions::TurningRegion>(1, centre), 1, scene::SampledValues{{0.3 * k}, {0.7 * k}}});
  model.driver().advance(1, to_load_factor);
  double error = 0, stress_error = 0;
  for (const double r : {0.0, 0.7, 1.5, 1.95, 2.0}) {
    const Point direction(std::cos(0.4), std::sin(0.4));
    const regions::PointValue value = model.results().evaluate({centre + r * direction}, true)[0];
    const double u = k * r * (1 - nu) * ((3 + nu) * radius * radius - (1 + nu) * r * r) / 8;
    const double along = (3 + nu) / 8 * k * (radius * radius - r * r);
    const double across = k / 8 * ((3 + nu) * radius * radius - (1 + 3 * nu) * r * r);
    const Eigen::Vector3d s = value.stress;
    const double found = direction.x() * direction.x() * s[0] + direction.y() * direction.y() * s[1] +
                         2 * direction.x() * direction.y() * s[2];
    error = std::max(error, (value.displacement - u * direction).norm());
    stress_error = std::max({stress_error, std::abs(found - along), std::abs(s[0] + s[1] - along - across)});
  }
  const fracture::HistoryEntry& line = model.prepared().evolution->progress().history.back();
  // Half of the work of the forces on these displacements: half of the integral of k r u over the volume.
  const double stored = 0.5 * 0.5 * 2 * pi * k * k * (1 - nu) / 8 *
                        ((3 + nu) * std::pow(radius, 6) / 4 - (1 + nu) * std::pow(radius, 6) / 6);
  std::printf("disc: displacement off by %.1e, stress by %.1e, energy %.10g, exact %.10g\n", error, stress_error,
              line.stored_energy, stored);
  EXPECT_LE(error, 1e-8);
  EXPECT_LE(stress_error, 1e-8);
  EXPECT_NEAR(line.stored_energy, stored, 1e-8 * stored);
  EXPECT_NEAR(line.work, stored, 1e-8 * stored);
}

// A bar that turns about its middle, without Poisson's effect: sigma_xx = k (a^2 - x^2) / 2, and likewise across.
double bar_error(bool lattice, double size) {
  const double k = 0.7, a = 4, b = 1;
  model::Model model;
  scene::Scene& scene = model.editable_scene();
  scene::Material material;
  material.elasticity = {1, 0, PlaneState::stress, 0.5};
  const int id = scene.add_material(material);
  const std::vector<Point> corners{{-a, -b}, {a, -b}, {a, b}, {-a, b}};
  if (lattice) {
    regions::add_peridynamic_region(scene, id, corners, size, 3);
  } else {
    regions::add_boundary_region(scene, id, corners, size);
  }
  const auto exact = [&](const Point& x) -> Point {
    return k / 2 * Point(a * a * x.x() - std::pow(x.x(), 3) / 3, b * b * x.y() - std::pow(x.y(), 3) / 3);
  };
  for (const auto& [place, component] :
       {std::pair(Point(-a, 0), 2), std::pair(Point(a, 0), 2), std::pair(Point(0, b), 1)})
    scene.add_support(
        {std::make_shared<const regions::SinglePoint>(place), component, scene::SampledValues{{0.0}, {0.0}}});
  scene.add_load(
      {std::make_shared<const regions::TurningRegion>(1, Point::Zero()), 1, scene::SampledValues{{0.0}, {k}}});
  model.driver().advance(1, to_load_factor);
  double error = 0;
  for (const Point& x : {Point(1, 0.5), Point(3.5, -0.5), Point(-4, 1), Point(-2, 0)})
    error = std::max(error,
                     (model.results().evaluate({x}, false)[0].displacement - exact(x)).norm() / exact({a, b}).norm());
  return error;
}

TEST(Rotation, of_a_bar_in_both_kinds_of_region) {
  const double bem[] = {bar_error(false, 0.5), bar_error(false, 0.25)};
  const double pd[] = {bar_error(true, 0.25), bar_error(true, 0.125)};
  std::printf("bar: boundary elements off by %.1e and %.1e, lattice by %.1e and %.1e\n", bem[0], bem[1], pd[0], pd[1]);
  EXPECT_LE(bem[0], 1e-3);
  EXPECT_LE(bem[1], 0.2 * bem[0]);
  EXPECT_LE(pd[0], 1e-2);
  EXPECT_LE(pd[1], 0.3 * pd[0]);
}

// A rotation about another axis is a uniform force more; with a crack, too.
TEST(Rotation, about_another_axis_is_a_uniform_force_more) {
  const double k = 0.7;
  const Point axis(1.5, -2.5);
  const std::vector<Point> crack{{-0.4, 2}, {0.5, 2.7}};
  const auto one = bar(crack, 3), other = bar(crack, 3);
  one->editable_scene().add_load(
      {std::make_shared<const regions::TurningRegion>(1, axis), 1, scene::SampledValues{{0.0}, {k}}});
  other->editable_scene().add_load(
      {std::make_shared<const regions::TurningRegion>(1, Point::Zero()), 1, scene::SampledValues{{0.0}, {k}}});
  const auto everywhere = std::make_shared<const regions::WholeRegion>(1);
  other->editable_scene().add_load({everywhere, 1, scene::SampledValues{{0.0}, {-k * axis.x()}}});
  other->editable_scene().add_load({everywhere, 2, scene::SampledValues{{0.0}, {-k * axis.y()}}});
  for (model::Model* model : {one.get(), other.get()}) {
    model->driver().advance(1, to_load_factor);
    EXPECT_LE(model->prepared().evolution->state().worst_energy_balance_error, 1e-11);
  }
  expect_same_cracks(*one, *other);
}

}  // namespace
}  // namespace turning_and_cracked_test
