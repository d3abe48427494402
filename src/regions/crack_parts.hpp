#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace bempd::regions {

struct Preparation;

// A piece of a crack inside of one boundary element region, which has elements on it, or inside of lattices, whose
// bonds it cuts.
struct CrackPart {
  int region;                 // that has elements on it; 0: it cuts bonds
  std::vector<Point> points;  // of the polyline
  // Segments at its start and end that growth has added.
  int grown_at_start = 0, grown_at_end = 0;
  double start = 0;                                 // its way along the crack [m]
  bool from_another = false, into_another = false;  // whether another part of the crack is before or behind it
  // Spacing of the material points between which it comes from that part and goes into it; 0 without [m].
  double spacing_before = 0, spacing_behind = 0;
  // The way from there along a part with elements to its next bend or end; 0 without [m].
  double reach_before = 0, reach_behind = 0;
};

// A crack by the regions that it runs through.
struct PartedCrack {
  // The crack as described, but bent to where it passes from elements to bonds: half way between two rows of points.
  scene::Crack crack;
  std::vector<CrackPart> parts;  // in its order; none if the crack was removed

  bool cuts_bonds() const { return has_elements_in(0); }
  bool has_elements() const;
  bool has_elements_in(int region) const;
  // What has its first part (end 0) or its last one (end 1): a region with elements, or 0.
  int region_at(int end) const { return (end == 0 ? parts.front() : parts.back()).region; }
  // The part that has a place at a fraction of the crack's length; of two that meet there one that has elements.
  const CrackPart& part_at(double fraction) const;
};

// Throws Error (argument) for a crack that leaves the body, runs along an interface, or crosses one where it cannot.
std::vector<PartedCrack> parted_cracks(const Preparation& preparation, std::vector<std::string>& warnings);

}  // namespace bempd::regions
