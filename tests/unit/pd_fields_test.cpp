#include <gtest/gtest.h>

#include <cmath>

#include "pd/critical_stretch.hpp"
#include "pd/deformation.hpp"
#include "pd/face_loads.hpp"
#include "unit/pd_bodies.hpp"

namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;

TEST(FaceLoads, polynomial_traction_has_its_resultant_and_moment) {
  const CellLattice lattice({rectangle(1, 2, 8, 5)});
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * lattice.point_count());
  add_face_forces(
      lattice, {2.3, 2}, {7.75, 2}, [](const Point& x) { return Point(1, x.x() * x.x()); }, forces);
  double fx = 0, fy = 0, moment = 0;
  for (int i = 0; i < lattice.point_count(); ++i) {
    fx += forces[2 * i];
    fy += forces[2 * i + 1];
    moment += lattice.point(i).x() * forces[2 * i + 1];
    if (lattice.point(i).y() != 2 || lattice.point(i).x() < 2 || lattice.point(i).x() > 8) {
      EXPECT_EQ(forces[2 * i], 0);
    }
  }
  EXPECT_NEAR(fx, 7.75 - 2.3, 1e-13);
  EXPECT_NEAR(fy, (std::pow(7.75, 3) - std::pow(2.3, 3)) / 3, 1e-11);
  EXPECT_NEAR(moment, (std::pow(7.75, 4) - std::pow(2.3, 4)) / 4, 1e-10);
}

TEST(FaceLoads, direction_of_the_piece_does_not_matter_and_ends_snap_to_points) {
  const CellLattice lattice({rectangle(0, 0, 4, 4)});
  Eigen::VectorXd up = Eigen::VectorXd::Zero(2 * lattice.point_count()), down = up;
  const auto pull = [](const Point&) { return Point(1, 0); };
  add_face_forces(lattice, {4, 1 - 1e-12}, {4, 3 + 1e-12}, pull, up);
  add_face_forces(lattice, {4, 3}, {4, 1}, pull, down);
  EXPECT_LT((up - down).norm(), 1e-15);
  EXPECT_NEAR(up[2 * lattice.find_point({4, 1})], 0.5, 1e-15);
  EXPECT_NEAR(up[2 * lattice.find_point({4, 2})], 1.0, 1e-15);
  EXPECT_EQ(up[2 * lattice.find_point({4, 4})], 0);
}

TEST(Deformation, linear_field_has_its_strain_at_every_point) {
  Eigen::Matrix2d g;
  g << 0.3, -1.2, 0.7, 0.1;
  const Eigen::Vector3d expected(0.3, 0.1, -0.25);
  for (const Body& body : bodies()) {
    const CellLattice lattice(body.loops);
    const Network network = build_network(lattice, 3, bond_based(1, PlaneState::stress, 1));
    Eigen::VectorXd u(2 * lattice.point_count());
    for (int i = 0; i < lattice.point_count(); ++i) {
      u.segment<2>(2 * i) = g * lattice.point(i).cast<double>() + Eigen::Vector2d(4, 5);
    }
    for (const Eigen::Vector3d& strain : bond_strains(lattice.point_count(), network, {}, u)) {
      EXPECT_LT((strain - expected).norm(), 1e-12) << body.name;
    }
  }
}

