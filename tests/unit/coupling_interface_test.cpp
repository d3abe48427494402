#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "coupling/interface_trace.hpp"
#include "geometry/boundary_mesh.hpp"

namespace {

using namespace bempd;

struct Interface {
  int length;      // in lattice spacings
  double element;  // wanted length of an element
  double grading;
};

std::vector<double> stations_of(const Interface& s) {
  std::vector<double> stations = element_stations(s.length, s.element, s.grading);
  for (double& station : stations) station *= s.length;
  return stations;
}

class InterfaceTrace : public testing::TestWithParam<Interface> {};

// Rows reproduce 1 and the coordinate; columns carry the integrals of the shape functions.
TEST_P(InterfaceTrace, is_consistent_for_displacements_and_for_forces) {
  const std::vector<double> stations = stations_of(GetParam());
  const auto trace = coupling::interface_trace(stations);
  ASSERT_TRUE(trace.has_value());
  const Eigen::MatrixXd n(*trace);
  const int elements = static_cast<int>(stations.size()) - 1, points = GetParam().length + 1;
  ASSERT_EQ(n.rows(), points);
  ASSERT_EQ(n.cols(), 2 * elements + 1);
  Eigen::VectorXd place(n.cols()), share = Eigen::VectorXd::Zero(n.cols()), lattice = Eigen::VectorXd::Ones(points);
  lattice[0] = lattice[points - 1] = 0.5;
  for (int e = 0; e < elements; ++e) {
    const double length = stations[e + 1] - stations[e];
    place[2 * e] = stations[e];
    place[2 * e + 1] = 0.5 * (stations[e] + stations[e + 1]);
    place[2 * e + 2] = stations[e + 1];
    share.segment<3>(2 * e) += length / 6 * Eigen::Vector3d(1, 4, 1);
  }
  const Eigen::VectorXd coordinate = Eigen::VectorXd::LinSpaced(points, 0, GetParam().length);
  EXPECT_LE((n.rowwise().sum() - Eigen::VectorXd::Ones(points)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE((n * place - coordinate).cwiseAbs().maxCoeff(), 1e-11 * GetParam().length);
  EXPECT_LE((n.transpose() * lattice - share).cwiseAbs().maxCoeff(), 1e-11);
  // The ends belong to both sides, and no weight is large.
  EXPECT_EQ(n(0, 0), 1);
  EXPECT_EQ(n(points - 1, n.cols() - 1), 1);
  EXPECT_LE(n.cwiseAbs().maxCoeff(), 1.5);
}

std::vector<Interface> interfaces() {
  std::vector<Interface> all;
  for (int length : {2, 3, 5, 20, 41, 200})
    for (double element : {0.3, 0.5, 1.0, 1.4, 2.0, 3.3, 7.3, 20.0, 200.0})
      for (double grading : {1.0, 1.1})
        if (grading == 1 || (element >= 1 && length <= 41)) all.push_back({length, element, grading});
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, InterfaceTrace, testing::ValuesIn(interfaces()), [](const auto& test) {
  return "spacings_" + std::to_string(test.param.length) + "_element_" +
         std::to_string(std::lround(10 * test.param.element)) + "_tenths" + (test.param.grading > 1 ? "_graded" : "");
});

// The change evens out the elements' own forces, 2/3 and 4/3 by turns, if every node is a lattice point.
TEST(InterfaceTraces, change_interpolation_by_little) {
  const Eigen::MatrixXd n(*coupling::interface_trace(stations_of({8, 2.0, 1.0})));
  EXPECT_LE((n - Eigen::MatrixXd::Identity(9, 9)).cwiseAbs().maxCoeff(), 0.3);
}

TEST(InterfaceTraces, one_spacing_is_too_short_for_a_mesh_of_its_own) {
  EXPECT_FALSE(coupling::interface_trace({0.0, 1.0}).has_value());
}

}  // namespace
