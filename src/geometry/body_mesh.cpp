#include "geometry/body_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/delaunay.hpp"
#include "geometry/outline.hpp"

namespace bempd {

namespace {

constexpr double largest_turn = std::numbers::pi / 18;  // largest angle by which the outline turns along one side [rad]

double turning_of(const Edge& edge) {
  double sum = 0;
  for (int k = 0; k < edge.piece_count(); ++k) sum += std::abs(edge.piece(k).sweep);
  return sum;
}

// Fractions of an edge at which sides of triangles end: those of the `places` on the edge, and as many between them as
// the size requires.
std::vector<double> side_ends(const Edge& edge, const std::vector<Point>& places, double size, double tolerance) {
  std::vector<double> fixed{0, 1};
  for (const Point& place : places)
    if (distance(edge, place) <= tolerance) fixed.push_back(closest_fraction(edge, place));
  std::sort(fixed.begin(), fixed.end());
  const double wanted = std::max(edge.length() / size, turning_of(edge) / largest_turn);
  std::vector<double> all;
  for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
    const double part = fixed[k + 1] - fixed[k];
    const int count = std::max(1, static_cast<int>(std::ceil(wanted * part - 1e-6)));
    for (int i = 0; i < count; ++i) all.push_back(fixed[k] + part * i / count);
  }
  all.push_back(1);
  return all;
}

Point centre_of_circle(const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a, ac = c - a;
  const double ab2 = ab.squaredNorm(), ac2 = ac.squaredNorm();
  const Point across(ac.y() * ab2 - ab.y() * ac2, ab.x() * ac2 - ac.x() * ab2);
  return a + across / (2 * cross(ab, ac));
}

// Mesh by Ruppert's refinement (J. Algorithms 18, 1995). Circles that have a side as diameter are kept free of points,
// so that the sides are sides of triangles. The circumcentres of triangles that are too large or too thin are added as
// points.
class BodyMesher {
 public:
  BodyMesher(const std::vector<Edge>& boundary, double size)
      : boundary_(boundary), size_(size), box_(box_of(boundary)), delaunay_(box_) {}

  void add_boundary(const std::vector<Point>& mouths) {
    for (const Edge& edge : boundary_) add_line(edge, &edge, mouths);
  }
  void add_crack(const Edge& piece) { add_line(piece, nullptr, {}); }
  void refine();
  BodyMesh result() const;

 private:
  struct Side {
    int from, to;
    const Edge* edge;  // null: side of a crack
  };

  static Box box_of(const std::vector<Edge>& edges) {
    Box box;
    for (const Edge& edge : edges) box.extend(bounding_box(edge));
    return box;
  }
  const Point& point(int k) const { return points_[static_cast<std::size_t>(k)]; }
  double length(const Side& side) const { return (point(side.to) - point(side.from)).norm(); }
  int insert(const Point& p);
  void add_line(const Edge& line, const Edge* edge, const std::vector<Point>& places);
  bool inside(const Point& p) const;
  bool in_circle_over(const Side& side, const Point& p) const;
  bool has_points_in_circle(const Side& side) const;
  bool split(std::size_t side);
  void split_crowded();
  bool split_crowded_by(const Point& place);
  std::optional<Point> missing_in(const Delaunay::Triangle& triangle) const;

