#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "thorough.hpp"
#include "unit/pd_bodies.hpp"
#include "unit/pd_kernels.hpp"

namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;

// Third moments of the bonds at every point against the faces around it, from scratch: half of every boundary edge's
// normal goes to each of its ends.
double exactness_error(const CellLattice& lattice, const Network& network, const PlaneElasticity& elasticity) {
  std::vector<Eigen::Vector4d> error(lattice.point_count(), Eigen::Vector4d::Zero());
  for (const Bond& bond : network.bonds) {
    const Eigen::Vector2d step = (lattice.point(bond.second) - lattice.point(bond.first)).cast<double>();
    const double x = step.x(), y = step.y(), k = bond.stiffness / step.squaredNorm();
    const Eigen::Vector4d moment = k * Eigen::Vector4d(x * x * x, x * x * y, x * y * y, y * y * y);
    error[bond.first] += moment;
    error[bond.second] -= moment;
  }
  const double c11 = elasticity.c11() * elasticity.thickness, c12 = elasticity.c12() * elasticity.thickness;
  for (int i = 0; i < lattice.point_count(); ++i) {
    const Vector2i p = lattice.point(i);
    const int ll = lattice.has_cell(p - Vector2i(1, 1)), lr = lattice.has_cell(p - Vector2i(0, 1));
    const int ul = lattice.has_cell(p - Vector2i(1, 0)), ur = lattice.has_cell(p);
    const double nx = 0.5 * ((ul - ur) + (ll - lr)), ny = 0.5 * ((ll - ul) + (lr - ur));
    error[i] += Eigen::Vector4d(c11 * nx, c12 * ny, c12 * nx, c11 * ny);
  }
  double largest = 0;
  for (const auto& e : error) largest = std::max(largest, e.lpNorm<Eigen::Infinity>() / c11);
  return largest;
}

TEST(Network, is_exact_and_positive_on_every_body) {
  for (const Body& body : bodies()) {
    const CellLattice lattice(body.loops);
    for (int m = 2; m <= bempd_tests::cases(4, 6); ++m) {
      const PlaneState state = m % 2 == 0 ? PlaneState::stress : PlaneState::strain;
      const PlaneElasticity elasticity = bond_based(3e7, state, 0.02);
      const Network network = build_network(lattice, m, elasticity);
      EXPECT_LT(exactness_error(lattice, network, elasticity), 1e-14) << body.name << " m " << m;
      EXPECT_LT(network.max_residual, 1e-14) << body.name << " m " << m;
      EXPECT_GT(network.min_weight_ratio, 0.019) << body.name << " m " << m;
      EXPECT_FALSE(network.reduced) << body.name << " m " << m;
      for (const Bond& bond : network.bonds) ASSERT_GT(bond.stiffness, 0) << body.name << " m " << m;
    }
  }
}

TEST(Network, is_exact_with_another_kernel_too) {
  const PlaneElasticity elasticity = bond_based(3e7, PlaneState::stress, 0.02);
  for (const Body& body : bodies()) {
    const CellLattice lattice(body.loops);
    for (int m = 2; m <= bempd_tests::cases(3, 5); ++m) {
      const Network network = build_network(lattice, m, elasticity, 0, conical_kernel());
      EXPECT_LT(exactness_error(lattice, network, elasticity), 1e-14) << body.name << " m " << m;
      EXPECT_LT(network.max_residual, 1e-14) << body.name << " m " << m;
      EXPECT_FALSE(network.reduced) << body.name << " m " << m;
    }
  }
}

TEST(Network, is_exact_on_rectangles_at_the_longest_horizons) {
  const PlaneElasticity elasticity = bond_based(1, PlaneState::stress, 1);
  for (const auto& [width, height] : {std::pair{9, 30}, {5, 20}, {3, 20}, {2, 20}, {6, 6}}) {
    const CellLattice lattice({rectangle(0, 0, width, height)});
    for (int m = 7; m <= 8; ++m) {
      const Network network = build_network(lattice, m, elasticity);
      EXPECT_LT(exactness_error(lattice, network, elasticity), 1e-14) << width << " x " << height << " m " << m;
      EXPECT_GT(network.min_weight_ratio, 0.019);
      EXPECT_FALSE(network.reduced);
    }
  }
}

TEST(Network, bonds_are_sorted_unique_and_consistent_with_their_offsets) {
  for (const Body& body : bodies()) {
    const CellLattice lattice(body.loops);
    const Network network = build_network(lattice, 4, bond_based(1, PlaneState::stress, 1));
    ASSERT_EQ(network.offset_of.size(), network.bonds.size());
    for (std::size_t b = 0; b < network.bonds.size(); ++b) {
      const Bond& bond = network.bonds[b];
      const Vector2i step = lattice.point(bond.second) - lattice.point(bond.first);
      EXPECT_EQ(network.offsets[network.offset_of[b]].step, step.cast<double>());
      if (b == 0) continue;
      const Bond& last = network.bonds[b - 1];
      EXPECT_TRUE(last.first < bond.first || (last.first == bond.first && last.second < bond.second));
    }
  }
}

TEST(Network, deep_bonds_keep_the_bulk_stiffness) {
  const CellLattice lattice({rectangle(0, 0, 40, 40)});
  const PlaneElasticity elasticity = bond_based(8.0 / 9, PlaneState::stress, 1);  // C1111 = 1
  const Network network = build_network(lattice, 4, elasticity);
  int deep = 0;
  for (std::size_t b = 0; b < network.bonds.size(); ++b) {
    const Vector2i p = lattice.point(network.bonds[b].first), q = lattice.point(network.bonds[b].second);
    if (p.cwiseMin(q).minCoeff() < 10 || p.cwiseMax(q).maxCoeff() > 30) continue;
    const double bulk = network.offsets[network.offset_of[b]].bulk_stiffness;
    EXPECT_NEAR(network.bonds[b].stiffness, bulk, 1e-15);
    ++deep;
  }
  EXPECT_GT(deep, 5000);
}

