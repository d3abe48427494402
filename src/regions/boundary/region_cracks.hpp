#pragma once

#include <array>
#include <string>
#include <vector>

#include "bem/crack_grading.hpp"
#include "bem/crack_tips.hpp"
#include "regions/boundary/boundary_meshing.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Extent of a piece of a crack, as distances along the crack [m].
struct CrackExtent {
  double start, length;             // of the piece's start; of all of the crack
  double given_from, given_length;  // start and length of the crack before it grew
};

// Cracks of one boundary element region: their parts, elements on them, and the tractions on their faces.
class RegionCracks {
 public:
  // Prepares the cracks. Throws Error (argument) for cracks that the region cannot have.
  RegionCracks(const Preparation& preparation, int region);
  RegionCracks(const RegionCracks&) = delete;
  RegionCracks& operator=(const RegionCracks&) = delete;

  // Places on the boundary where cracks start or end.
  std::vector<Point> mouths() const;
  // Whether the crack of a mouth goes on in a lattice there.
  bool is_on_row(const Point& mouth) const;
  const bem::CrackSizes& sizes() const { return sizes_; }

  // Splits nodes of the boundary's mesh, and adds the faces of cracks between pieces to it.
  void mesh(BoundaryMesh& boundary);
  const bem::CrackMesh& elements() const { return mesh_; }

  const CrackLines& lines() const { return lines_; }
  double tolerance() const { return tolerance_; }

  // Throws Error (argument) if the operator on the boundary and the cracks needs more memory than there is.
  void require_memory(const BoundaryMesh& boundary, const scene::Options& options) const;
  // Adds a warning if a narrow gap needs so many elements that preparing takes long.
  void warn_of_gap(const BoundaryMesh& boundary, std::vector<std::string>& warnings) const;

  int region() const { return region_; }
  bool has(int crack) const;
  int id_of(const bem::CrackTip& tip) const { return paths_[lines_.lines[tip.line].crack].id; }
  // Traction of loads, of their constant part, their proportional part, or both at a load factor; empty without loads.
  bem::FaceTraction traction(const std::vector<CrackLoad>& loads, double constant, double proportional) const;
  // Opening at a fraction of the length of a crack, along it and normal to it.
  Point opening_at(int crack, double fraction, const bem::CrackedState& state) const;
  std::vector<CrackPicture> pictures(const bem::CrackedState& state) const;
  std::optional<Overlap> overlap(const bem::CrackedState& state) const;
  // Whether a crack has a part that does not cut the region.
  bool has_inside(int crack) const;

 private:
  // Element on a crack, inside a piece or between two.
  struct Opened {
    int line;
    double from, to;  // ways along its line
    bem::TipEnd tip;
    std::array<Point, 3> places, openings;
  };
  std::vector<Opened> opened(const bem::CrackedState& state) const;
  static std::array<Point, 3> openings_on(const bem::CrackElement& element, const bem::CrackedState& state);
  static std::array<Point, 3> openings_on(const bem::CutElement& element, const bem::CrackedState& state);
  // Fraction of the crack as it was given: loads stay where they are when it grows, and go on beyond its ends.
  double fraction_at(int line, const Point& x) const;
  std::string gap_sentence(const bem::NarrowGap& gap) const;

  int region_;
  double tolerance_;
  std::vector<CrackPath> paths_;  // their pieces in this region
  std::vector<CrackExtent> extents_;
  std::vector<Edge> edges_;
  CrackLines lines_;
  std::vector<bem::MouthOnRow> rows_;
  bem::CrackSizes sizes_;
  bem::CrackMesh mesh_;
  std::vector<std::array<Point, 3>> cut_places_;  // of its elements between pieces
};

// Cracks on which a region has elements; null if there are none.
std::unique_ptr<RegionCracks> cracks_of(const Preparation& preparation, int region);

// Divides elements near cracks, also those whose length the host has chosen: that is then the longest. At interfaces
// with other boundary elements the cracks of both sides count, so that both sides get the same elements.
void refine_at_cracks(const Preparation& preparation, const RegionCracks* own, BoundaryPanels& panels);

}  // namespace bempd::regions
