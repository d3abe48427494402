#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace bempd::regions {

struct Preparation;

// Part of a crack: a piece inside one boundary element region, which has elements on it, or inside lattices, whose
// bonds it cuts.
struct CrackPart {
  int region;                 // that has elements on it; 0: it cuts bonds
  std::vector<Point> points;  // of the polyline
  // Numbers of segments at the part's start and end that growth has added.
  int grown_at_start = 0, grown_at_end = 0;
  double start = 0;                                 // its way along the crack [m]
  bool from_another = false, into_another = false;  // whether another part of the crack is before or behind it
  // Spacing [m] of the two material points between which the part begins (`spacing_before`) or ends (`spacing_behind`)
  // at another part; 0 if it does not begin or end at the interface with a lattice.
  double spacing_before = 0, spacing_behind = 0;
  // Distance [m] along the neighbouring part, from the shared mouth to its next bend or end, if that part lies in
  // another boundary element region; 0 if there is none.
  double reach_before = 0, reach_behind = 0;
};

// Crack divided into parts by the regions that it runs through.
struct PartedCrack {
  // The crack as described, except that it is bent to pass interfaces with lattices half way between two material
  // points.
  scene::Crack crack;
  std::vector<CrackPart> parts;  // in its order; none if the crack was removed

  bool cuts_bonds() const { return has_elements_in(0); }
  bool has_elements() const;
  bool has_elements_in(int region) const;
  // Region of the first part (end 0) or the last part (end 1): the id of a region with elements, or 0 where it cuts
  // bonds.
  int region_at(int end) const { return (end == 0 ? parts.front() : parts.back()).region; }
  // Part at a fraction of the crack's length; where two parts meet, the one with elements.
  const CrackPart& part_at(double fraction) const;
};

// Divides all cracks of the scene into parts. Throws Error (argument) for a crack that leaves the body, runs along an
// interface, or crosses an interface where it cannot.
std::vector<PartedCrack> parted_cracks(const Preparation& preparation, std::vector<std::string>& warnings);

}  // namespace bempd::regions
