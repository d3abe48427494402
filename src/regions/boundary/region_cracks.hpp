#pragma once

#include <array>
#include <string>
#include <vector>

#include "bem/crack_grading.hpp"
#include "bem/crack_tips.hpp"
#include "regions/boundary/boundary_meshing.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Extent of a piece of a crack along the crack [m].
struct CrackExtent {
  double start, length;             // of the piece's start; of all of the crack
  double given_from, given_length;  // start and length of the crack before it grew
};

// Cracks of one boundary element region: their parts, the elements on them, and the tractions on their faces.
class RegionCracks {
 public:
  // Prepares the cracks of a region. Throws Error (argument) for cracks that it cannot have.
  RegionCracks(const Preparation& preparation, int region);
  RegionCracks(const RegionCracks&) = delete;
  RegionCracks& operator=(const RegionCracks&) = delete;

  // Mouths: places on the region's boundary where cracks start or end.
  std::vector<Point> mouths() const;
  // Whether a mouth lies on the row of points that the region shares with a lattice, in which its crack continues.
  bool is_on_row(const Point& mouth) const;
  const bem::CrackSizes& sizes() const { return sizes_; }

  // Meshes the cracks. It splits nodes of the boundary's mesh at mouths, and adds to that mesh the faces of cracks that
  // separate two pieces.
  void mesh(BoundaryMesh& boundary);
  const bem::CrackMesh& elements() const { return mesh_; }

  const CrackLines& lines() const { return lines_; }
  double tolerance() const { return tolerance_; }

  // Estimated memory [B] of an operator with this number of elements on the boundary and the cracks.
  static double memory_of(double elements);
  // Throws Error (argument) if the operator on the boundary and the cracks needs more memory than there is.
  void require_memory(const BoundaryMesh& boundary, const scene::Options& options) const;
  // Adds a warning if elements in a narrow gap between a crack and something else are so many that preparing takes
  // long.
  void warn_of_gap(const BoundaryMesh& boundary, std::vector<std::string>& warnings) const;

  int region() const { return region_; }
  bool has(int crack) const;
  int id_of(const bem::CrackTip& tip) const { return paths_[lines_.lines[tip.line].crack].id; }
  // Length by which a tip has grown [m].
  double grown_of(const bem::CrackTip& tip) const {
    const CrackExtent& extent = extents_[lines_.lines[tip.line].crack];
    const double behind = extent.length - extent.given_from - extent.given_length;
    return tip.end == bem::TipEnd::end ? std::max(0.0, behind) : extent.given_from;
  }
  // Traction on crack faces: constant part of the loads times `constant` plus proportional part times `proportional`;
  // empty without loads.
  bem::FaceTraction traction(const std::vector<CrackLoad>& loads, double constant, double proportional) const;
  // Opening at a fraction of a crack's length: tangential and normal component [m].
  Point opening_at(int crack, double fraction, const bem::CrackedState& state) const;
  std::vector<CrackPicture> pictures(const bem::CrackedState& state) const;
  std::optional<Overlap> overlap(const bem::CrackedState& state) const;
  // Whether part of the crack lies inside a piece, so that it does not separate two pieces.
  bool has_inside(int crack) const;

 private:
  // Element on a crack, inside a piece or between two pieces, with its openings.
  struct Opened {
    int line;
    double from, to;  // ways along its line
    bem::TipEnd tip;
    std::array<Point, 3> places, openings;
  };
  std::vector<Opened> opened(const bem::CrackedState& state) const;
  static bem::CrackGrading grading(const scene::Region& region);
  std::vector<std::vector<double>> halved_stations() const;
  static std::array<Point, 3> openings_on(const bem::CrackElement& element, const bem::CrackedState& state);
  static std::array<Point, 3> openings_on(const bem::CutElement& element, const bem::CrackedState& state);
  // Fraction of the crack's original length at a place on a line. Loads refer to it, so that they stay in place when
  // the crack grows; beyond the original ends it stays 0 or 1.
  double fraction_at(int line, const Point& x) const;
  std::string gap_sentence(const bem::NarrowGap& gap) const;

  int region_, halvings_;
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

// Creates the cracks on which a region has elements; null if there are none.
std::unique_ptr<RegionCracks> cracks_of(const Preparation& preparation, int region);

// Divides boundary elements near cracks. A length that the host has chosen becomes the longest one. On interfaces
// between two boundary element regions the cracks of both count, so that both get the same elements.
void refine_at_cracks(const Preparation& preparation, const RegionCracks* own, BoundaryPanels& panels);

}  // namespace bempd::regions
