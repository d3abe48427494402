#include "pd/outlined/killing_tensors.hpp"

#include <algorithm>
#include <array>

namespace bempd::pd {

namespace {

// The ten cubic Killing tensors at a place, one in each column: symmetric products of three of the fields translation
// in x, translation in y and rotation. The rows are the components 111, 112, 122, 222; mixed components are added up.
Eigen::Matrix<double, 4, 10> products_at(const Point& x) {
  const std::array<Point, 3> fields{Point(1, 0), Point(0, 1), Point(-x.y(), x.x())};
  Eigen::Matrix<double, 4, 10> all;
  Eigen::Index column = 0;
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) {
      for (int c = b; c < 3; ++c, ++column) {
        const Point &u = fields[a], &v = fields[b], &w = fields[c];
        all.col(column) << u.x() * v.x() * w.x(), u.y() * v.x() * w.x() + u.x() * v.y() * w.x() + u.x() * v.x() * w.y(),
            u.x() * v.y() * w.y() + u.y() * v.x() * w.y() + u.y() * v.y() * w.x(), u.y() * v.y() * w.y();
      }
    }
  }
  return all;
}

}  // namespace

Eigen::MatrixXd killing_tensors(const std::vector<Point>& places) {
  Point centre = Point::Zero();
  for (const Point& p : places) centre += p / static_cast<double>(places.size());
  double size = 0;
  for (const Point& p : places) size = std::max(size, (p - centre).norm());
  Eigen::MatrixXd fields(4 * static_cast<Eigen::Index>(places.size()), 10);
  for (std::size_t k = 0; k < places.size(); ++k)
    fields.middleRows<4>(4 * static_cast<Eigen::Index>(k)) = products_at((places[k] - centre) / size);
  for (int pass = 0; pass < 2; ++pass) {
    for (Eigen::Index c = 0; c < fields.cols(); ++c) {
      const Eigen::VectorXd along = fields.leftCols(c).transpose() * fields.col(c);
      fields.col(c) -= fields.leftCols(c) * along;
      fields.col(c).normalize();
    }
  }
  return fields;
}

}  // namespace bempd::pd
