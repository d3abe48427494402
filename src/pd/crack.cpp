#include "pd/crack.hpp"

#include <algorithm>

#include "geometry/segment.hpp"

namespace bempd::pd {

namespace {

constexpr double touching = 1e-9;

bool boxes_apart(const Segment& a, const Segment& b) {
  const auto apart = [&](int axis) {
    const auto [a_low, a_high] = std::minmax(a.start[axis], a.end[axis]);
    const auto [b_low, b_high] = std::minmax(b.start[axis], b.end[axis]);
    return a_high < b_low - touching || b_high < a_low - touching;
  };
  return apart(0) || apart(1);
}

bool meet(const Segment& a, const Segment& b) {
  if (boxes_apart(a, b)) return false;
  return proper_crossing(a, b).has_value() || closest_approach(a, b).distance <= touching;
}

std::vector<Segment> pieces_of(const std::vector<Point>& polyline) {
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) pieces.push_back({polyline[i], polyline[i + 1]});
  return pieces;
}

}  // namespace

std::vector<int> bonds_cut_by(const CellLattice& lattice, const std::vector<Bond>& bonds,
                              const std::vector<Point>& polyline) {
  const std::vector<Segment> pieces = pieces_of(polyline);
  std::vector<int> cut;
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const Segment bond{lattice.point(bonds[b].first).cast<double>(), lattice.point(bonds[b].second).cast<double>()};
    if (std::any_of(pieces.begin(), pieces.end(), [&](const Segment& piece) { return meet(bond, piece); })) {
      cut.push_back(static_cast<int>(b));
    }
  }
  return cut;
}

std::vector<int> points_on(const CellLattice& lattice, const std::vector<Point>& polyline) {
  const std::vector<Segment> pieces = pieces_of(polyline);
  std::vector<int> found;
  for (int i = 0; i < lattice.point_count(); ++i) {
    const Point p = lattice.point(i).cast<double>();
    if (std::any_of(pieces.begin(), pieces.end(), [&](const Segment& s) { return distance(s, p) <= touching; })) {
      found.push_back(i);
    }
  }
  return found;
}

}  // namespace bempd::pd