// Far from faces: sum f xi^T / (2 V) over the bonds of a point, V being one cell.
TEST(Deformation, stress_in_the_bulk_is_the_mean_stress_of_the_bonds) {
  const CellLattice lattice({rectangle(0, 0, 14, 14)});
  const PlaneElasticity elasticity = bond_based(7, PlaneState::strain, 0.4);
  const Network network = build_network(lattice, 3, elasticity);
  Eigen::VectorXd u(2 * lattice.point_count());
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = std::sin(1.0 + 37 * static_cast<double>(i));
  const int middle = lattice.find_point({7, 7});
  BondStates states{std::vector<double>(network.bonds.size(), 1), std::vector<double>(network.bonds.size(), 0)};
  Eigen::Matrix2d mean = Eigen::Matrix2d::Zero();
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const Bond& bond = network.bonds[b];
    // Broken, softened, or at rest at a stretch of its own.
    if (b % 3 == 0) states.share[b] = 0;
    if (b % 7 == 1) states.share[b] = 0.4;
    if (b % 5 == 2) states.rest_stretch[b] = 0.3;
    if (states.share[b] == 0 || (bond.first != middle && bond.second != middle)) continue;
    const Eigen::Vector2d step = network.offsets[network.offset_of[b]].step, e = step.normalized();
    const double elongation =
        e.dot(u.segment<2>(2 * bond.second) - u.segment<2>(2 * bond.first)) - states.rest_stretch[b] * step.norm();
    mean += states.share[b] * bond.stiffness * elongation * e * step.transpose() / (2 * elasticity.thickness);
  }
  const Eigen::Vector3d stress = stress_of(bond_strains(lattice.point_count(), network, states, u)[middle], elasticity);
  EXPECT_NEAR(stress[0], mean(0, 0), 1e-12 * mean.norm());
  EXPECT_NEAR(stress[1], mean(1, 1), 1e-12 * mean.norm());
  EXPECT_NEAR(stress[2], mean(0, 1), 1e-12 * mean.norm());
}

TEST(Deformation, points_without_intact_bonds_have_no_strain_and_rotation_strains_nothing) {
  const CellLattice lattice({rectangle(0, 0, 3, 3)});
  const Network network = build_network(lattice, 3, bond_based(1, PlaneState::stress, 1));
  Eigen::VectorXd u(2 * lattice.point_count()), rotation = u;
  for (int i = 0; i < lattice.point_count(); ++i) {
    u.segment<2>(2 * i) = 0.01 * lattice.point(i).cast<double>();
    rotation.segment<2>(2 * i) = Eigen::Vector2d(-lattice.point(i).y(), lattice.point(i).x());
  }
  // Keep one bond only.
  BondStates broken{std::vector<double>(network.bonds.size(), 0), {}};
  broken.share[7] = 1;
  const auto turned = bond_strains(lattice.point_count(), network, broken, rotation);
  const auto stretched = bond_strains(lattice.point_count(), network, broken, u);
  for (int i = 0; i < lattice.point_count(); ++i) {
    EXPECT_LT(turned[i].norm(), 1e-14);
    const bool is_end = i == network.bonds[7].first || i == network.bonds[7].second;
    EXPECT_EQ(stretched[i].norm() > 0, is_end);
  }
}

// Bonds that all are longer by the same share at rest carry nothing in a body that is longer by it, up to its faces.
TEST(Deformation, of_bonds_at_rest_is_none_at_every_point) {
  for (const Body& body : bodies()) {
    const CellLattice lattice(body.loops);
    const Network network = build_network(lattice, 3, bond_based(1, PlaneState::stress, 1));
    Eigen::VectorXd u(2 * lattice.point_count());
    for (int i = 0; i < lattice.point_count(); ++i) u.segment<2>(2 * i) = 0.01 * lattice.point(i).cast<double>();
    BondStates states{{}, std::vector<double>(network.bonds.size(), 0.01)};
    for (const Eigen::Vector3d& strain : bond_strains(lattice.point_count(), network, states, u))
      EXPECT_LT(strain.norm(), 1e-13) << body.name;
    // Half as stiff they carry half.
    states = {std::vector<double>(network.bonds.size(), 0.5), {}};
    for (const Eigen::Vector3d& strain : bond_strains(lattice.point_count(), network, states, u))
      EXPECT_LT((strain - Eigen::Vector3d(0.005, 0.005, 0)).norm(), 1e-13) << body.name;
  }
}

TEST(Deformation, stress_follows_hookes_law) {
  const PlaneElasticity elasticity = bond_based(90, PlaneState::stress, 1);
  const Eigen::Vector3d stress = stress_of({1, -1.0 / 3, 0.5}, elasticity);
  EXPECT_NEAR(stress[0], 90, 1e-12);
  EXPECT_NEAR(stress[1], 0, 1e-12);
  EXPECT_NEAR(stress[2], 90 / (1 + 1.0 / 3) * 0.5, 1e-12);
}

