#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bem/crack_grading.hpp"
#include "geometry/subdomain_loops.hpp"
#include "regions/boundary/boundary_meshing.hpp"
#include "regions/boundary/meshed_cracks.hpp"

namespace bempd::regions {

// Cracks of one boundary element region: their parts in the region, and the lengths of the elements on these parts.
class RegionCracks {
 public:
  // Prepares the cracks of a region. Throws Error (argument) for cracks that the region cannot have.
  RegionCracks(const Preparation& preparation, int region);
  RegionCracks(const RegionCracks&) = delete;
  RegionCracks& operator=(const RegionCracks&) = delete;

  // Mouths: places on the region's boundary where cracks start or end.
  std::vector<Point> mouths() const;
  // Whether a mouth lies on an interface with a lattice in which the crack of the mouth continues.
  bool is_on_row(const Point& mouth) const;
  const bem::CrackSizes& sizes() const { return sizes_; }

  // Meshes all cracks of the region.
  std::unique_ptr<MeshedCracks> mesh(BoundaryMesh& boundary) const;
  // Meshes some crack lines (pieces of cracks between tips, mouths and places where cracks meet) of the region, given
  // by their numbers. `boundary` is the mesh of a subdomain.
  std::unique_ptr<MeshedCracks> mesh(const std::vector<int>& lines, BoundaryMesh& boundary) const;

  const CrackLines& lines() const { return lines_; }
  // Places of the element ends on each crack line.
  std::vector<Stations> places() const;
  double elements_on_cracks() const;
  // Whether some crack continues in another region.
  bool continue_elsewhere() const { return continue_elsewhere_; }

  // Estimated memory [B] of an operator with this number of elements on the boundary and the cracks.
  static double memory_of(double elements);
  // Throws Error (argument) if the operator on the boundary and the cracks needs more memory than the limit.
  void require_memory(const BoundaryMesh& boundary, const scene::Options& options) const;
  // Adds a warning if a narrow gap, from a crack to the boundary or to another crack, takes so many elements that
  // preparing is slow.
  void warn_of_gap(const BoundaryMesh& boundary, std::vector<std::string>& warnings) const;

  int region() const { return region_; }

 private:
  static bem::CrackGrading grading(const scene::Region& region);
  std::vector<std::vector<double>> halved_stations() const;
  std::string gap_sentence(const bem::NarrowGap& gap) const;

  int region_, halvings_;
  double tolerance_;
  std::vector<CrackPath> paths_;  // pieces of the cracks in this region
  std::vector<CrackExtent> extents_;
  std::vector<Edge> edges_;
  CrackLines lines_;
  std::vector<bem::MouthOnRow> rows_;
  bem::CrackSizes sizes_;
  std::vector<std::vector<double>> stations_;
  bool continue_elsewhere_ = false;
};

// Creates the cracks on which a region has elements; null if there are none.
std::unique_ptr<RegionCracks> cracks_of(const Preparation& preparation, int region);

// Divides boundary elements near cracks. An element length that the host has chosen becomes the largest length. On
// interfaces of two boundary element regions the cracks of both regions count, so that both get the same elements.
void refine_at_cracks(const Preparation& preparation, const RegionCracks* own, BoundaryPanels& panels);

}  // namespace bempd::regions
