#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pd/bond_family.hpp"
#include "pd/bond_kernel.hpp"
#include "pd/cell_grid.hpp"
#include "pd/face_template.hpp"
#include "unit/pd_bodies.hpp"
#include "unit/pd_kernels.hpp"

namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;

TEST(Lattice, has_the_corners_of_all_cells_row_by_row) {
  const CellLattice lattice({rectangle(-2, 3, 3, 2)});
  EXPECT_EQ(lattice.cell_count(), 6);
  ASSERT_EQ(lattice.point_count(), 12);
  EXPECT_EQ(lattice.point(0), Vector2i(-2, 3));
  EXPECT_EQ(lattice.point(5), Vector2i(-1, 4));
  for (int i = 0; i < lattice.point_count(); ++i) EXPECT_EQ(lattice.find_point(lattice.point(i)), i);
  EXPECT_EQ(lattice.find_point({2, 3}), -1);
  EXPECT_EQ(lattice.find_point({-3, 4}), -1);
  const auto corners = lattice.cell_corners({0, 4});
  EXPECT_EQ(lattice.point(corners[0]), Vector2i(0, 4));
  EXPECT_EQ(lattice.point(corners[3]), Vector2i(1, 5));
}

TEST(Lattice, holes_have_no_cells_but_points_on_their_faces) {
  const CellLattice lattice({rectangle(0, 0, 9, 9), hole(3, 3, 3, 3)});
  EXPECT_EQ(lattice.cell_count(), 72);
  EXPECT_EQ(lattice.point_count(), 100 - 4);
  EXPECT_FALSE(lattice.has_cell({4, 4}));
  EXPECT_TRUE(lattice.has_cell({6, 4}));
  EXPECT_GE(lattice.find_point({3, 3}), 0);
  EXPECT_EQ(lattice.find_point({4, 4}), -1);
  EXPECT_EQ(lattice.cells_around(lattice.find_point({3, 3})), 3);
  EXPECT_EQ(lattice.cells_around(lattice.find_point({4, 3})), 2);
  EXPECT_EQ(lattice.cells_around(lattice.find_point({0, 0})), 1);
  EXPECT_EQ(lattice.cells_around(lattice.find_point({1, 1})), 4);
}

TEST(Lattice, cells_match_the_area_of_every_body) {
  for (const Body& body : bodies()) {
    double area = 0;
    for (const Loop& loop : body.loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        area += 0.5 * cross(loop[k].cast<double>(), loop[(k + 1) % loop.size()].cast<double>());
      }
    }
    EXPECT_EQ(CellLattice(body.loops).cell_count(), std::lround(area)) << body.name;
  }
}

TEST(Lattice, centres_of_cells_make_a_lattice_of_their_own) {
  const CellLattice cells({rectangle(-2, 3, 9, 9), hole(1, 6, 3, 3)});
  const CellLattice centres = CellLattice::centres_of(cells);
  EXPECT_EQ(centres.point_count(), 72);
  EXPECT_EQ(centres.lower(), Vector2i(-2, 3));
  EXPECT_EQ(centres.upper(), Vector2i(6, 11));
  EXPECT_EQ(centres.find_point({2, 7}), -1);
  EXPECT_EQ(centres.find_point({7, 5}), -1);
  for (int i = 0; i < centres.point_count(); ++i) {
    EXPECT_TRUE(cells.has_cell(centres.point(i)));
    EXPECT_EQ(centres.find_point(centres.point(i)), i);
    if (i == 0) continue;
    const Vector2i p = centres.point(i - 1), q = centres.point(i);
    EXPECT_TRUE(p.y() < q.y() || (p.y() == q.y() && p.x() < q.x()));
  }
  // 8 x 8 blocks of four, less the 4 x 4 that reach into the hole.
  EXPECT_EQ(centres.cell_count(), 64 - 16);
  EXPECT_TRUE(centres.has_cell({-1, 4}));
  EXPECT_FALSE(centres.has_cell({0, 5}));
  EXPECT_FALSE(centres.has_cell({6, 4}));
  EXPECT_EQ(centres.cells_around(centres.find_point({0, 5})), 3);
  EXPECT_EQ(centres.cells_around(centres.find_point({-2, 3})), 1);
}

