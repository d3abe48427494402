// A constant force per volume in both kinds of region: a bar that hangs under its own weight.
//
// With y from the free end upwards, w = specific weight:  sigma_yy = w y, all other stresses 0,
//   u_x = -nu' w x y / E',  u_y = w (y^2 + nu' x^2 - H^2) / (2 E')
// (Timoshenko and Goodier, Theory of Elasticity, 3rd ed., section 96, in the plane).
#include <gtest/gtest.h>

#include <cstdio>

#include "error.hpp"
#include "model/model.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/places/whole_region.hpp"
#include "regions/scheme.hpp"

namespace regions_body_force_test {
namespace {

using namespace bempd;
using model::Model;
using regions::Field;

constexpr double width = 0.6, height = 2, weight = 3e4, young = 5e6, thickness = 0.1;

// The bar turned by an angle about the middle of its free end.
struct Bar {
  PlaneElasticity elasticity;
  double angle = 0;

  Eigen::Matrix2d turn() const { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }
  Point force() const { return turn() * Point(0, -weight); }
  std::vector<Point> corners() const {
    std::vector<Point> all;
    for (const Point& p : {Point(0, 0), Point(width, 0), Point(width, height), Point(0, height)})
      all.push_back(turn() * (p - Point(width / 2, 0)));
    return all;
  }
  Point displacement(const Point& place) const {
    const Point p = turn().transpose() * place;
    const double nu = elasticity.effective_poisson_ratio();
    const double along = (1 - nu) / (2 * elasticity.shear_modulus()), across = -nu / (2 * elasticity.shear_modulus());
    return turn() * Point(across * weight * p.x() * p.y(),
                          0.5 * weight * (along * (p.y() * p.y() - height * height) - across * p.x() * p.x()));
  }
  Eigen::Vector3d stress(const Point& place) const {
    Eigen::Matrix2d own = Eigen::Matrix2d::Zero();
    own(1, 1) = weight * (turn().transpose() * place).y();
    const Eigen::Matrix2d turned = turn() * own * turn().transpose();
    return {turned(0, 0), turned(1, 1), turned(0, 1)};
  }
};

// Holds the upper edge as the solution has it; a part of the weight is there from the start.
void hang(const Bar& bar, Model& m) {
  scene::Scene& scene = m.editable_scene();
  const auto held = [bar](const Point& p, double) -> scene::BoundaryValue {
    return {0.25 * bar.displacement(p), 0.75 * bar.displacement(p)};
  };
  scene.add_support({std::make_shared<const regions::EdgePart>(1, 3, 0, 1), 3, held});
  const auto force = [bar](const Point&, double) -> scene::BoundaryValue {
    return {0.25 * bar.force(), 0.75 * bar.force()};
  };
  scene.add_load({std::make_shared<const regions::WholeRegion>(1), 3, force});
}

double largest_error(Model& m, const Bar& bar, Field field, const std::vector<Point>& places) {
  const regions::FieldValues& values = m.results().field(1, field);
  double largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double* found = &values.values[i * static_cast<std::size_t>(values.components)];
    const double error = field == Field::displacement
                             ? (Eigen::Map<const Point>(found) - bar.displacement(places[i])).norm()
                             : (Eigen::Map<const Eigen::Vector3d>(found) - bar.stress(places[i])).norm();
    largest = std::max(largest, error);
  }
  return largest;
}

std::vector<Point> node_places(Model& m) {
  std::vector<Point> places;
  const std::vector<double>& values = m.results().field(1, Field::position).values;
  for (std::size_t i = 0; i < values.size(); i += 2) places.emplace_back(values[i], values[i + 1]);
  return places;
}

// Tractions of the elements are the stress times their outward normals.
void expect_tractions(Model& m, const Bar& bar) {
  const std::vector<Point> places = node_places(m);
  const std::vector<std::int32_t> nodes = m.results().region(1).results().cells().nodes;
  const std::vector<double>& tractions = m.results().field(1, Field::traction).values;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Point along = places[nodes[i / 3 * 3 + 2]] - places[nodes[i / 3 * 3]];
    const Point n = Point(along.y(), -along.x()).normalized();
    const Eigen::Vector3d s = bar.stress(places[nodes[i]]);
    const Point expected(s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y());
    EXPECT_LT((Eigen::Map<const Point>(&tractions[2 * i]) - expected).norm(), 1e-8 * weight * height);
  }
}