// s_c = sqrt(64 pi G0 / (105 E horizon)) and sqrt(4 pi G0 / (7 E horizon)).
TEST(CriticalStretch, has_the_exact_constants_and_an_inverse) {
  EXPECT_NEAR(std::pow(critical_stretch(1, bond_based(1, PlaneState::stress, 1), 1), 2), 1.91488, 6e-6);
  EXPECT_NEAR(std::pow(critical_stretch(1, bond_based(1, PlaneState::strain, 1), 1), 2), 1.79520, 6e-6);
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain}) {
    const double s = critical_stretch(120, bond_based(3e10, state, 1), 0.004);
    EXPECT_NEAR(fracture_energy(s, bond_based(3e10, state, 1), 0.004), 120, 1e-10);
  }
}

// G0 = 105 E' horizon / (64 pi) s_c^2 min(1, 8 beta / (3 E')), beta = min(mu, (lambda + mu) / 2), the modulus of bonds.
TEST(CriticalStretch, follows_the_modulus_of_bonds_below_the_ratio_that_they_have_alone) {
  for (const double nu : {-0.2, 0.0, 0.2, 0.4, 0.49}) {
    const double beta = std::min(1 / (2 * (1 + nu)), (1 / (2 * (1 + nu)) + nu / (1 - nu * nu)) / 2);
    const double expected = 105 / (64 * M_PI) * (nu < 1.0 / 3 ? 8 * beta / 3 : 1);
    EXPECT_NEAR(fracture_energy(1, {1, nu, PlaneState::stress, 1}, 1) / expected, 1, 1e-14) << nu;
    const double modulus = 1 / (1 - nu * nu);
    if (nu > 0.25) {
      EXPECT_NEAR(fracture_energy(1, {1, nu, PlaneState::strain, 1}, 1) / (105 / (64 * M_PI) * modulus), 1, 1e-14)
          << nu;
    }
  }
  // The critical stretch has no jump where bonds alone make the material.
  for (const PlaneState state : {PlaneState::stress, PlaneState::strain}) {
    const double nu = bond_based_poisson_ratio(state), energy = fracture_energy(1, {1, nu, state, 1}, 1);
    for (const double change : {-1e-5, 1e-5})
      EXPECT_NEAR(fracture_energy(1, {1, nu + change, state, 1}, 1) / energy, 1, 4e-5);
  }
}

// s_c = sqrt(1024 pi G0 / (7 (120 pi - 133) E horizon)).
TEST(CriticalStretch, as_printed_is_a_little_smaller) {
  EXPECT_NEAR(std::pow(printed_critical_stretch(1, 1, 1), 2), 1.88355, 6e-6);
  EXPECT_NEAR(1 - printed_critical_stretch(2, 3, 4) / critical_stretch(2, bond_based(3, PlaneState::stress, 1), 4),
              0.0082, 5e-5);
}

// All bonds of the continuum across a plane, integrated numerically: G0 = 2 int_0^d int_z^d int_0^acos(z/r) c0 g s^2/2
// r ...
TEST(CriticalStretch, agrees_with_the_energy_of_all_bonds_across_a_plane) {
  const double c0 = 315 / (8 * M_PI);  // E = horizon = 1, plane stress
  double energy = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i) {
    const double r = (i + 0.5) / n;
    // Bonds of length r and angle t to the normal cross the plane from a layer of thickness r cos t.
    for (int j = 0; j < n; ++j) {
      const double t = (-0.5 + (j + 0.5) / n) * M_PI;
      energy += c0 * (1 - r * r) * (1 - r * r) * r / 2 * r * std::cos(t) * r * (1.0 / n) * (M_PI / n);
    }
  }
  EXPECT_NEAR(fracture_energy(1, bond_based(1, PlaneState::stress, 1), 1) / energy, 1, 1e-4);
}

}  // namespace
