#include "paper/uncorrected_network.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>

#include "cancellation.hpp"
#include "pd/cell_squares.hpp"
#include "pd/micromodulus.hpp"

namespace bempd::paper {

using namespace pd;

namespace {

using Face = std::array<Point, 2>;

constexpr double place_tolerance = 1e-9;

// Grid of square bins as wide as the horizon; all partners of a point lie in its own bin and the eight bins around it.
class Bins {
 public:
  Bins(const std::vector<Point>& points, double width) : width_(width) {
    if (points.empty()) return;
    Point low = points.front(), high = low;
    for (const Point& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    low_ = low;
    columns_ = static_cast<int>((high.x() - low.x()) / width) + 1;
    rows_ = static_cast<int>((high.y() - low.y()) / width) + 1;
    points_.resize(static_cast<std::size_t>(columns_) * rows_);
    faces_.resize(points_.size());
    for (std::size_t i = 0; i < points.size(); ++i) points_[bin_of(points[i])].push_back(static_cast<int>(i));
  }

  // Adds a face (piece of the body's boundary) to all bins whose points may have bonds that reach the face.
  void add(const Face& face, int number) {
    const Point reach(width_ + place_tolerance, width_ + place_tolerance);
    const Eigen::Array2i from = place(face[0].cwiseMin(face[1]) - reach).max(0);
    const Eigen::Array2i to = place(face[0].cwiseMax(face[1]) + reach).min(Eigen::Array2i(columns_ - 1, rows_ - 1));
    for (int y = from.y(); y <= to.y(); ++y)
      for (int x = from.x(); x <= to.x(); ++x) faces_[static_cast<std::size_t>(y) * columns_ + x].push_back(number);
  }

  const std::vector<int>& faces_near(const Point& p) const { return faces_[bin_of(p)]; }

  // Calls visit(j) for all points in the bin of `p` and the eight bins around it, in any order.
  template <class Visit>
  void for_points_near(const Point& p, const Visit& visit) const {
    const Eigen::Array2i at = place(p);
    for (int y = std::max(0, at.y() - 1); y <= std::min(rows_ - 1, at.y() + 1); ++y)
      for (int x = std::max(0, at.x() - 1); x <= std::min(columns_ - 1, at.x() + 1); ++x)
        for (const int j : points_[static_cast<std::size_t>(y) * columns_ + x]) visit(j);
  }

 private:
  Eigen::Array2i place(const Point& p) const { return ((p - low_) / width_).array().floor().cast<int>(); }
  std::size_t bin_of(const Point& p) const {
    const Eigen::Array2i at = place(p);
    return static_cast<std::size_t>(at.y()) * columns_ + at.x();
  }

  double width_;
  Point low_ = {0, 0};
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<int>> points_, faces_;
};

int sign(double value) { return value > place_tolerance ? 1 : value < -place_tolerance ? -1 : 0; }

// Whether a bond passes from one side of the body's boundary to the other. At a place where faces (pieces of the
// boundary) end on the bond, the bond crosses if two faces lead from the place to different sides of the bond.
// `candidates` are the numbers of the faces nearby.
bool crosses_boundary(const Point& from, const Point& to, const std::vector<Face>& faces,
                      const std::vector<int>& candidates) {
  const Point along = (to - from).normalized();
  const double length = (to - from).norm();
  std::vector<std::pair<double, int>> ends;  // places of face ends on the bond, and sides to which the faces lead
  for (const int f : candidates) {
    const Point &a = faces[f][0], &b = faces[f][1];
    const int a_side = sign(cross(along, a - from)), b_side = sign(cross(along, b - from));
    if (a_side == 0 && b_side != 0) ends.emplace_back(along.dot(a - from), b_side);
    if (b_side == 0 && a_side != 0) ends.emplace_back(along.dot(b - from), a_side);
    if (a_side * b_side >= 0) continue;
    const Point face = (b - a).normalized();
    if (sign(cross(face, from - a)) * sign(cross(face, to - a)) < 0) return true;
  }
  for (const auto& [place, side] : ends) {
    if (place <= place_tolerance || place >= length - place_tolerance) continue;
    for (const auto& [other_place, other_side] : ends)
      if (std::abs(other_place - place) <= place_tolerance && other_side == -side) return true;
  }
  return false;
}

// List of the different bond vectors; steps that differ only by rounding count as one.
class Offsets {
 public:
  explicit Offsets(double horizon) : horizon_(horizon) {}

  std::uint32_t find_or_add(const Point& step) {
    const std::pair<std::int64_t, std::int64_t> key(std::llround(step.x() / place_tolerance),
                                                    std::llround(step.y() / place_tolerance));
    const auto [it, added] = number_.try_emplace(key, static_cast<std::uint32_t>(offsets.size()));
    if (added) offsets.push_back(describe(step));
    return it->second;
  }

  std::vector<BondOffset> offsets;

 private:
  BondOffset describe(const Point& step) const {
    BondOffset offset;
    offset.step = step;
    offset.length = step.norm();
    offset.direction = step / offset.length;
    offset.bulk_stiffness =
        micromodulus(offset.length, horizon_) * volume_factor(offset.length, horizon_) / offset.length;
    const double x = offset.direction.x(), y = offset.direction.y();
    offset.moment = offset.length * Eigen::Vector4d(x * x * x, x * x * y, x * y * y, y * y * y);
    return offset;
  }

  double horizon_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> number_;
};

}  // namespace

Network build_uncorrected_network(const std::vector<Point>& points, const std::vector<double>& volumes,
                                  const std::vector<Face>& faces, int horizon_ratio,
                                  const PlaneElasticity& elasticity) {
  assert(horizon_ratio >= 1 && volumes.size() == points.size());
  assert(is_bond_based(elasticity));
  const double horizon = horizon_ratio, unit = elasticity.thickness * elasticity.c11();
  Bins bins(points, horizon);
  for (std::size_t f = 0; f < faces.size(); ++f) bins.add(faces[f], static_cast<int>(f));
  Network network;
  Offsets offsets(horizon);
  std::vector<int> partners;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    check_cancelled();
    partners.clear();
    const std::vector<int>& near_faces = bins.faces_near(points[i]);
    bins.for_points_near(points[i], [&](int j) {
      if (j <= i || (points[j] - points[i]).squaredNorm() >= horizon * horizon - place_tolerance) return;
      if (near_faces.empty() || !crosses_boundary(points[i], points[j], faces, near_faces)) partners.push_back(j);
    });
    std::sort(partners.begin(), partners.end());
    for (const int j : partners) {
      const std::uint32_t o = offsets.find_or_add(points[j] - points[i]);
      network.offset_of.push_back(o);
      network.bonds.push_back({i, j, unit * offsets.offsets[o].bulk_stiffness * volumes[i] * volumes[j]});
    }
  }
  network.offsets = std::move(offsets.offsets);
  return network;
}

}  // namespace bempd::paper