class HangingBar : public testing::TestWithParam<std::tuple<PlaneState, double>> {};

TEST_P(HangingBar, of_boundary_elements_is_exact_and_its_reaction_is_the_weight) {
  const auto [state, angle] = GetParam();
  const Bar bar{{young, 0.3, state, thickness}, angle};
  Model m;
  m.editable_scene().add_material({bar.elasticity});
  regions::add_boundary_region(m.editable_scene(), 1, bar.corners(), 0.3);
  hang(bar, m);
  m.driver().advance(1, fracture::Goal::load_factor);

  const double size = bar.displacement(Point::Zero()).norm();
  const std::vector<Point> places = node_places(m);
  const double displacement = largest_error(m, bar, Field::displacement, places) / size;
  const double stress = largest_error(m, bar, Field::stress, places) / (weight * height);
  const Point load = width * height * thickness * bar.force();
  const double reaction = (m.results().reaction(1) + load).norm() / load.norm();
  double inside = 0, inside_stress = 0;
  const std::vector<Point> points{bar.turn() * Point(0.1, 1.1), bar.turn() * Point(-0.29, 0.03)};
  const std::vector<regions::PointValue> values = m.results().evaluate(points, true);
  const std::vector<regions::PointValue> without_stress = m.results().evaluate(points, false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    inside = std::max(inside, (values[i].displacement - bar.displacement(points[i])).norm() / size);
    inside = std::max(inside, (without_stress[i].displacement - bar.displacement(points[i])).norm() / size);
    inside_stress = std::max(inside_stress, (values[i].stress - bar.stress(points[i])).norm() / (weight * height));
  }
  std::printf("displacement %.1e, stress %.1e, inside %.1e and %.1e, reaction %.1e (reference: 0)\n", displacement,
              stress, inside, inside_stress, reaction);
  EXPECT_LT(displacement, 1e-8);
  EXPECT_LT(stress, 1e-8);
  EXPECT_LT(inside, 1e-8);
  EXPECT_LT(inside_stress, 1e-8);
  EXPECT_LT(reaction, 1e-12);
  expect_tractions(m, bar);
}

