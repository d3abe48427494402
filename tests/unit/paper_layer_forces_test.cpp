#include <gtest/gtest.h>

#include "paper/layer_forces.hpp"
#include "unit/pd_bodies.hpp"

namespace {

using namespace bempd;
using namespace bempd::pd;
using namespace bempd::pd::test;
using Eigen::Vector2i;

TEST(LayerForces, go_whole_to_the_points_of_the_cells_behind) {
  const CellLattice cells({rectangle(0, 0, 6, 4), hole(2, 1, 2, 2)});
  const CellLattice centres = CellLattice::centres_of(cells);
  const auto forces_of = [&](const Point& a, const Point& b) {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * centres.point_count());
    paper::add_layer_forces(
        centres, a, b, [](const Point& x) { return Point(3, x.x() + 10 * x.y()); }, forces);
    return forces;
  };
  const struct {
    Point a, b;
    std::vector<Vector2i> layer;
  } faces[] = {{{6, 0}, {6, 4}, {{5, 0}, {5, 1}, {5, 2}, {5, 3}}},
               {{0, 4}, {0, 2}, {{0, 2}, {0, 3}}},
               {{1, 0}, {3, 0}, {{1, 0}, {2, 0}}},
               {{2, 1}, {2, 3}, {{1, 1}, {1, 2}}},
               {{4, 3}, {4, 1}, {{4, 1}, {4, 2}}},
               {{2, 3}, {4, 3}, {{2, 3}, {3, 3}}}};
  for (const auto& face : faces) {
    Eigen::VectorXd forces = forces_of(face.a, face.b);
    for (const Vector2i& cell : face.layer) {
      const int i = centres.find_point(cell);
      // The middle of the edge of that cell, where a linear traction has its mean.
      Point middle = cell.cast<double>() + Point(0.5, 0.5);
      (face.a.x() == face.b.x() ? middle.x() : middle.y()) = face.a.x() == face.b.x() ? face.a.x() : face.a.y();
      EXPECT_NEAR(forces[2 * i], 3, 1e-14);
      EXPECT_NEAR(forces[2 * i + 1], middle.x() + 10 * middle.y(), 1e-12);
      forces.segment<2>(2 * i).setZero();
    }
    EXPECT_TRUE(forces.isZero(0));
  }
  EXPECT_NEAR(forces_of({6, 0.25}, {6, 1})[2 * centres.find_point({5, 0})], 0.75 * 3, 1e-14);
}

}  // namespace
