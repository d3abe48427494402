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
  double way;              // distance along the described crack [m]
  Point place, direction;  // direction: unit vector along the crack
  int before, after;       // ids of the regions with elements before and behind it; 0: the crack cuts bonds there
  double spacing = 0;      // distance of the material points between which it was moved [m]; 0: it was not

  bool among_elements() const { return before > 0 && after > 0; }
};

// Moves each crossing between boundary elements and a lattice to the middle between two material points on the
// interface. At any other place the length of the crack would be different for the elements and for the bonds. `length`
// is the length of the crack. Throws Error (argument) for interfaces that no crack can cross; adds a warning for each
// crossing that is moved.
void move_between_rows(const Preparation& preparation, int crack, std::vector<CrackCrossing>& crossings, double length,
                       std::vector<std::string>& warnings);

// Crack whose crossings with interfaces have been moved. The crack is bent within a few spacings of each crossing into
// a lattice, and stays as it is at crossings between two boundary element regions.
struct MovedCrack {
  std::vector<Point> points;
  std::vector<char> grown;             // flag of each segment: 1 if growth has added it
  std::vector<std::size_t> crossings;  // index in `points` of each crossing

  // Numbers of segments that growth has added at the start and at the end of the piece of the crack between the points
  // with the indices `from` and `to`.
  std::pair<int, int> grown_at_ends(std::size_t from, std::size_t to) const;
  scene::Crack crack() const;
};
// Bends a crack so that it passes through the places of its crossings. A vertex of the crack closer than `same` [m] to
// a crossing between two boundary element regions is replaced by the crossing.
MovedCrack bent_to(const scene::Crack& crack, const std::vector<CrackCrossing>& crossings, double same);

// Place where a crack passes through the interface of two boundary element regions. Two nodes lie at this place, one on
// each face of the crack, and both regions share these nodes. `before` and `behind` are the points of the crack next to
// the place.
struct SharedMouth {
  Point place, before, behind;

  // Side of the crack on which a point near the mouth lies: 1 for left, -1 for right.
  int side_of(const Point& x) const;
};
std::vector<SharedMouth> shared_mouths(const std::vector<PartedCrack>& cracks);

// Throws Error (argument) if two cracks cross an interface at the same place, or between the same two material points.
void require_mouths_apart(const std::vector<PartedCrack>& cracks, double tolerance);

}  // namespace bempd::regions
