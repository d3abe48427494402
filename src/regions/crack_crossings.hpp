#pragma once

#include <string>
#include <utility>
#include <vector>

#include "regions/crack_parts.hpp"
#include "regions/preparation.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Crossing: place where a crack passes from one region to another.
struct CrackCrossing {
  double way;              // along the crack, as described [m]
  Point place, direction;  // direction: of the crack, a unit vector
  int before, after;       // regions that have elements on it; 0: it cuts bonds
  double spacing = 0;      // of the material points beside `place`, once it lies half way between two of them [m]

  bool among_elements() const { return before > 0 && after > 0; }
};

// Moves the crossings between boundary elements and lattices to the middle between two material points on the
// interface. Elsewhere the crack would have different lengths for the elements and for the bonds. `length` is the
// crack's. Throws Error (argument) for interfaces that no crack can cross; adds a warning for each crossing that is
// moved.
void move_between_rows(const Preparation& preparation, int crack, std::vector<CrackCrossing>& crossings, double length,
                       std::vector<std::string>& warnings);

// Crack that passes through its crossings with interfaces after these have been moved. It is bent within a few spacings
// of a crossing into a lattice; crossings between two boundary element regions do not bend it.
struct MovedCrack {
  std::vector<Point> points;
  std::vector<char> grown;             // by segment
  std::vector<std::size_t> crossings;  // points, by crossing

  // Numbers of segments that growth has added at the start and at the end of the piece between the points `from` and
  // `to`.
  std::pair<int, int> grown_at_ends(std::size_t from, std::size_t to) const;
  scene::Crack crack() const;
};
// Bends a crack so that it passes through the places of its crossings. Vertices closer to each other than `same` become
// one.
MovedCrack bent_to(const scene::Crack& crack, const std::vector<CrackCrossing>& crossings, double same);

// Mouth of a crack on the interface of two boundary element regions that it passes through. Both regions have two nodes
// there, one on each face of the crack, and share them. `before` and `behind` are the neighbouring points of the crack.
struct SharedMouth {
  Point place, before, behind;

  // Side of the crack on which a point near the mouth lies: 1 for left, -1 for right.
  int side_of(const Point& x) const;
};
std::vector<SharedMouth> shared_mouths(const std::vector<PartedCrack>& cracks);

// Throws Error (argument) if two cracks cross an interface at the same place, or between the same two material points.
void require_mouths_apart(const std::vector<PartedCrack>& cracks, double tolerance);

}  // namespace bempd::regions
