#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace bempd::regions {

struct Preparation;

// Part of a crack: a piece in one boundary element region, which has elements on the piece, or in lattices, whose bonds
// the piece cuts.
struct CrackPart {
  int region;                 // id of the region that has elements on the part; 0: the part cuts bonds
  std::vector<Point> points;  // vertices of the part
  // Numbers of segments that growth has added at the start and at the end of the part.
  int grown_at_start = 0, grown_at_end = 0;
  double start = 0;                                 // distance along the crack at which the part starts [m]
  bool from_another = false, into_another = false;  // whether another part lies before or behind it
  // Distance [m] of the two material points between which the part begins; 0 if it does not begin at a lattice.
  double spacing_before = 0;
  // Distance [m] of the two material points between which the part ends; 0 if it does not end at a lattice.
  double spacing_behind = 0;
  // Distance [m] from the part's start back along the crack to the crack's next bend or end, if this part and the part
  // before it have elements; else 0.
  double reach_before = 0;
  // Distance [m] from the part's end along the crack to the crack's next bend or end, if this part and the part behind
  // it have elements; else 0.
  double reach_behind = 0;
};

// Crack divided into parts by the regions that it runs through.
struct PartedCrack {
  // The crack as described, except that it is bent to pass interfaces with lattices half way between two material
  // points.
  scene::Crack crack;
  std::vector<CrackPart> parts;  // in order along the crack; none if the crack was removed

  bool cuts_bonds() const { return has_elements_in(0); }
  bool has_elements() const;
  bool has_elements_in(int region) const;
  // Region of the first part (end 0) or of the last part (end 1): the id of a region with elements, or 0 for a part
  // that cuts bonds.
  int region_at(int end) const { return (end == 0 ? parts.front() : parts.back()).region; }
  // Part at a fraction of the crack's length. Where a part with elements meets a part that cuts bonds, the part with
  // elements is returned.
  const CrackPart& part_at(double fraction) const;
};

// Divides all cracks of the scene into parts. Throws Error (argument) for a crack that leaves the body, runs along an
// interface, or crosses an interface at a place where no crack can cross.
std::vector<PartedCrack> parted_cracks(const Preparation& preparation, std::vector<std::string>& warnings);

}  // namespace bempd::regions
