// Sizes of elements at mouths of cracks.
#include <gtest/gtest.h>

#include "bem/crack_grading.hpp"

namespace {

using namespace bempd;

// Elements at the mouth of a crack that leads away at 45 degrees, with the mouth off its place by rounding.
std::vector<double> stations_beside(double off) {
  const Point mouth(22, 1.5), tip(21.9, 1.4);
  const CrackLines cracks{{{1, {tip, mouth}, 0, {-1, 0}, {0}}}, {{mouth + Point(0, off), true}}};
  const std::vector<Edge> boundary{Edge(Point(22, 0), Point(22, 15)), Edge(Point(22, 15), Point(17, 15)),
                                   Edge(Point(17, 15), Point(17, 0)), Edge(Point(17, 0), Point(22, 0))};
  const bem::CrackSizes sizes(cracks, boundary, 1e-9);
  return sizes.refined(Arc{Point(22, 0), mouth}, {0, 1});
}

TEST(CrackGrading, rounding_of_a_mouth_makes_no_elements) {
  const std::vector<double> exact = stations_beside(0);
  EXPECT_GT(exact.size(), 2U);
  for (const double off : {-4e-16, 4e-16, -1e-14, 1e-14}) EXPECT_EQ(stations_beside(off), exact) << off;
}

}  // namespace
