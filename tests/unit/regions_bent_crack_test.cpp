// The crack behind a tip that bends: the angle about the tip does not jump within the material, and displacements of
// faces come from the nodes that lie on their own side.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "regions/tips/bent_crack.hpp"

namespace regions_bent_crack_test {
namespace {

using namespace bempd;
using regions::BentCrack;

// A crack along the tip's line for a length of 2.3, then at an angle for one of 9.
std::vector<Point> path_at(double angle) {
  const Point corner(-2.3, 0);
  return {corner + 9 * Point(-std::cos(angle), -std::sin(angle)), corner, Point(0, 0)};
}

std::vector<Point> lattice(double from, double to) {
  std::vector<Point> nodes;
  for (double y = from; y <= to; y += 1)
    for (double x = -11.37; x < 11; x += 1) nodes.emplace_back(x, y);
  return nodes;
}

Point combined(const BentCrack::Part& part, const std::vector<Point>& nodes, const auto& displacement) {
  Point sum = Point::Zero();
  for (const auto& [node, share] : part.shares) sum += share * displacement(nodes[node]);
  return sum;
}

TEST(BentCrack, linear_displacements_of_each_side_are_those_of_its_face) {
  for (const double degrees : {-70., -30., -3., 12., 45., 80.}) {
    const double angle = degrees * std::numbers::pi / 180;
    BentCrack crack(path_at(angle), 5);
    const std::vector<Point> nodes = lattice(-10.81, 10);
    crack.divide(nodes, 1);
    const Point corner(-2.3, 0), away(-std::cos(angle), -std::sin(angle)), normal(-away.y(), away.x());
    double left = 0, right = 0;
    for (const BentCrack::Part& part : crack.parts()) {
      const double jump = part.is_left ? 1 : -1;
      const auto displacement = [&](const Point& place) {
        // Nodes ahead of the bend, which a part may see on either side, are left out of the jump.
        const double side = normal.dot(place - corner) < 0 ? 1 : -1;
        return Point(3 + 2 * place.x() - place.y() + side, side * (4 + place.x()) + place.y());
      };
      const bool is_far = away.dot(part.middle - corner) > 3;
      if (is_far) {
        const Point value = combined(part, nodes, displacement);
        EXPECT_NEAR(value.x(), 3 + 2 * part.middle.x() - part.middle.y() + jump, 1e-10) << degrees;
        EXPECT_NEAR(value.y(), jump * (4 + part.middle.x()) + part.middle.y(), 1e-10) << degrees;
      }
      (part.is_left ? left : right) += part.area.norm();
    }
    EXPECT_NEAR(left, 9, 1e-12);
    EXPECT_NEAR(right, 9, 1e-12);
  }
}

// A node or a row of nodes says nothing about the slope towards the face, which must not spoil a translation.
TEST(BentCrack, a_translation_of_few_nodes_is_that_of_the_face) {
  for (const int rows : {0, 1, 2}) {
    std::vector<Point> nodes = {{-5.2, -1.1}};
    for (double y = 1; y <= rows; y += 1)
      for (double x = -9; x < 0; x += 1) nodes.emplace_back(x, y);
    BentCrack crack(path_at(0.4), 5);
    crack.divide(nodes, 1);
    ASSERT_FALSE(crack.parts().empty());
    for (const BentCrack::Part& part : crack.parts()) {
      double sum = 0;
      for (const auto& [node, share] : part.shares) {
        sum += share;
        EXPECT_LT(std::abs(share), 10);
      }
      EXPECT_NEAR(sum, 1, 1e-12);
    }
  }
}

// The angle of a path around the tip from one face to the other grows by a full turn without a jump.
TEST(BentCrack, angles_do_not_jump_within_the_material) {
  for (const double degrees : {-80., -40., 5., 60., 85.}) {
    const double angle = degrees * std::numbers::pi / 180;
    const BentCrack crack(path_at(angle), 5);
    for (const double radius : {1., 2.5, 4., 6., 10.}) {
      // The circle meets the crack on the line of the tip or on the bent piece.
      const double b = 2.3 * std::cos(angle), c = 2.3 * 2.3 - radius * radius;
      const double along = -b + std::sqrt(b * b - c);
      const double start =
          radius <= 2.3 ? std::numbers::pi : std::atan2(-along * std::sin(angle), -2.3 - along * std::cos(angle));
      double last = 0, turned = 0;
      constexpr int count = 720;
      for (int k = 0; k < count; ++k) {
        const double at = start + (k + 0.5) * 2 * std::numbers::pi / count;
        const double found = crack.polar(radius * Point(std::cos(at), std::sin(at)), Point(0, 0)).angle;
        if (k > 0) {
          EXPECT_NEAR(found - last, 2 * std::numbers::pi / count, 1e-9) << degrees << " " << radius << " " << k;
          turned += found - last;
        }
        last = found;
      }
      EXPECT_NEAR(turned, 2 * std::numbers::pi * (count - 1) / count, 1e-9);
    }
  }
}

}  // namespace
}  // namespace regions_bent_crack_test
