#include "williams.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "stress.hpp"

namespace directions {

Intensity fit_williams(const Body& body, const Window& window, const Point& tip, const Point& direction, double inner,
                       double outer) {
  constexpr double shear = 1.0 / 3, kappa = 2;
  constexpr int terms = 5;
  std::vector<int> chosen;
  for (const int point : window.points()) {
    const double r = (body.points[static_cast<std::size_t>(point)] - tip).norm();
    if (r >= inner && r <= outer) chosen.push_back(point);
  }
  Eigen::MatrixXd rows(2 * chosen.size(), 2 * terms + 3);
  Eigen::VectorXd values(2 * chosen.size());
  const Point side(-direction.y(), direction.x());
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const Point p = body.points[static_cast<std::size_t>(chosen[k])] - tip;
    const double x = direction.dot(p), y = side.dot(p), r = std::hypot(x, y), t = std::atan2(y, x);
    const long row = 2 * static_cast<long>(k);
    for (int n = 1; n <= terms; ++n) {
      const double h = n / 2.0, sign = n % 2 == 0 ? 1 : -1, scale = std::pow(r, h) / (2 * shear);
      rows(row, 2 * n - 2) = scale * ((kappa + h + sign) * std::cos(h * t) - h * std::cos((h - 2) * t));
      rows(row + 1, 2 * n - 2) = scale * ((kappa - h - sign) * std::sin(h * t) + h * std::sin((h - 2) * t));
      rows(row, 2 * n - 1) = -scale * ((kappa + h - sign) * std::sin(h * t) - h * std::sin((h - 2) * t));
      rows(row + 1, 2 * n - 1) = scale * ((kappa - h + sign) * std::cos(h * t) + h * std::cos((h - 2) * t));
    }
    rows.block<1, 3>(row, 2 * terms) << 1, 0, -y;
    rows.block<1, 3>(row + 1, 2 * terms) << 0, 1, x;
    const Point u = window.displacement(chosen[k]);
    values[row] = direction.dot(u);
    values[row + 1] = side.dot(u);
  }
  // The rotation of the second mode's second term is a rigid one as well: the least solution of all.
  const Eigen::VectorXd a = rows.completeOrthogonalDecomposition().solve(values);
  const double root = std::sqrt(2 * std::numbers::pi);
  return {a[0] * root, -a[1] * root};
}

Intensity fit_stresses(const Body& body, const Window& window, const MeanStress& stress, const Point& tip,
                       const Point& direction, double inner, double outer) {
  const Point side(-direction.y(), direction.x());
  std::vector<Eigen::Matrix<double, 3, 6>> rows;
  std::vector<Eigen::Vector3d> values;
  for (const int point : window.points()) {
    const Point p = body.points[static_cast<std::size_t>(point)] - tip;
    const double r = p.norm();
    if (r < inner || r > outer || p.dot(direction) < 0.4 * r) continue;
    const double t = std::atan2(side.dot(p), direction.dot(p)), weight = std::sqrt(r);
    Eigen::Matrix<double, 3, 6> row;
    for (int n = 1; n <= 3; ++n) {
      const double h = n / 2.0, sign = n % 2 == 0 ? 1 : -1, scale = weight * h * std::pow(r, h - 1);
      const double c1 = std::cos((h - 1) * t), c3 = std::cos((h - 3) * t), s1 = std::sin((h - 1) * t),
                   s3 = std::sin((h - 3) * t);
      row.col(2 * n - 2) << scale * ((2 + h + sign) * c1 - (h - 1) * c3), scale * ((2 - h - sign) * c1 + (h - 1) * c3),
          scale * ((h - 1) * s3 - (h + sign) * s1);
      row.col(2 * n - 1) << -scale * ((2 + h - sign) * s1 - (h - 1) * s3),
          -scale * ((2 - h + sign) * s1 + (h - 1) * s3), scale * ((h - 1) * c3 - (h - sign) * c1);
    }
    const Eigen::Vector3d& s = stress.at(point);
    const auto part = [&](const Point& a, const Point& b) {
      return a.x() * b.x() * s[0] + a.y() * b.y() * s[1] + (a.x() * b.y() + a.y() * b.x()) * s[2];
    };
    rows.push_back(row);
    values.push_back(weight * Eigen::Vector3d(part(direction, direction), part(side, side), part(direction, side)));
  }
  Eigen::MatrixXd matrix(3 * rows.size(), 6);
  Eigen::VectorXd right(3 * rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    matrix.middleRows<3>(3 * static_cast<long>(k)) = rows[k];
    right.segment<3>(3 * static_cast<long>(k)) = values[k];
  }
  const Eigen::VectorXd a = matrix.completeOrthogonalDecomposition().solve(right);
  const double root = std::sqrt(2 * std::numbers::pi);
  return {a[0] * root, -a[1] * root};
}

double hoop_angle(const Intensity& k) {
  if (std::abs(k.two) < 1e-12 * std::abs(k.one)) return 0;
  const double ratio = k.one / k.two;
  return 2 * std::atan((ratio - std::copysign(std::sqrt(ratio * ratio + 8), k.two)) / 4);
}

double hoop_intensity(const Intensity& k) {
  const double half = hoop_angle(k) / 2, c = std::cos(half);
  return c * (k.one * c * c - 1.5 * k.two * std::sin(2 * half));
}

}  // namespace directions
