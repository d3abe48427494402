#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "paper/collocation_operator.hpp"
#include "paper/point_integrals.hpp"
#include "physics/bem_bodies.hpp"

namespace {

using namespace bempd;
using namespace bempd::bem;
using namespace bempd::bem_test;
using namespace bempd::paper;

using Real = long double;
using RealPoint = Eigen::Matrix<Real, 2, 1>;

RealPoint real(const Point& p) { return p.cast<Real>(); }

// The moments by their definition, with intervals that halve fifty times towards `centre` from both sides.
PointMoments reference_moments(const ElementGeometry& element, const RealPoint& x, Real centre, bool on_element) {
  const GaussRule& rule = gauss_rule(max_gauss_points);
  std::array<std::array<Real, 3>, 7> sums{};
  const auto shapes = [](Real xi) {
    return std::array<Real, 3>{xi * (xi - 1) / 2, (1 - xi) * (1 + xi), xi * (xi + 1) / 2};
  };
  const auto at_centre = shapes(centre);
  for (const Real end : {-1.0L, 1.0L}) {
    if (end == centre) continue;
    for (int level = 0; level < 50; ++level) {
      const Real from = (end - centre) * std::pow(0.5L, level + 1), length = from * (level == 49 ? 2 : 1);
      for (std::size_t i = 0; i < rule.points.size(); ++i) {
        const Real d = (level == 49 ? 0 : from) + length * rule.points[i], xi = centre + d;
        const RealPoint dx = real(element.c1) + 2 * xi * real(element.c2), n(dx.y(), -dx.x());
        // The difference of two positions on the element itself is a multiple of d.
        const RealPoint r = on_element
                                ? RealPoint(d * (real(element.c1) + (xi + centre) * real(element.c2)))
                                : RealPoint(real(element.c0) + xi * (real(element.c1) + xi * real(element.c2)) - x);
        const Real square = r.squaredNorm(), weight = std::abs(length) * rule.weights[i];
        const Real cosine = (r.x() * r.x() - r.y() * r.y()) / (2 * square), sine = r.x() * r.y() / square;
        const Real along = r.dot(n) / square, across = (n.x() * r.y() - n.y() * r.x()) / square;
        const Real kernels[7] = {std::log(square) / 2, cosine, sine, along, across, along * cosine, along * sine};
        const auto value = shapes(xi);
        for (int c = 0; c < 7; ++c)
          for (int b = 0; b < 3; ++b)
            sums[c][b] +=
                weight * kernels[c] * (c < 3 ? dx.norm() * value[b] : value[b] - (on_element ? at_centre[b] : 0));
      }
    }
  }
  PointMoments moments;
  for (int b = 0; b < 3; ++b) {
    for (int c = 0; c < 3; ++c) moments.mass[c][b] = static_cast<double>(sums[c][b]);
    for (int c = 0; c < 4; ++c) moments.double_layer[c][b] = static_cast<double>(sums[3 + c][b]);
  }
  return moments;
}

// Largest difference of the weakly singular and of the double layer moments, over the largest moment of the kind.
std::array<double, 2> differences(const PointMoments& value, const PointMoments& reference) {
  const auto compare = [](const auto& a, const auto& b) {
    double difference = 0, largest = 0;
    for (std::size_t c = 0; c < a.size(); ++c)
      for (int k = 0; k < 3; ++k) {
        difference = std::max(difference, std::abs(a[c][k] - b[c][k]));
        largest = std::max(largest, std::abs(b[c][k]));
      }
    return difference / largest;
  };
  return {compare(value.mass, reference.mass), compare(value.double_layer, reference.double_layer)};
}

const std::vector<ElementGeometry>& sample_elements() {
  static const std::vector<ElementGeometry> elements{
      {{0.1, 0.2}, {0.05, 0.02}, {0, 0}},           // straight
      {{0.1, 0.2}, {0.05, 0.02}, {-0.004, 0.008}},  // arc
      {{0.1, 0.2}, {0.05, 0.02}, {0.01, 0.02}}};    // strongly curved, nodes unevenly spaced
  return elements;
}

TEST(PointIntegrator, integrals_over_the_points_own_element_agree_with_brute_force) {
  const PointIntegrator integrator(sample_elements(), 1e-14);
  for (int e = 0; e < 3; ++e)
    for (const double xi0 : {-1.0, -2.0 / 3, 0.0, 2.0 / 3, 1.0}) {
      const PointMoments reference = reference_moments(sample_elements()[e], {0, 0}, xi0, true);
      const auto [weak, strong] = differences(integrator.on_element(e, xi0), reference);
      std::printf("element %d, xi %5.2f: weakly singular off by %.1e, double layer by %.1e\n", e, xi0, weak, strong);
      EXPECT_LE(weak, 1e-14);
      EXPECT_LE(strong, 1e-14);
    }
}

TEST(PointIntegrator, integrals_seen_from_near_and_far_agree_with_brute_force) {
  const PointIntegrator integrator(sample_elements(), 1e-14);
  for (int e = 0; e < 3; ++e) {
    const ElementGeometry& element = sample_elements()[e];
    for (const double distance : {10.0, 1.0, 0.3, 0.1, 1e-2, 1e-3}) {
      double largest_weak = 0, largest_strong = 0;
      // Places are on both sides, and beyond the end as seen from a neighbour.
      for (const double side : {-1.0, 1.0})
        for (const double centre : {-1.0, -0.4, 0.3, 1.0})
          for (const bool beyond : {false, true}) {
            const Point dx = element.derivative(centre);
            const Point x = element.at(centre) + distance * side * (beyond ? dx : scaled_normal(dx));
            if (beyond && (std::abs(centre) < 1 || side != centre)) continue;
            const auto [weak, strong] =
                differences(integrator.off_element(e, x), reference_moments(element, real(x), centre, false));
            largest_weak = std::max(largest_weak, weak);
            largest_strong = std::max(largest_strong, strong);
          }
      std::printf("element %d, distance %.0e of half its length: weakly singular off by %.1e, double layer by %.1e\n",
                  e, distance, largest_weak, largest_strong);
      EXPECT_LE(largest_weak, 1e-14);
      // Rounding of positions counts relative to the distance.
      EXPECT_LE(largest_strong, 1e-14 + 1e-16 / distance);
    }
  }
}

TEST(PointIntegrator, tolerance_saves_points) {
  const PointIntegrator exact(sample_elements(), 1e-14), coarse(sample_elements(), 1e-6);
  const Point x(0.2, 0.1);
  const PointMoments fine = exact.off_element(1, x), rough = coarse.off_element(1, x);
  const auto [weak, strong] = differences(rough, fine);
  EXPECT_LT(rough.evaluations, fine.evaluations);
  EXPECT_LE(std::max(weak, strong), 1e-6);
}

BoundaryMesh mesh_of(const std::vector<std::vector<Panel>>& loops, bool one_traction) {
  const BoundaryMesh mesh = mesh_boundary(loops);
  return one_traction ? with_one_traction_at_corners(mesh) : mesh;
}

const PlaneElasticity steel{210e9, 0.3, PlaneState::strain, 0.02};

TEST(CollocationOperator, is_bitwise_the_same_for_any_number_of_threads) {
  for (const Body& body : {bodies()[2], bodies()[4]})
    for (const bool one_traction : {true, false}) {
      const BoundaryMesh mesh = mesh_of(body.loops, one_traction);
      const CollocationOperator one(mesh, steel, {.threads = 1}), two(mesh, steel, {.threads = 2});
      EXPECT_TRUE(one.stiffness() == two.stiffness()) << body.name;
      EXPECT_TRUE(one.traction_matrix() == two.traction_matrix()) << body.name;
      EXPECT_EQ(one.kernel_evaluations(), two.kernel_evaluations());
    }
}

TEST(CollocationOperator, stiffness_is_the_consistent_force_of_the_tractions) {
  const BoundaryMesh mesh = mesh_boundary({rectangle(1, 0.5, 0.25)});
  const CollocationOperator collocation(mesh, steel);
  Eigen::MatrixXd u(2 * mesh.nodes.size(), 2);
  u.col(0) = nodal_values(mesh, [](const Point& x) { return Point(x.x() * x.y(), x.y() * x.y()); });
  u.col(1) = nodal_values(mesh, [](const Point& x) { return Point(x.y(), 2 * x.x()); });
  const Eigen::MatrixXd t = collocation.tractions(u);
  EXPECT_EQ(t.rows(), 2 * mesh.traction_node_count);
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(u.rows(), 2);
  // Integrals of N_a N_b over a straight element of unit length.
  const double mass[3][3] = {
      {4 / 30.0, 2 / 30.0, -1 / 30.0}, {2 / 30.0, 16 / 30.0, 2 / 30.0}, {-1 / 30.0, 2 / 30.0, 4 / 30.0}};
  for (const BoundaryElement& e : mesh.elements) {
    const double length = (mesh.nodes[e.nodes[2]] - mesh.nodes[e.nodes[0]]).norm();
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        forces.middleRows<2>(2 * e.nodes[a]) +=
            steel.thickness * length * mass[a][b] * t.middleRows<2>(2 * e.traction_nodes[b]);
  }
  EXPECT_LE((collocation.stiffness() * u - forces).norm(), 1e-13 * forces.norm());
}

// An annulus of isoparametric arcs, made by bending the straight meshes of two regular polygons.
BoundaryMesh annulus(bool one_traction) {
  std::vector<Point> outer, inner;
  for (int i = 0; i < 8; ++i)
    outer.emplace_back(2 * std::cos(i * std::numbers::pi / 4), 2 * std::sin(i * std::numbers::pi / 4));
  for (int i = 0; i < 8; ++i)
    inner.emplace_back(std::cos(i * std::numbers::pi / 4), -std::sin(i * std::numbers::pi / 4));
  BoundaryMesh mesh = mesh_of({polygon(outer, 10), polygon(inner, 10)}, one_traction);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    mesh.nodes[n] *= (n < mesh.nodes.size() / 2 ? 2.0 : 1.0) / mesh.nodes[n].norm();
  return mesh;
}

TEST(CollocationOperator, curved_elements_keep_rigid_motions) {
  for (const bool one_traction : {true, false}) {
    const BoundaryMesh mesh = annulus(one_traction);
    const Eigen::MatrixXd k = CollocationOperator(mesh, steel).stiffness();
    for (const Field& motion : {Field([](const Point&) { return Point(1, 0.5); }),
                                Field([](const Point& x) { return Point(-x.y(), x.x()); })}) {
      const Eigen::VectorXd u = nodal_values(mesh, motion);
      EXPECT_LE((k * u).norm(), 1e-14 * k.norm() * u.norm());
    }
  }
}

TEST(OneTractionAtCorners, makes_traction_nodes_of_the_displacement_nodes) {
  const std::vector<std::vector<Panel>> loops{rectangle(1, 0.5, 0.25)};
  const BoundaryMesh one = mesh_of(loops, true), two = mesh_boundary(loops);
  EXPECT_EQ(one.traction_node_count, static_cast<int>(one.nodes.size()));
  EXPECT_EQ(two.traction_node_count, one.traction_node_count + 4);
  for (const BoundaryElement& e : one.elements) EXPECT_EQ(e.nodes, e.traction_nodes);
}

}  // namespace
