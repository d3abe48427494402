#include "points.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>
#include <unordered_map>

namespace directions {
namespace {

// Points in square buckets, for neighbours.
class Buckets {
 public:
  Buckets(const std::vector<Point>& points, double size) : points_(points), size_(size) {
    for (std::size_t k = 0; k < points.size(); ++k)
      cells_[key(cell(points[k].x()), cell(points[k].y()))].push_back(static_cast<int>(k));
  }

  template <class Visit>
  void near(const Point& p, Visit visit) const {
    for (long i = cell(p.x()) - 1; i <= cell(p.x()) + 1; ++i)
      for (long j = cell(p.y()) - 1; j <= cell(p.y()) + 1; ++j)
        if (const auto found = cells_.find(key(i, j)); found != cells_.end())
          for (const int k : found->second) visit(k);
  }

 private:
  long cell(double x) const { return static_cast<long>(std::floor(x / size_)); }
  static long key(long i, long j) { return i * 1000003 + j; }

  const std::vector<Point>& points_;
  double size_;
  std::unordered_map<long, std::vector<int>> cells_;
};

void relax(std::vector<Point>& points, const Point& low, const Point& high) {
  const Buckets buckets(points, 3.0);
  std::vector<Point> sum(points.size(), Point::Zero());
  std::vector<int> count(points.size(), 0);
  constexpr double step = 0.2;
  for (double x = low.x() + step / 2; x < high.x(); x += step)
    for (double y = low.y() + step / 2; y < high.y(); y += step) {
      const Point p(x, y);
      int nearest = -1;
      double best = 1e9;
      buckets.near(p, [&](int k) {
        const double d = (points[static_cast<std::size_t>(k)] - p).squaredNorm();
        if (d < best) best = d, nearest = k;
      });
      if (nearest >= 0) sum[static_cast<std::size_t>(nearest)] += p, ++count[static_cast<std::size_t>(nearest)];
    }
  for (std::size_t k = 0; k < points.size(); ++k)
    if (count[k] > 0) points[k] = sum[k] / count[k];
}

double kernel(const std::string& name, double ratio) {
  if (name == "conical") return 1 - ratio;
  if (name == "gauss") return std::exp(-4 * ratio * ratio);
  if (name == "constant") return 1;
  return (1 - ratio * ratio) * (1 - ratio * ratio);
}

// Share of a point's area that lies within the horizon of another.
double share(double length, double horizon) {
  return length <= horizon - 0.5 ? 1 : std::max(0.02, horizon + 0.5 - length);
}

// Stiffnesses times length over the half family, changed as little as possible to give exact constants.
void calibrate(std::vector<Bond>& family) {
  Eigen::MatrixXd rows(3, family.size());
  Eigen::VectorXd weights(family.size());
  for (std::size_t k = 0; k < family.size(); ++k) {
    const Point e = family[k].direction;
    const double r = family[k].length;
    rows.col(static_cast<long>(k)) << r * std::pow(e.x(), 4), r * std::pow(e.y(), 4), r * std::pow(e.x() * e.y(), 2);
    weights[static_cast<long>(k)] = family[k].stiffness * r;
  }
  weights *= 8.0 / 3 / (rows.row(0) + rows.row(1) + 2 * rows.row(2)).dot(weights);
  const Eigen::Vector3d target(1, 1, 1.0 / 3);
  const Eigen::MatrixXd scaled = weights.asDiagonal() * rows.transpose();
  weights += scaled * (rows * scaled).ldlt().solve(target - rows * weights);
  for (std::size_t k = 0; k < family.size(); ++k)
    family[k].stiffness = weights[static_cast<long>(k)] / family[k].length;
}

void balance(std::vector<Bond>& bonds, std::size_t points) {
  for (int round = 0; round < 30; ++round) {
    std::vector<double> sum(points, 0);
    for (const Bond& bond : bonds)
      for (const int end : {bond.first, bond.second})
        sum[static_cast<std::size_t>(end)] += bond.stiffness * bond.length * bond.length / 2;
    for (Bond& bond : bonds) {
      const double a = sum[static_cast<std::size_t>(bond.first)], b = sum[static_cast<std::size_t>(bond.second)];
      bond.stiffness *= std::sqrt(std::sqrt((8.0 / 3 / a) * (8.0 / 3 / b)));
    }
  }
}

}  // namespace

std::vector<Point> make_points(const Layout& layout, const Point& centre, const Point& half) {
  std::mt19937 random(layout.seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Point origin(uniform(random), uniform(random));
  std::vector<Point> points;
  const Point low = centre - half, high = centre + half;
  if (layout.relaxation >= 0) {
    const int count = static_cast<int>(4 * half.x() * half.y());
    for (int k = 0; k < count; ++k)
      points.emplace_back(low.x() + 2 * half.x() * uniform(random), low.y() + 2 * half.y() * uniform(random));
    for (int step = 0; step < layout.relaxation; ++step) relax(points, low, high);
    return points;
  }
  const double turn = layout.angle * std::numbers::pi / 180;
  const int reach = static_cast<int>(half.norm()) + 2;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      const Point q = Point(i, j) + origin + layout.jitter * Point(2 * uniform(random) - 1, 2 * uniform(random) - 1);
      const Point p = centre + Point(std::cos(turn) * q.x() - std::sin(turn) * q.y(),
                                     std::sin(turn) * q.x() + std::cos(turn) * q.y());
      if (std::abs(p.x() - centre.x()) < half.x() && std::abs(p.y() - centre.y()) < half.y()) points.push_back(p);
    }
  return points;
}

namespace {

std::vector<Bond> neighbours(const std::vector<Point>& points, double horizon) {
  const Buckets buckets(points, horizon);
  std::vector<Bond> bonds;
  for (std::size_t i = 0; i < points.size(); ++i)
    buckets.near(points[i], [&](int j) {
      const Point step = points[static_cast<std::size_t>(j)] - points[i];
      const double length = step.norm();
      if (j > static_cast<int>(i) && length < horizon - 1e-9)
        bonds.push_back({static_cast<int>(i), j, 0, length, step / length});
    });
  return bonds;
}

std::vector<Bond> lattice_bonds(const Layout& layout, const std::vector<Point>& points) {
  const double turn = layout.angle * std::numbers::pi / 180;
  std::vector<Bond> family;
  const int m = layout.horizon;
  for (int b = 0; b < m; ++b)
    for (int a = -m; a < m; ++a)
      if ((b > 0 || a > 0) && a * a + b * b < m * m) {
        const double r = std::hypot(a, b);
        family.push_back({a, b, kernel(layout.kernel, r / m) * std::min(1.0, m + 0.5 - r) / r, r, Point(a, b) / r});
      }
  calibrate(family);
  std::vector<Bond> bonds = neighbours(points, m);
  for (Bond& bond : bonds) {
    const Point e = bond.length * bond.direction;
    int a = static_cast<int>(std::lround(std::cos(turn) * e.x() + std::sin(turn) * e.y()));
    int b = static_cast<int>(std::lround(-std::sin(turn) * e.x() + std::cos(turn) * e.y()));
    if (b < 0 || (b == 0 && a < 0)) a = -a, b = -b;
    for (const Bond& member : family)
      if (member.first == a && member.second == b) bond.stiffness = member.stiffness;
  }
  return bonds;
}

}  // namespace

std::vector<Bond> make_bonds(const Layout& layout, const std::vector<Point>& points) {
  if (layout.relaxation < 0 && layout.jitter == 0) return lattice_bonds(layout, points);
  std::vector<Bond> bonds = neighbours(points, layout.horizon);
  for (Bond& bond : bonds)
    bond.stiffness =
        kernel(layout.kernel, bond.length / layout.horizon) * share(bond.length, layout.horizon) / bond.length;
  balance(bonds, points.size());
  return bonds;
}

double mean_critical_stretch(const std::vector<Bond>& bonds, double area) {
  double sum = 0;
  for (const Bond& bond : bonds) sum += bond.stiffness * std::pow(bond.length, 3) / 2;
  return std::sqrt(area / (sum * 2 / std::numbers::pi));
}

}  // namespace directions