TEST(Network, bonds_leaving_the_body_are_dropped_and_those_along_a_face_stay) {
  const CellLattice lattice({{{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}}});
  const Network network = build_network(lattice, 4, bond_based(1, PlaneState::stress, 1));
  const auto has = [&](const Vector2i& p, const Vector2i& q) {
    const int i = lattice.find_point(p), j = lattice.find_point(q);
    return std::any_of(network.bonds.begin(), network.bonds.end(), [&](const Bond& b) {
      return (b.first == i && b.second == j) || (b.first == j && b.second == i);
    });
  };
  EXPECT_FALSE(has({11, 10}, {10, 11}));
  EXPECT_FALSE(has({11, 9}, {10, 12}));
  EXPECT_TRUE(has({11, 9}, {9, 11}));  // through the re-entrant corner
  EXPECT_TRUE(has({10, 11}, {10, 13}));
  EXPECT_TRUE(has({10, 11}, {10, 9}));
}

TEST(Network, one_cell_wide_parts_have_nearest_neighbours_only) {
  const CellLattice lattice({rectangle(0, 0, 1, 20)});
  const Network network = build_network(lattice, 5, bond_based(1, PlaneState::stress, 1));
  EXPECT_EQ(network.bonds.size(), 21u + 40u + 40u);
  for (const Bond& bond : network.bonds) {
    EXPECT_LE((lattice.point(bond.second) - lattice.point(bond.first)).squaredNorm(), 2);
  }
}

// Bitwise: a symmetric body has to break symmetrically.
TEST(Network, mirrored_bonds_have_the_same_stiffness) {
  const PlaneElasticity elasticity = bond_based(1, PlaneState::stress, 1);
  const std::vector<Body> symmetric = {{"rectangle", {rectangle(2, -7, 31, 18)}},
                                       {"square", {rectangle(0, 0, 21, 21)}},
                                       {"hole", {rectangle(0, 0, 30, 24), hole(11, 8, 8, 8)}},
                                       {"slit", {rectangle(0, 0, 30, 25), hole(9, 12, 12, 1)}}};
  for (const Body& body : symmetric) {
    const CellLattice lattice(body.loops);
    const Network network = build_network(lattice, 4, elasticity);
    std::map<std::pair<int, int>, double> stiffness;
    for (const Bond& b : network.bonds) {
      stiffness[{b.first, b.second}] = stiffness[{b.second, b.first}] = b.stiffness;
    }
    const Vector2i sum = lattice.lower() + lattice.upper();
    for (const Bond& b : network.bonds) {
      const Vector2i p = lattice.point(b.first), q = lattice.point(b.second);
      const auto image = [&](bool x, bool y) {
        const auto map = [&](const Vector2i& r) {
          return lattice.find_point({x ? sum.x() - r.x() : r.x(), y ? sum.y() - r.y() : r.y()});
        };
        return stiffness.at({map(p), map(q)});
      };
      EXPECT_EQ(b.stiffness, image(true, false)) << body.name;
      EXPECT_EQ(b.stiffness, image(false, true)) << body.name;
      EXPECT_EQ(b.stiffness, image(true, true)) << body.name;
    }
  }
}

// Bitwise: one solution serves all places that are the same problem.
TEST(Network, equal_holes_of_an_unsymmetric_plate_have_the_same_bonds) {
  const Vector2i apart(33, 0);
  const CellLattice lattice(
      {{{0, 0}, {90, 0}, {90, 20}, {93, 20}, {93, 36}, {0, 36}}, hole(22, 17, 4, 3), hole(55, 17, 4, 3)});
  const Network network = build_network(lattice, 3, bond_based(1, PlaneState::stress, 1));
  std::map<std::pair<int, int>, double> stiffness;
  for (const Bond& b : network.bonds) stiffness[{b.first, b.second}] = b.stiffness;
  int changed = 0, different = 0;
  for (std::size_t k = 0; k < network.bonds.size(); ++k) {
    const Bond& b = network.bonds[k];
    const Vector2i p = lattice.point(b.first), q = lattice.point(b.second), low = p.cwiseMin(q), high = p.cwiseMax(q);
    if ((low.array() < Eigen::Array2i(16, 11)).any() || (high.array() > Eigen::Array2i(32, 26)).any()) continue;
    different += b.stiffness != stiffness.at({lattice.find_point(p + apart), lattice.find_point(q + apart)});
    changed += std::abs(b.stiffness / network.offsets[network.offset_of[k]].bulk_stiffness - 9.0 / 8) > 1e-6;
  }
  EXPECT_GT(changed, 100);
  EXPECT_EQ(different, 0);
}

TEST(Network, does_not_depend_on_where_the_lattice_lies_or_on_the_magnitude_of_the_modulus) {
  const CellLattice here({rectangle(0, 0, 15, 12)}), there({rectangle(-1000, 5000, 15, 12)});
  const Network a = build_network(here, 4, bond_based(1, PlaneState::stress, 1));
  const Network b = build_network(there, 4, bond_based(1e15, PlaneState::stress, 1e-3));
  ASSERT_EQ(a.bonds.size(), b.bonds.size());
  for (std::size_t k = 0; k < a.bonds.size(); ++k) {
    EXPECT_NEAR(b.bonds[k].stiffness / a.bonds[k].stiffness, 1e12, 1e-2);
  }
}

}  // namespace
