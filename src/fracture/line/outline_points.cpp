#include "fracture/line/outline_points.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fracture/line/deep_points.hpp"
#include "fracture/line/point_moments.hpp"
#include "fracture/line/whole_stiffness.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

namespace {

// Least ratio, for points on the outline, of the vector sum of the forces of a point's bonds to the sum of the
// magnitudes of these forces, if all bonds are stretched by the same share of their length.
constexpr double outline_pull = 0.1;

// Least ratio of the smallest to the largest eigenvalue of the matrix S of a point (find_stresses()). With a larger
// ratio the point's bonds determine all components of the stress.
constexpr double least_resistance = 1e-3;

// Relative difference between the matrix S of a point (find_stresses()) and that of a point deep inside, up to which
// the point counts as lying inside.
constexpr double alike_inside = 1e-6;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool are_of_a_kind(const pd::TipLaws& laws, int one, int other) {
  const int first = laws.of_node[static_cast<std::size_t>(one)], second = laws.of_node[static_cast<std::size_t>(other)];
  if (first < 0 || second < 0) return first == second;
  return are_alike(laws.laws[static_cast<std::size_t>(first)], laws.laws[static_cast<std::size_t>(second)]);
}

// Typical matrix of some points inside a lattice: the median of every entry, because edges change the matrices of some
// of these points.
Eigen::Matrix3d typical(const std::vector<Eigen::Matrix3d>& of_node, const std::vector<int>& points) {
  Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
  std::vector<double> values(points.size());
  for (int row = 0; row < 3 && !points.empty(); ++row)
    for (int column = 0; column < 3; ++column) {
      for (std::size_t k = 0; k < points.size(); ++k)
        values[k] = of_node[static_cast<std::size_t>(points[k])](row, column);
      result(row, column) = median_of(values);
    }
  return result;
}

}  // namespace

OutlinePoints::OutlinePoints(const coupling::Terms& terms, const std::vector<Point>& positions, const pd::TipLaws& laws)
    : share_(positions.size(), 0) {
  const std::vector<double> stiffness = whole_stiffness(terms, laws.weakened);
  find_shares(terms, laws, stiffness);
  find_stresses(terms, positions, laws, stiffness);
}

// Finds points on the outline by their bonds. If all bonds are stretched alike, their forces on such a point add up to
// a force inwards, while the forces on an inner point balance. Weakened bonds count with their whole stiffness, because
// the end of a crack is no outline.
void OutlinePoints::find_shares(const coupling::Terms& terms, const pd::TipLaws& laws,
                                const std::vector<double>& stiffness) {
  std::vector<Point> pull(share_.size(), Point(0, 0));
  std::vector<double> sum(share_.size(), 0);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (terms.is_wide(t)) continue;
    const double size = stiffness[t] * terms.length[t];
    const Point along = size * Point(terms.cosine[t], terms.sine[t]);
    const auto first = static_cast<std::size_t>(terms.first[t]), second = static_cast<std::size_t>(terms.second[t]);
    pull[first] += along, pull[second] -= along;
    sum[first] += size, sum[second] += size;
  }
  for (std::size_t node = 0; node < share_.size(); ++node) {
    if (!(pull[node].norm() > outline_pull * sum[node])) continue;
    const double known = node < laws.share_of_node.size() ? laws.share_of_node[node] : 0;
    share_[node] = known > 0 ? known : 0.5;
  }
}

// Finds the matrices of stress_of_moments(). Under a uniform strain E = (E_xx, E_yy, 2 E_xy), a term (bond or cell
// square) with the stiffness k, n points and the moment m (xx, yy, xy), equal at all its points, has the tension k n
// m.E. So the moments times tensions of a point's terms add up to S E with S = sum of k n m m^T. The stress is S0 E /
// volume, with the S0 and the volume of a point deep inside the lattice. So the wanted matrix is S0 / volume times the
// inverse of S.
void OutlinePoints::find_stresses(const coupling::Terms& terms, const std::vector<Point>& positions,
                                  const pd::TipLaws& laws, const std::vector<double>& stiffness) {
  std::vector<Eigen::Matrix3d> sums(share_.size(), Eigen::Matrix3d::Zero());
  std::vector<char> is_mixed(share_.size(), 0);  // 1: the point has terms to another kind of lattice
  for (std::size_t t = 0; t < terms.size(); ++t) {
    int nodes = 0;
    bool joins = false;
    terms.for_each_node(t, [&](int node) { ++nodes, joins = joins || !are_of_a_kind(laws, terms.first[t], node); });
    if (joins) terms.for_each_node(t, [&](int node) { is_mixed[static_cast<std::size_t>(node)] = 1; });
    terms.for_each_node(t, [&](int node) {
      const Eigen::Vector3d moment = moment_at(terms, positions, t, node, {1, 0});
      sums[static_cast<std::size_t>(node)] += stiffness[t] * nodes * moment * moment.transpose();
    });
  }
  std::vector<Eigen::Matrix3d> full;
  const std::vector<std::vector<int>> deep = deep_points(terms, laws);
  for (std::size_t law = 0; law < deep.size(); ++law) {
    const pd::TipLaw& its = laws.laws[law];
    full.push_back(typical(sums, deep[law]) / its.point_volume());
  }
  for (std::size_t n = 0; n < laws.of_node.size(); ++n) {
    const int law = laws.of_node[n];
    if (law < 0 || is_mixed[n] || deep[static_cast<std::size_t>(law)].empty()) continue;
    const Eigen::Matrix3d& whole = full[static_cast<std::size_t>(law)];
    const Eigen::Matrix3d as_inside = whole * laws.laws[static_cast<std::size_t>(law)].point_volume();
    if (share_[n] == 0 && (sums[n] - as_inside).norm() < alike_inside * as_inside.norm()) continue;
    const Eigen::Vector3d resistance = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sums[n]).eigenvalues();
    if (!(resistance[0] > least_resistance * resistance[2])) continue;
    // The determinant of small moments is below the range of numbers, so the matrix is scaled; a power of two changes
    // no digit.
    const double scale = std::ldexp(1.0, -std::ilogb(resistance[2]));
    stress_of_moments_[static_cast<int>(n)] = whole * (scale * sums[n]).inverse() * scale;
  }
}

}  // namespace bempd::fracture