TEST(Lattice, centres_of_a_body_one_cell_wide_have_no_cells) {
  const CellLattice centres = CellLattice::centres_of(CellLattice({rectangle(4, 5, 1, 6)}));
  EXPECT_EQ(centres.point_count(), 6);
  EXPECT_EQ(centres.cell_count(), 0);
  EXPECT_EQ(centres.point(5), Vector2i(4, 10));
  EXPECT_EQ(centres.cells_around(2), 0);
  EXPECT_FALSE(centres.has_cell({4, 6}));
}

// Independent test of visibility: many places along the bond, each in a closed cell.
TEST(Lattice, line_of_sight_agrees_with_sampling) {
  int checked = 0;
  for (const Body& body : bodies()) {
    const CellLattice lattice(body.loops);
    CellGrid cells(lattice, 12);
    cells.finish(12);
    for (int i = 0; i < lattice.point_count(); i += 3) {
      for (const BondOffset& offset : bond_family(6)) {
        bool inside = true;
        for (int k = 0; k < 360 && inside; ++k) {
          // 360 * 5! divisions never hit a lattice line by accident; lines are met at k = 0 only.
          const double t = (k + 0.5) / 360;
          const Eigen::Vector2d x = lattice.point(i).cast<double>() + t * offset.step;
          bool covered = false;
          for (int sx = -1; sx <= 1; sx += 2) {
            for (int sy = -1; sy <= 1; sy += 2) {
              covered = covered || lattice.has_cell({static_cast<int>(std::floor(x.x() + sx * 1e-7)),
                                                     static_cast<int>(std::floor(x.y() + sy * 1e-7))});
            }
          }
          inside = covered;
        }
        EXPECT_EQ(cells.in_sight(lattice.point(i), offset.step.cast<int>()), inside)
            << body.name << " from " << lattice.point(i).transpose() << " step " << offset.step.transpose();
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 10000);
}

TEST(BondFamily, is_half_of_the_integer_disc_and_sorted) {
  for (int m = 2; m <= 8; ++m) {
    int expected = 0;
    for (int a = -m; a <= m; ++a) {
      for (int b = -m; b <= m; ++b) expected += a * a + b * b > 0 && a * a + b * b < m * m;
    }
    const auto family = bond_family(m);
    EXPECT_EQ(2 * static_cast<int>(family.size()), expected);
    for (std::size_t k = 1; k < family.size(); ++k) {
      const Vector2i p = family[k - 1].step.cast<int>(), q = family[k].step.cast<int>();
      EXPECT_TRUE(p.y() < q.y() || (p.y() == q.y() && p.x() < q.x()));
    }
  }
}

TEST(BondFamily, has_the_elastic_constants_exactly_and_is_positive) {
  for (int m = 2; m <= 8; ++m) {
    double c1111 = 0, c2222 = 0, c1122 = 0;
    for (const BondOffset& o : bond_family(m)) {
      EXPECT_GT(o.bulk_stiffness, 0);
      const double c = o.direction.x() * o.direction.x(), s = o.direction.y() * o.direction.y();
      const double k = o.bulk_stiffness * o.length * o.length;
      c1111 += k * c * c, c2222 += k * s * s, c1122 += k * c * s;
    }
    EXPECT_NEAR(c1111, 1, 1e-15);
    EXPECT_NEAR(c2222, 1, 1e-15);
    EXPECT_NEAR(c1122, 1.0 / 3, 1e-15);
  }
}

// k / (h E) in plane stress, where C1111 = 9 E / 8; from an independent calculation.
TEST(BondFamily, agrees_with_an_independent_calculation) {
  const double expected[][4] = {{3, 1, 0, .342036}, {3, 2, 0, .061972}, {3, 1, 1, .225774}, {3, 2, 1, .044466},
                                {3, 2, 2, .001734}, {4, 1, 0, .167560}, {4, 2, 0, .052160}, {4, 3, 0, .011501},
                                {4, 1, 1, .111211}, {4, 2, 1, .042563}, {4, 3, 1, .008585}, {4, 2, 2, .019004},
                                {4, 3, 2, .001865}};
  for (const auto& e : expected) {
    int found = 0;
    for (const BondOffset& o : bond_family(static_cast<int>(e[0]))) {
      const double a = std::abs(o.step.x()), b = o.step.y();
      if (std::max(a, b) != e[1] || std::min(a, b) != e[2]) continue;
      EXPECT_NEAR(o.bulk_stiffness * 9 / 8, e[3], 6e-7);
      ++found;
    }
    EXPECT_GT(found, 0);
  }
}

// k / (h E), plane stress, horizon ratio 3; from an independent calculation.
TEST(FaceTemplate, agrees_with_an_independent_calculation) {
  const double expected[3][8] = {{.524230, .071845, .168197, .270856, .052527, .039145, .036654, .001738},
                                 {.310224, .060152, .324491, .218757, .043392, .059668, .045353, .001733},
                                 {.346142, .061948, .355381, .229448, .044486, .063724, .042708, .001726}};
  const int steps[8][2] = {{0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}, {2, 0}, {2, 1}, {2, 2}};
  const LatticeTemplates& templates = lattice_templates(3);
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 8; ++k) {
      for (const BondOffset& o : templates.family) {
        if (o.step != Vector2i(steps[k][0], steps[k][1]).cast<double>()) continue;
        EXPECT_NEAR(templates.face.ratio(row, steps[k][0], steps[k][1]) * o.bulk_stiffness * 9 / 8, expected[row][k],
                    1.2e-6);
      }
    }
  }
}

