#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

#include "geometry/arc.hpp"

namespace bempd {

using Box = Eigen::AlignedBox2d;

// Edge of an outline: a straight piece, a circular arc, or two arcs with a common tangent at their joint. Places on the
// edge are given by fractions of its length.
class Edge {
 public:
  Edge(const Point& from, const Point& to) : Edge(Arc{from, to, 0}) {}
  explicit Edge(const Arc& arc) : start(arc.start), end(arc.end), pieces_{arc, arc}, joint_(1) {}
  explicit Edge(const std::array<Arc, 2>& arcs);

  bool straight() const { return piece_count() == 1 && pieces_[0].straight(); }
  int piece_count() const { return joint_ < 1 ? 2 : 1; }
  const Arc& piece(int k) const { return pieces_[k]; }
  // Fraction of the edge at which its two arcs join; 1 if the edge has one piece only.
  double joint() const { return joint_; }

  Point direction() const { return end - start; }
  double length() const;
  Point at(double fraction) const;
  Point tangent(double fraction) const;
  // Part of the edge between two fractions, which must belong to the same piece.
  Arc part(double from, double to) const;

  Point start, end;

 private:
  // Piece that contains a place; `fraction` is changed from that of the edge to that of the piece.
  const Arc& piece_at(double& fraction) const;

  std::array<Arc, 2> pieces_;
  double joint_;
};

Box bounding_box(const Edge& edge);
// Boxes around the circles with which least_distance() bounds the distance from edges: larger than bounding_box(), but
// computed faster.
std::vector<Box> coarse_boxes(const std::vector<Edge>& edges);
double closest_fraction(const Edge& edge, const Point& p);
double distance(const Edge& edge, const Point& p);
// Lower bound on the distance of `p` from the edge, computed faster than distance().
double least_distance(const Edge& edge, const Point& p);
std::vector<Crossing> meeting_points(const Edge& a, const Edge& b);
std::optional<Point> find_contact(const Edge& a, const Edge& b, double tolerance);

// Whether the ray from `p` to the right crosses the edge an odd number of times. The lower end of the edge belongs to
// the edge, its upper end does not, so that the rays of a loop count no vertex twice.
bool ray_crosses(const Edge& edge, const Point& p);

}  // namespace bempd