// Half of the integral of sigma : epsilon is  w^2 / (2 E') integral of y^2 dV; loads and support have done as much
// work.
TEST_P(HangingBar, stores_the_energy_of_its_stress_and_all_of_the_work) {
  const auto [state, angle] = GetParam();
  const Bar bar{{young, 0.3, state, thickness}, angle};
  Model m;
  m.editable_scene().add_material({bar.elasticity});
  regions::add_boundary_region(m.editable_scene(), 1, bar.corners(), 0.3);
  hang(bar, m);
  const double along = (1 - bar.elasticity.effective_poisson_ratio()) / (2 * bar.elasticity.shear_modulus());
  const double whole = along * weight * weight * thickness * width * std::pow(height, 3) / 6;
  for (const double factor : {0.0, 0.4, 1.0}) {
    m.driver().advance(factor, fracture::Goal::load_factor);
    const fracture::HistoryEntry& line = m.prepared().evolution->progress().history.back();
    const double wanted = whole * std::pow(0.25 + 0.75 * factor, 2);
    std::printf("stored %.10g, work %.10g (reference: %.10g), balance %.1e\n", line.stored_energy, line.work, wanted,
                line.energy_balance_error);
    EXPECT_NEAR(line.stored_energy, wanted, 1e-9 * whole);
    EXPECT_NEAR(line.work, wanted, 1e-9 * whole);
    EXPECT_LE(line.energy_balance_error, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(BodyForce, HangingBar,
                         testing::Combine(testing::Values(PlaneState::stress, PlaneState::strain),
                                          testing::Values(0.0, 0.5)));

// Root of the mean square over the points.
double lattice_error(const char* scheme, double spacing, double* reaction_error) {
  const Bar bar{{young, 1.0 / 3, PlaneState::stress, thickness}};
  Model m;
  m.options().set_text("scheme", scheme);
  m.editable_scene().add_material({bar.elasticity});
  regions::add_peridynamic_region(m.editable_scene(), 1, bar.corners(), spacing, 3);
  hang(bar, m);
  m.driver().advance(1, fracture::Goal::load_factor);
  const double load = weight * width * height * thickness;
  *reaction_error = (m.results().reaction(1) - Point(0, load)).norm() / load;
  const std::vector<Point> places = node_places(m);
  const std::vector<double>& values = m.results().field(1, Field::displacement).values;
  double squares = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    squares += (Eigen::Map<const Point>(&values[2 * i]) - bar.displacement(places[i])).squaredNorm();
  return std::sqrt(squares / static_cast<double>(places.size())) / bar.displacement(Point::Zero()).norm();
}

TEST(BodyForce, of_a_lattice_sums_up_to_the_weight_and_errors_fall_with_the_square_of_the_spacing) {
  double reaction = 0, finer_reaction = 0;
  const double error = lattice_error("symmetric", 0.1, &reaction);
  const double finer = lattice_error("symmetric", 0.05, &finer_reaction);
  std::printf("error %.3e at spacing 0.1, %.3e at 0.05, ratio %.2f; reactions off by %.1e, %.1e\n", error, finer,
              error / finer, reaction, finer_reaction);
  EXPECT_LT(reaction, 1e-12);
  EXPECT_LT(finer_reaction, 1e-12);
  EXPECT_LT(finer, 2e-4);
  EXPECT_GT(error / finer, 3.8);
}

// Points are the centres of cells, or corners that all stand for whole cells: the weight is right in either case.
TEST(BodyForce, of_the_lattices_of_every_scheme_sums_up_to_the_weight) {
  for (const std::string& scheme : regions::scheme_names()) {
    double reaction = 0;
    lattice_error(scheme.c_str(), 0.1, &reaction);
    EXPECT_LT(reaction, 1e-12) << scheme;
  }
}

// A plate of which the lower half is boundary elements and the upper half a lattice: the weight passes the interface.
TEST(BodyForce, passes_from_boundary_elements_to_a_lattice) {
  const Bar bar{{young, 1.0 / 3, PlaneState::stress, thickness}};
  Model m;
  scene::Scene& scene = m.editable_scene();
  scene.add_material({bar.elasticity});
  const std::vector<Point> c = bar.corners();
  regions::add_peridynamic_region(scene, 1, {{c[0].x(), 1}, {c[1].x(), 1}, c[2], c[3]}, 0.05, 3);
  regions::add_boundary_region(scene, 1, {c[0], c[1], {c[1].x(), 1}, {c[0].x(), 1}}, 0.1);
  hang(bar, m);
  const auto force = [bar](const Point&, double) -> scene::BoundaryValue {
    return {0.25 * bar.force(), 0.75 * bar.force()};
  };
  scene.add_load({std::make_shared<const regions::WholeRegion>(2), 3, force});
  m.driver().advance(1, fracture::Goal::load_factor);
  const double load = weight * width * height * thickness;
  EXPECT_LT((m.results().reaction(1) - Point(0, load)).norm(), 1e-11 * load);
  for (const regions::PointValue& value : m.results().evaluate({{0.1, 0.02}, {-0.2, 0.7}}, false))
    EXPECT_EQ(value.region, 2);
  const Point low(0.1, 0.02);
  const Point found = m.results().evaluate({low}, false)[0].displacement;
  EXPECT_LT((found - bar.displacement(low)).norm(), 2e-3 * bar.displacement(low).norm());
}

TEST(BodyForce, supports_cannot_hold_a_whole_region) {
  const Bar bar{{young, 0.3, PlaneState::stress, thickness}};
  Model m;
  m.editable_scene().add_material({bar.elasticity});
  regions::add_boundary_region(m.editable_scene(), 1, bar.corners(), 0.3);
  m.editable_scene().add_support({std::make_shared<const regions::WholeRegion>(1), 3, scene::SampledValues{{0}, {0}}});
  EXPECT_THROW(m.prepare(), Error);
}

}  // namespace
}  // namespace regions_body_force_test
