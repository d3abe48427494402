#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bem/crack_mesh.hpp"
#include "bem/crack_tips.hpp"
#include "geometry/crack_lines.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Extent of a piece of a crack along the crack [m].
struct CrackExtent {
  double start, length;             // of the piece's start; of all of the crack
  double given_from, given_length;  // start and length of the crack before it grew
};

// Lines of cracks with the ends of their elements, as ways along each line. A line's `crack` is the number of its path.
struct CracksToMesh {
  std::vector<CrackPath> paths;
  std::vector<CrackExtent> extents;
  CrackLines lines;
  std::vector<std::vector<double>> stations;
};

// Cracks with elements in one body that has one operator: a region, or a subdomain of it. It knows the openings and the
// tractions on the faces.
class MeshedCracks {
 public:
  // Meshes the cracks. It splits nodes of the boundary's mesh at mouths, and adds to that mesh the faces of cracks that
  // separate two pieces.
  MeshedCracks(CracksToMesh cracks, BoundaryMesh& boundary, double tolerance);

  const bem::CrackMesh& elements() const { return mesh_; }
  double tolerance() const { return tolerance_; }

  const CrackLines& lines() const { return lines_; }
  // Cracks that have elements here, by their numbers in the scene.
  std::vector<int> ids() const;
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
  static std::array<Point, 3> openings_on(const bem::CrackElement& element, const bem::CrackedState& state);
  static std::array<Point, 3> openings_on(const bem::CutElement& element, const bem::CrackedState& state);
  // Fraction of the crack's original length at a place on a line. Loads refer to it, so that they stay in place when
  // the crack grows; beyond the original ends it stays 0 or 1.
  double fraction_at(int line, const Point& x) const;

  double tolerance_;
  std::vector<CrackPath> paths_;  // of all cracks in the region
  std::vector<CrackExtent> extents_;
  CrackLines lines_;
  bem::CrackMesh mesh_;
  std::vector<std::array<Point, 3>> cut_places_;  // of its elements between pieces
};

}  // namespace bempd::regions
