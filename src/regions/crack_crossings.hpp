#pragma once

#include <string>
#include <utility>
#include <vector>

#include "regions/crack_parts.hpp"
#include "regions/preparation.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// A place where a crack passes from one region to another.
struct CrackCrossing {
  double way;              // along the crack, as described [m]
  Point place, direction;  // direction: of the crack, a unit vector
  int before, after;       // regions that have elements on it; 0: it cuts bonds
  double spacing = 0;      // of the material points beside `place`, once it lies half way between two of them [m]

  bool among_elements() const { return before > 0 && after > 0; }
};

// Moves the crossings between elements and bonds of a crack of some length along the interface, to half way between
// two material points there: elsewhere the crack would be longer for the elements than for the bonds, or shorter.
// Throws Error (argument) for what no crack can cross.
void move_between_rows(const Preparation& preparation, int crack, std::vector<CrackCrossing>& crossings, double length,
                       std::vector<std::string>& warnings);

// A crack that passes the places of its crossings, within a few spacings of which it may be bent. Among elements it
// stays straight.
struct BentCrack {
  std::vector<Point> points;
  std::vector<char> grown;             // by segment
  std::vector<std::size_t> crossings;  // points, by crossing

  // Segments that growth has added at the start and the end of the piece between two points.
  std::pair<int, int> grown_at_ends(std::size_t from, std::size_t to) const;
  scene::Crack crack() const;
};
// Vertices closer than `same` to each other are one.
BentCrack bent_to(const scene::Crack& crack, const std::vector<CrackCrossing>& crossings, double same);

// The mouth of a crack that passes from one region with elements to another: both have two nodes there, one on each
// face, which they share. `before` and `behind` are next to the place on the crack.
struct SharedMouth {
  Point place, before, behind;

  // 1 for what lies on the left of the crack beside the place, -1 on its right.
  int side_of(const Point& x) const;
};
std::vector<SharedMouth> shared_mouths(const std::vector<PartedCrack>& cracks);

// Throws Error (argument) where two of all crossings between elements and bonds lie between the same two points.
void require_mouths_apart(const std::vector<PartedCrack>& cracks, double tolerance);

}  // namespace bempd::regions