  const std::vector<Edge>& boundary_;
  double size_;
  Box box_;
  Delaunay delaunay_;
  std::vector<Point> points_;
  std::vector<Side> sides_;
  double smallest_ = 0;  // length of the shortest side allowed
  std::vector<int> waiting_;
};

int BodyMesher::insert(const Point& p) {
  const int number = delaunay_.insert(p);
  if (number == static_cast<int>(points_.size())) points_.push_back(p);
  waiting_.insert(waiting_.end(), delaunay_.fresh().begin(), delaunay_.fresh().end());
  return number;
}

void BodyMesher::add_line(const Edge& line, const Edge* edge, const std::vector<Point>& places) {
  int before = -1;
  for (const double fraction : side_ends(line, places, size_, 10 * geometric_tolerance(box_))) {
    const int at = insert(line.at(fraction));
    if (before >= 0 && at != before) sides_.push_back({before, at, edge});
    before = at;
  }
}

bool BodyMesher::inside(const Point& p) const {
  bool odd = false;
  for (const Side& side : sides_) {
    const Point &a = point(side.from), &b = point(side.to);
    if (!side.edge || (a.y() > p.y()) == (b.y() > p.y())) continue;
    odd ^= a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x();
  }
  return odd;
}

bool BodyMesher::in_circle_over(const Side& side, const Point& p) const {
  const Point a = point(side.from) - p, b = point(side.to) - p;
  return a.dot(b) < -1e-12 * (a - b).squaredNorm();
}

bool BodyMesher::has_points_in_circle(const Side& side) const {
  return std::any_of(points_.begin(), points_.end(), [&](const Point& p) { return in_circle_over(side, p); });
}

// Splits a side at its middle, which is moved onto the true outline; false if the halves would be too short.
bool BodyMesher::split(std::size_t number) {
  const Side side = sides_[number];
  if (length(side) < 2 * smallest_) return false;
  Point middle = 0.5 * (point(side.from) + point(side.to));
  if (side.edge && !side.edge->straight()) middle = side.edge->at(closest_fraction(*side.edge, middle));
  const int at = insert(middle);
  if (at == side.from || at == side.to) return false;
  sides_[number] = {side.from, at, side.edge};
  sides_.push_back({at, side.to, side.edge});
  split_crowded_by(point(at));
  for (const std::size_t half : {number, sides_.size() - 1})
    if (has_points_in_circle(sides_[half])) split(half);
  return true;
}

void BodyMesher::split_crowded() {
  for (std::size_t k = 0; k < sides_.size(); ++k)
    if (has_points_in_circle(sides_[k])) split(k);
}

bool BodyMesher::split_crowded_by(const Point& place) {
  // The place is copied, because it may refer to a point of `points_`, which splitting moves in memory.
  const Point p = place;
  bool any = false;
  for (std::size_t k = 0, count = sides_.size(); k < count; ++k)
    if (in_circle_over(sides_[k], p)) any = split(k) || any;
  return any;
}

// Circumcentre of a triangle of the body that is too large or too thin, to be added as a point; empty if the triangle
// is good.
std::optional<Point> BodyMesher::missing_in(const Delaunay::Triangle& triangle) const {
  if (!triangle.exists || *std::min_element(triangle.points.begin(), triangle.points.end()) < 0) return std::nullopt;
  const Point &a = point(triangle.points[0]), &b = point(triangle.points[1]), &c = point(triangle.points[2]);
  if (cross(b - a, c - a) < 1e-9 * size_ * size_) return std::nullopt;
  const double shortest = std::min({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  const Point centre = centre_of_circle(a, b, c);
  const double radius = (centre - a).norm();
  constexpr double widest = 0.75, thinnest = 1.5;  // limits on radius / size, radius / shortest side
  const bool good = radius < widest * size_ && (radius < thinnest * shortest || shortest < smallest_);
  if (good || !inside((a + b + c) / 3)) return std::nullopt;
  return centre;
}

void BodyMesher::refine() {
  smallest_ = 0.2 * size_;
  for (const Side& side : sides_) smallest_ = std::min(smallest_, 0.4 * length(side));
  const std::size_t most = 20 * points_.size() + 4000;
  split_crowded();
  while (!waiting_.empty() && points_.size() < most) {
    const int number = waiting_.back();
    waiting_.pop_back();
    const Delaunay::Triangle triangle = delaunay_.triangles()[static_cast<std::size_t>(number)];
    const std::optional<Point> centre = missing_in(triangle);
    if (!centre) continue;
    bool crowded = false;
    for (const Side& side : sides_) crowded = crowded || in_circle_over(side, *centre);
    if (crowded) {
      if (split_crowded_by(*centre)) waiting_.push_back(number);
    } else if (inside(*centre)) {
      insert(*centre);
    }
  }
}

BodyMesh BodyMesher::result() const {
  BodyMesh mesh;
  mesh.points = points_;
  for (const Delaunay::Triangle& triangle : delaunay_.triangles()) {
    if (!triangle.exists || *std::min_element(triangle.points.begin(), triangle.points.end()) < 0) continue;
    const Point &a = point(triangle.points[0]), &b = point(triangle.points[1]), &c = point(triangle.points[2]);
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    // Flat triangles are left out. They lie between an edge and points on the edge whose places were rounded.
    if (cross(b - a, c - a) > 1e-6 * longest && inside((a + b + c) / 3)) mesh.triangles.push_back(triangle.points);
  }
  for (const Side& side : sides_)
    if (!side.edge) mesh.crack_sides.push_back({side.from, side.to});
  return mesh;
}

}  // namespace

BodyMesh mesh_body(const std::vector<Edge>& boundary, const CrackLines& cracks, double size) {
  BodyMesher mesher(boundary, size);
  std::vector<Point> mouths;
  for (const CrackJoint& joint : cracks.joints)
    if (joint.mouth) mouths.push_back(joint.place);
  mesher.add_boundary(mouths);
  for (const CrackLine& line : cracks.lines)
    for (std::size_t k = 0; k + 1 < line.points.size(); ++k) mesher.add_crack({line.points[k], line.points[k + 1]});
  mesher.refine();
  return mesher.result();
}

}  // namespace bempd
