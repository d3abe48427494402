// How the energy release rate varies over the first spacings of a kink, against an integration.
#include <gtest/gtest.h>

#include <cmath>

#include "fracture/line/williams_fit.hpp"

namespace fracture_kink_shape_test {
namespace {

using namespace bempd;
using fracture::AffineIntensity;
using fracture::KinkShape;

// A tip that turns by 0.3 under both modes and a stress along the crack; at rest it carries a part of them.
KinkShape kink(double scale) {
  AffineIntensity factors;
  factors.one = scale * Eigen::RowVector2d(0.2, 0.8);
  factors.two = scale * Eigen::RowVector2d(0.05, -0.3);
  return {factors, scale * Eigen::RowVector2d(0.02, 0.1), 0.3};
}

TEST(KinkShape, mean_is_that_of_the_values_along_the_kink) {
  const KinkShape shape = kink(1);
  for (const double length : {0.3, 1.0, 1.7}) {
    double sum = 0;
    constexpr int parts = 1000;
    for (int k = 0; k < parts; ++k) sum += shape.at((k + 0.5) * length / parts, 1.3) / parts;
    EXPECT_NEAR(shape.mean(length, 1.3), sum, 1e-4) << length;
    EXPECT_GT(std::abs(sum - 1), 0.005) << "nothing varies";
  }
  EXPECT_DOUBLE_EQ(shape.at(0, 1.3), 1);
}

TEST(KinkShape, is_the_same_in_all_units) {
  for (const double scale : {1e-9, 1e-3, 1e8}) {
    EXPECT_NEAR(kink(scale).mean(0.7, 2), kink(1).mean(0.7, 2), 1e-12) << scale;
    EXPECT_NEAR(kink(scale).at(0.7, 2), kink(1).at(0.7, 2), 1e-12) << scale;
  }
}

TEST(KinkShape, of_an_unloaded_or_unknown_tip_is_constant) {
  EXPECT_EQ(KinkShape().mean(0.7, 2), 1);
  EXPECT_EQ(KinkShape().at(0.7, 2), 1);
}

}  // namespace
}  // namespace fracture_kink_shape_test
