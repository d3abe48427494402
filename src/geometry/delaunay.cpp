#include "geometry/delaunay.hpp"

#include <cmath>
#include <cstdlib>
#include <map>

namespace bempd {

namespace {

constexpr std::int64_t grid_reach = std::int64_t{1} << 23;

// Integer type for products of four differences of coordinates, which have up to 119 bits.
__extension__ using Wide = __int128;

}  // namespace

Delaunay::Delaunay(const Box& box) : centre_(box.center()) {
  const double half = 0.5 * box.sizes().maxCoeff();
  scale_ = half > 0 ? static_cast<double>(grid_reach) / half : 1;
  places_ = {{-32 * grid_reach, -32 * grid_reach}, {32 * grid_reach, -32 * grid_reach}, {0, 32 * grid_reach}};
  triangles_.push_back({{-3, -2, -1}, {-1, -1, -1}});
}

std::int64_t Delaunay::turn(const Place& a, const Place& b, const Place& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool Delaunay::circle_holds(const Triangle& triangle, const Place& p) const {
  std::array<Wide, 3> x, y, square;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = place(triangle.points[k]).x - p.x;
    y[k] = place(triangle.points[k]).y - p.y;
    square[k] = x[k] * x[k] + y[k] * y[k];
  }
  const Wide sum = (x[0] * y[1] - x[1] * y[0]) * square[2] + (x[1] * y[2] - x[2] * y[1]) * square[0] +
                   (x[2] * y[0] - x[0] * y[2]) * square[1];
  return sum > 0;
}

// Number of the triangle that contains the place, found by walking from triangle to triangle towards the place. In a
// Delaunay triangulation this walk ends.
int Delaunay::triangle_at(const Place& p) const {
  int at = static_cast<int>(triangles_.size()) - 1;  // the newest triangle exists
  for (bool moved = true; moved;) {
    moved = false;
    const Triangle& triangle = triangles_[static_cast<std::size_t>(at)];
    for (std::size_t k = 0; k < 3 && !moved; ++k) {
      if (turn(place(triangle.points[(k + 1) % 3]), place(triangle.points[(k + 2) % 3]), p) >= 0) continue;
      at = triangle.neighbours[k];
      moved = true;
    }
  }
  return at;
}

// Removes the triangles whose circumcircles contain the place, and returns the rim of the connected cavity that they
// leave. `first` is the triangle that contains the place.
std::vector<Delaunay::Rim> Delaunay::open_cavity(int first, const Place& p) {
  std::vector<Rim> rim;
  std::vector<int> waiting{first};
  triangles_[static_cast<std::size_t>(first)].exists = false;
  while (!waiting.empty()) {
    const Triangle triangle = triangles_[static_cast<std::size_t>(waiting.back())];
    waiting.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const int other = triangle.neighbours[k];
      if (other >= 0) {
        Triangle& beyond = triangles_[static_cast<std::size_t>(other)];
        if (!beyond.exists) continue;
        if (circle_holds(beyond, p)) {
          beyond.exists = false;
          waiting.push_back(other);
          continue;
        }
      }
      rim.push_back({{triangle.points[(k + 1) % 3], triangle.points[(k + 2) % 3]}, other});
    }
  }
  return rim;
}

int Delaunay::insert(const Point& p) {
  const Point scaled = scale_ * (p - centre_);
  const Place at{std::llround(scaled.x()), std::llround(scaled.y())};
  fresh_.clear();
  const int first = triangle_at(at);
  for (const int point : triangles_[static_cast<std::size_t>(first)].points) {
    // Neighbouring grid points count as one point, because a place that is computed in two ways may be rounded to
    // either of them.
    if (std::abs(place(point).x - at.x) <= 1 && std::abs(place(point).y - at.y) <= 1) return point;
  }
  const std::vector<Rim> rim = open_cavity(first, at);
  const int number = point_count();
  places_.push_back(at);
  std::map<int, int> beginning_at;  // new triangle whose side on the rim begins at a point
  for (const Rim& side : rim) {
    const int made = static_cast<int>(triangles_.size());
    triangles_.push_back({{side.points[0], side.points[1], number}, {-1, -1, side.beyond}});
    fresh_.push_back(made);
    beginning_at.emplace(side.points[0], made);
    if (side.beyond < 0) continue;
    Triangle& beyond = triangles_[static_cast<std::size_t>(side.beyond)];
    for (std::size_t k = 0; k < 3; ++k)
      if (beyond.points[(k + 1) % 3] == side.points[1] && beyond.points[(k + 2) % 3] == side.points[0])
        beyond.neighbours[k] = made;
  }
  for (const int made : fresh_) {
    const int next = beginning_at.at(triangles_[static_cast<std::size_t>(made)].points[1]);
    triangles_[static_cast<std::size_t>(made)].neighbours[0] = next;
    triangles_[static_cast<std::size_t>(next)].neighbours[1] = made;
  }
  return number;
}

}  // namespace bempd