TEST(FaceTemplate, ratios_have_the_known_range) {
  const double expected[][3] = {{3, .49, 1.53}, {4, .56, 2.17}, {5, .62, 2.84},
                                {6, .42, 3.46}, {7, .25, 4.17}, {8, .125, 5.01}};
  for (const auto& e : expected) {
    const int m = static_cast<int>(e[0]);
    const LatticeTemplates& templates = lattice_templates(m);
    double low = 1, high = 1;
    for (const BondOffset& o : templates.family) {
      for (int row = 0; row < m; ++row) {
        const Vector2i step = o.step.cast<int>();
        const double ratio = templates.face.ratio(row, std::abs(step.x()), step.y());
        low = std::min(low, ratio), high = std::max(high, ratio);
      }
    }
    EXPECT_NEAR(low, e[1], .006);
    EXPECT_NEAR(high, e[2], .006);
    EXPECT_LT(templates.residual, 1e-13);
  }
}

// The integrals of c r^2 and c r^3 by the midpoint rule.
TEST(BondKernel, has_the_elastic_constant_and_the_fracture_energy_that_it_says) {
  for (const BondKernel* kernel : {&quartic_kernel(), &conical_kernel()}) {
    const double horizon = 3.5;
    const int steps = 20000;
    double second = 0, third = 0;
    for (int k = 0; k < steps; ++k) {
      const double r = horizon * (k + 0.5) / steps, c = kernel->micromodulus(r, horizon) * horizon / steps;
      second += c * r * r, third += c * r * r * r;
    }
    EXPECT_NEAR(3 * std::numbers::pi / 8 * second, 1, 1e-8) << kernel->name();
    EXPECT_NEAR(std::numbers::pi * third / horizon, kernel->energy_number(), 1e-8) << kernel->name();
  }
}

TEST(FaceTemplate, every_kernel_has_its_own) {
  const LatticeTemplates &quartic = lattice_templates(3), &conical = lattice_templates(3, conical_kernel());
  EXPECT_EQ(&quartic, &lattice_templates(3, quartic_kernel()));
  EXPECT_EQ(&conical, &lattice_templates(3, conical_kernel()));
  ASSERT_NE(&quartic, &conical);
  EXPECT_LT(conical.residual, 1e-13);
  double ratio = 0, bulk = 0;
  for (std::size_t o = 0; o < quartic.family.size(); ++o) {
    const Vector2i step = quartic.family[o].step.cast<int>();
    const int across = std::abs(step.x()), away = step.y();
    ratio = std::max(ratio, std::abs(quartic.face.ratio(0, across, away) - conical.face.ratio(0, across, away)));
    bulk = std::max(bulk, std::abs(quartic.family[o].bulk_stiffness - conical.family[o].bulk_stiffness));
  }
  EXPECT_GT(ratio, 0.01);
  EXPECT_GT(bulk, 0.01);
}

}  // namespace
