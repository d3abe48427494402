#include "pd/face_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace bempd::pd {

namespace {

// Largest distance of a point from the rows of a lattice at which the point counts as on the rows [spacings].
constexpr double row_tolerance = 1e-6;

// Distance from a crack below which a point lies on neither side of the crack [spacings].
constexpr double side_tolerance = 1e-9;

// Distances from a crack at which displacements may be interpolated on one side [spacings]: the smallest, which is
// tried first, the step to the next one, and the largest.
constexpr double nearest_distance = 0.5, distance_step = 0.1, farthest_distance = 1.6;

constexpr double negligible_weight = 1e-9;

// Tolerance within which the end of a piece of a crack lies on a column (or row) of the lattice [spacings].
constexpr double column_tolerance = 1e-9;

Eigen::Vector2i rounded(const Point& p) { return p.array().round().cast<int>().matrix(); }

bool row_before(const Eigen::Vector2i& a, const Eigen::Vector2i& b) {
  return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
}

bool is_on_rows(const Point& p) { return (p - rounded(p).cast<double>()).cwiseAbs().maxCoeff() < row_tolerance; }

}  // namespace

Point FacePlaces::Lattice::to_rows(const Point& p) const {
  return Eigen::Rotation2Dd(-lattice.angle) * Point((p - lattice.origin) / lattice.spacing);
}

Point FacePlaces::Lattice::from_rows(const Point& p) const {
  return lattice.origin + lattice.spacing * (Eigen::Rotation2Dd(lattice.angle) * p);
}

// Whether another lattice has the same rows, columns and stiffness, so that both form one network where they touch.
bool FacePlaces::Lattice::continues(const FaceLattice& other, double its_stiffness) const {
  return other.angle == lattice.angle && std::abs(other.spacing - lattice.spacing) < row_tolerance * lattice.spacing &&
         its_stiffness == stiffness && is_on_rows(to_rows(other.origin));
}

std::optional<int> FacePlaces::Lattice::node_at(const Eigen::Vector2i& at) const {
  const auto found = std::lower_bound(points.begin(), points.end(), at,
                                      [](const Numbered& p, const Eigen::Vector2i& q) { return row_before(p.at, q); });
  return found != points.end() && found->at == at ? std::optional(found->node) : std::nullopt;
}

FacePlaces::FacePlaces(const std::vector<Point>& positions, const std::vector<Body>& bodies)
    : positions_(positions), lattice_at_(positions.size(), -1) {
  for (const Body& body : bodies) {
    auto one = std::find_if(lattices_.begin(), lattices_.end(),
                            [&](const Lattice& known) { return known.continues(body.lattice, body.stiffness); });
    if (one == lattices_.end()) one = lattices_.insert(one, {body.lattice, body.stiffness, {}});
    for (const int node : body.nodes) {
      const Point p = one->to_rows(positions[static_cast<std::size_t>(node)]);
      if (!is_on_rows(p)) continue;
      one->points.push_back({rounded(p), node});
      lattice_at_[static_cast<std::size_t>(node)] = static_cast<int>(one - lattices_.begin());
    }
  }
  const auto before = [](const Numbered& a, const Numbered& b) { return row_before(a.at, b.at); };
  for (Lattice& one : lattices_) {
    if (!std::is_sorted(one.points.begin(), one.points.end(), before))
      std::stable_sort(one.points.begin(), one.points.end(), before);
  }
}

std::optional<int> FacePlaces::lattice_of_neighbours(int node, int other) const {
  for (const int end : {node, other}) {
    const int number = lattice_at_[static_cast<std::size_t>(end)];
    if (number < 0) continue;
    const Lattice& one = lattices_[static_cast<std::size_t>(number)];
    const Point a = one.to_rows(positions_[static_cast<std::size_t>(node)]);
    const Point b = one.to_rows(positions_[static_cast<std::size_t>(other)]);
    if (is_on_rows(a) && is_on_rows(b) && (rounded(b) - rounded(a)).cwiseAbs().sum() == 1) return number;
  }
  return std::nullopt;
}

std::optional<double> FacePlaces::add_side(const Lattice& lattice, const Point& place, const Point& normal, double sign,
                                           const Reaches& reaches, std::vector<FacePlace::Pull>& pulls) const {
  const Point at = lattice.to_rows(place), along = Eigen::Rotation2Dd(-lattice.lattice.angle) * normal;
  for (int step = 0;; ++step) {
    const double distance = nearest_distance + step * distance_step;
    if (distance > farthest_distance) return std::nullopt;
    const Point p = at + sign * distance * along, corner = p.array().floor().matrix();
    const double x = p.x() - corner.x(), y = p.y() - corner.y();
    const std::array<double, 4> weights{(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
    std::vector<FacePlace::Pull> found;
    bool sound = true;
    for (int k = 0; k < 4 && sound; ++k) {
      if (weights[k] < negligible_weight) continue;
      const Eigen::Vector2i q = rounded(corner) + Eigen::Vector2i(k % 2, k / 2);
      const std::optional<int> node = lattice.node_at(q);
      sound = node && sign * along.dot(q.cast<double>() - at) > side_tolerance && (!reaches || reaches(*node, place));
      if (sound) found.push_back({*node, sign * weights[k] * normal});
    }
    if (!sound) continue;
    pulls.insert(pulls.end(), found.begin(), found.end());
    return distance;
  }
}

std::optional<FacePlace> FacePlaces::at(int lattice, const Point& place, const Point& normal, double length,
                                        const Reaches& reaches) const {
  const Lattice& one = lattices_[static_cast<std::size_t>(lattice)];
  FacePlace found;
  const std::optional<double> above = add_side(one, place, normal, 1, reaches, found.pulls);
  if (!above) return std::nullopt;
  const std::optional<double> below = add_side(one, place, normal, -1, reaches, found.pulls);
  if (!below) return std::nullopt;
  found.stiffness = one.stiffness * length / (*above + *below);
  return found;
}

std::vector<FacePlaces::Crossing> FacePlaces::crossings(int lattice, const Point& start, const Point& end) const {
  const Lattice& one = lattices_[static_cast<std::size_t>(lattice)];
  const Point from = one.to_rows(start), way = one.to_rows(end) - from;
  const int axis = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
  const double low = std::min(from[axis], from[axis] + way[axis]), high = std::max(from[axis], from[axis] + way[axis]);
  const double whole = way.norm() / std::abs(way[axis]);
  std::vector<Crossing> found;
  for (double line = std::ceil(low - column_tolerance); line <= high + column_tolerance; ++line) {
    const bool is_end = line - low <= column_tolerance || high - line <= column_tolerance;
    const double fraction = std::clamp((line - from[axis]) / way[axis], 0.0, 1.0);
    found.push_back({one.from_rows(from + fraction * way), is_end ? 0.5 * whole : whole});
  }
  return found;
}

}  // namespace bempd::pd
