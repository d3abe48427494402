#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bem/crack_mesh.hpp"
#include "bem/crack_tips.hpp"
#include "geometry/crack_lines.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Extent of a piece of a crack in a region. All numbers are distances or lengths along the crack [m].
struct CrackExtent {
  double start, length;             // start of the piece; length of the whole crack
  double given_from, given_length;  // start and length of the part that the host described
};

// Crack lines (pieces into which tips, mouths and places where cracks meet divide cracks), with the ends of the
// elements on each line (`stations`), as distances along the line. The member `crack` of a line is the index of the
// line's path in `paths`.
struct CracksToMesh {
  std::vector<CrackPath> paths;
  std::vector<CrackExtent> extents;
  CrackLines lines;
  std::vector<std::vector<double>> stations;
};

// Elements on the cracks of a part of a region that has one operator (the whole region or a subdomain), with the
// openings of the cracks and the tractions on their faces.
class MeshedCracks {
 public:
  // Meshes the cracks. Nodes of the mesh `boundary` are split at mouths of cracks, and faces of cracks that separate
  // two pieces are added to that mesh.
  MeshedCracks(CracksToMesh cracks, BoundaryMesh& boundary, double tolerance);

  const bem::CrackMesh& elements() const { return mesh_; }
  double tolerance() const { return tolerance_; }

  // Ids of the cracks that have elements in the part, ascending.
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
  // empty if no load acts on the part's cracks.
  bem::FaceTraction traction(const std::vector<CrackLoad>& loads, double constant, double proportional) const;
  // Opening at a fraction of a crack's length: tangential and normal component [m].
  Point opening_at(int crack, double fraction, const bem::CrackedState& state) const;
  std::vector<CrackPicture> pictures(const bem::CrackedState& state) const;
  std::optional<Overlap> overlap(const bem::CrackedState& state) const;
  // Whether some piece of the crack has the same piece of the region on both sides, so that it separates nothing.
  bool has_inside(int crack) const;

 private:
  // Element on a crack, with its openings. It may lie inside a piece of the region or between two pieces.
  struct Opened {
    int line;
    double from, to;  // distances along its line [m]
    bem::TipEnd tip;
    std::array<Point, 3> places, openings;
  };
  std::vector<Opened> opened(const bem::CrackedState& state) const;
  static std::array<Point, 3> openings_on(const bem::CrackElement& element, const bem::CrackedState& state);
  static std::array<Point, 3> openings_on(const bem::CutElement& element, const bem::CrackedState& state);
  // Place on a crack line as a fraction of the described crack's length; 0 or 1 beyond the described ends. Loads are
  // functions of this fraction, so that they stay in place when the crack grows.
  double fraction_at(int line, const Point& x) const;

  double tolerance_;
  std::vector<CrackPath> paths_;  // paths of all cracks in the region
  std::vector<CrackExtent> extents_;
  CrackLines lines_;
  bem::CrackMesh mesh_;
  std::vector<std::array<Point, 3>> cut_places_;  // places of the nodes of elements between two pieces
};

}  // namespace bempd::regions
