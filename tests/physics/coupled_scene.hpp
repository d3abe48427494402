// Bodies put together from polygons of either method, and the parts of their edges that touch no other polygon.
#pragma once

#include <algorithm>

#include "host.hpp"

namespace host {

enum class Method { boundary_elements, peridynamics };

struct Piece {
  Method method;
  Outline outline;
  std::vector<Outline> holes{};
};

// Part of an edge of a piece between two fractions of its length.
struct EdgePart {
  std::size_t piece;
  int32_t edge;
  double from, to;
  Vector start, end;  // of the part
  double length() const { return std::hypot(end[0] - start[0], end[1] - start[1]); }
  // Outward, the body being on the left of the edge.
  Vector normal() const { return {(end[1] - start[1]) / length(), -(end[0] - start[0]) / length()}; }
};

inline std::vector<EdgePart> edges_of(const Piece& piece, std::size_t index) {
  std::vector<Outline> loops{piece.outline};
  loops.insert(loops.end(), piece.holes.begin(), piece.holes.end());
  std::vector<EdgePart> edges;
  for (const Outline& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k)
      edges.push_back({index, static_cast<int32_t>(edges.size() + 1), 0, 1, loop[k], loop[(k + 1) % loop.size()]});
  return edges;
}

// Fractions of `edge` between which it runs along `other`, or an empty interval.
inline std::array<double, 2> contact(const EdgePart& edge, const EdgePart& other) {
  const double length = edge.length();
  const Vector along{(edge.end[0] - edge.start[0]) / length, (edge.end[1] - edge.start[1]) / length};
  std::array<double, 2> place;
  const Vector ends[2] = {other.start, other.end};
  for (int k = 0; k < 2; ++k) {
    const double x = ends[k][0] - edge.start[0], y = ends[k][1] - edge.start[1];
    if (std::abs(x * along[1] - y * along[0]) > 1e-9 * length) return {0, 0};
    place[static_cast<std::size_t>(k)] = (x * along[0] + y * along[1]) / length;
  }
  return {std::clamp(std::min(place[0], place[1]), 0.0, 1.0), std::clamp(std::max(place[0], place[1]), 0.0, 1.0)};
}

inline std::vector<EdgePart> free_parts(const std::vector<Piece>& pieces) {
  std::vector<EdgePart> all, result;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const EdgePart& edge : edges_of(pieces[i], i)) all.push_back(edge);
  for (const EdgePart& edge : all) {
    std::vector<std::array<double, 2>> touched;
    for (const EdgePart& other : all)
      if (other.piece != edge.piece) touched.push_back(contact(edge, other));
    std::sort(touched.begin(), touched.end());
    touched.push_back({1, 1});
    double from = 0;
    for (const auto& [begin, end] : touched) {
      if (end <= begin && begin < 1) continue;
      if (begin > from + 1e-9) {
        EdgePart part = edge;
        part.from = from, part.to = begin;
        for (std::size_t k = 0; k < 2; ++k) {
          part.start[k] = edge.start[k] + from * (edge.end[k] - edge.start[k]);
          part.end[k] = edge.start[k] + begin * (edge.end[k] - edge.start[k]);
        }
        result.push_back(part);
      }
      from = std::max(from, end);
    }
  }
  return result;
}

inline std::vector<int32_t> add_pieces(Model& model, const std::vector<Piece>& pieces, int32_t material, double spacing,
                                       int horizon_ratio, double element_length) {
  std::vector<int32_t> regions;
  for (const Piece& piece : pieces) {
    regions.push_back(piece.method == Method::peridynamics ? model.pd(material, piece.outline, spacing, horizon_ratio)
                                                           : model.bem(material, piece.outline, element_length));
    for (const Outline& hole : piece.holes) model.hole(regions.back(), hole);
  }
  return regions;
}

inline bool inside(const Piece& piece, Vector p) {
  bool result = false;
  for (const EdgePart& e : edges_of(piece, 0))
    if ((e.start[1] > p[1]) != (e.end[1] > p[1]) &&
        p[0] < e.start[0] + (p[1] - e.start[1]) / (e.end[1] - e.start[1]) * (e.end[0] - e.start[0]))
      result = !result;
  return result;
}

}  // namespace host
