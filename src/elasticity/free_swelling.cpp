#include "elasticity/free_swelling.hpp"

#include <Eigen/Dense>

#include "geometry/box_tree.hpp"

namespace bempd {

namespace {

// Deviation of the host's swelling from a linear field, over the largest strain, up to which it counts as a rounding
// error of the host's formulas.
constexpr double linearity_tolerance = 1e-10;

}  // namespace

std::optional<FreeSwelling> FreeSwelling::through(const std::vector<Point>& places, const Swelling& swelling) {
  Box box;
  for (const Point& place : places) box.extend(place);
  const Point centre = box.center();
  const double size = box.diagonal().norm();
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixX3d terms(count, 3);
  Eigen::MatrixX2d values(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Point arm = (places[static_cast<std::size_t>(i)] - centre) / size;
    terms.row(i) << 1, arm.x(), arm.y();
    values.row(i) = swelling(places[static_cast<std::size_t>(i)]).transpose();
  }
  // A uniform field gets its first value everywhere, so that it stays uniform to the last digit.
  Eigen::Matrix<double, 3, 2> found = Eigen::Matrix<double, 3, 2>::Zero();
  found.row(0) = values.row(0);
  if ((values.rowwise() - values.row(0)).cwiseAbs().maxCoeff() > 0) {
    found = (terms.transpose() * terms).ldlt().solve(terms.transpose() * values);
    const double largest = values.cwiseAbs().maxCoeff();
    if ((terms * found - values).cwiseAbs().maxCoeff() > linearity_tolerance * largest) return std::nullopt;
  }
  found.bottomRows<2>() /= size;
  return FreeSwelling(centre, found);
}

Eigen::Matrix2d FreeSwelling::displacement(const Point& place) const {
  const Point r = place - centre_;
  const double x = r.x(), y = r.y();
  Eigen::Matrix<double, 2, 3> shapes;
  shapes << x, 0.5 * (x * x - y * y), x * y, y, x * y, 0.5 * (y * y - x * x);
  return shapes * coefficients_;
}

}  // namespace bempd
