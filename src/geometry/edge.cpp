#include "geometry/edge.hpp"

#include <algorithm>

namespace bempd {

Edge::Edge(const std::array<Arc, 2>& arcs) : start(arcs[0].start), end(arcs[1].end), pieces_(arcs) {
  const double first = arcs[0].length();
  joint_ = first / (first + arcs[1].length());
}

double Edge::length() const { return piece_count() == 1 ? pieces_[0].length() : pieces_[0].length() / joint_; }

const Arc& Edge::piece_at(double& fraction) const {
  if (fraction <= joint_) {
    fraction /= joint_;
    return pieces_[0];
  }
  fraction = 1 - (1 - fraction) / (1 - joint_);
  return pieces_[1];
}

Point Edge::at(double fraction) const {
  const Arc& arc = piece_at(fraction);
  return arc.at(fraction);
}

Point Edge::tangent(double fraction) const {
  const Arc& arc = piece_at(fraction);
  return arc.tangent(fraction);
}

Arc Edge::part(double from, double to) const {
  if (piece_count() == 1) return pieces_[0].part(from, to);
  if (0.5 * (from + to) <= joint_) return pieces_[0].part(from / joint_, std::min(1.0, to / joint_));
  return pieces_[1].part(std::max(0.0, 1 - (1 - from) / (1 - joint_)), 1 - (1 - to) / (1 - joint_));
}

Box bounding_box(const Edge& edge) {
  Box box;
  for (int k = 0; k < edge.piece_count(); ++k) {
    const Arc& arc = edge.piece(k);
    box.extend(arc.start);
    box.extend(arc.end);
    if (arc.straight()) continue;
    for (const Point& direction : {Point(1, 0), Point(-1, 0), Point(0, 1), Point(0, -1)}) {
      // The circle's outermost point in each direction extends the box if it lies on the arc, else the arc's end
      // nearest to it does. The radius of a flat arc may be huge.
      const Point centre = arc.centre();
      const Point outermost = centre + (arc.start - centre).norm() * direction;
      box.extend(arc.at(closest_fraction(arc, outermost)));
    }
  }
  return box;
}

std::vector<Box> coarse_boxes(const std::vector<Edge>& edges) {
  std::vector<Box> boxes(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (int k = 0; k < edges[e].piece_count(); ++k) {
      const Arc& arc = edges[e].piece(k);
      const Point middle = arc.chord().at(0.5), reach = Point::Constant(-least_distance(arc, middle));
      boxes[e].extend(Box(middle - reach, middle + reach));
    }
  return boxes;
}

double closest_fraction(const Edge& edge, const Point& p) {
  const double first = closest_fraction(edge.piece(0), p);
  if (edge.piece_count() == 1) return first;
  const double second = closest_fraction(edge.piece(1), p);
  if ((edge.piece(0).at(first) - p).squaredNorm() <= (edge.piece(1).at(second) - p).squaredNorm())
    return first * edge.joint();
  return 1 - (1 - second) * (1 - edge.joint());
}

double distance(const Edge& edge, const Point& p) { return (p - edge.at(closest_fraction(edge, p))).norm(); }

double least_distance(const Edge& edge, const Point& p) {
  const double first = least_distance(edge.piece(0), p);
  return edge.piece_count() == 1 ? first : std::min(first, least_distance(edge.piece(1), p));
}

std::vector<Crossing> meeting_points(const Edge& a, const Edge& b) {
  const auto on_edge = [](const Edge& edge, int piece, double fraction) {
    if (edge.piece_count() == 1) return fraction;
    return piece == 0 ? fraction * edge.joint() : 1 - (1 - fraction) * (1 - edge.joint());
  };
  std::vector<Crossing> all;
  for (int i = 0; i < a.piece_count(); ++i)
    for (int j = 0; j < b.piece_count(); ++j)
      for (const Crossing& c : meeting_points(a.piece(i), b.piece(j)))
        all.push_back({on_edge(a, i, c.fraction_a), on_edge(b, j, c.fraction_b)});
  return all;
}

std::optional<Point> find_contact(const Edge& a, const Edge& b, double tolerance) {
  for (int i = 0; i < a.piece_count(); ++i)
    for (int j = 0; j < b.piece_count(); ++j)
      if (const auto found = find_contact(a.piece(i), b.piece(j), tolerance)) return found;
  return std::nullopt;
}

bool ray_crosses(const Edge& edge, const Point& p) {
  bool odd = false;
  for (int k = 0; k < edge.piece_count(); ++k) {
    const Arc& arc = edge.piece(k);
    const Point d = arc.end - arc.start;
    const bool upward = arc.end.y() > p.y();
    if ((arc.start.y() > p.y()) != upward && (cross(d, p - arc.start) > 0) == upward) odd = !odd;
    // A point between the arc and its chord lies on one side of the arc and on the other side of the chord.
    if (in_circular_segment(arc, p)) odd = !odd;
  }
  return odd;
}

}  // namespace bempd
