#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pd/face_places.hpp"
#include "pd/network.hpp"
#include "pd/tip_law.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Bonds of a region, and the functions by which cracks cut them.
class RegionBonds {
 public:
  virtual ~RegionBonds() = default;

  // Bonds between nodes of the region, as pairs of its own node numbers. They are consecutive in the scene, from
  // first_bond() on. Bonds between different regions are in the list of no region.
  virtual std::span<const pd::Bond> list() const = 0;
  virtual std::size_t first_bond() const = 0;
  // Numbers of the scene's energy terms (bonds and cell squares) at the region's nodes, each once, including terms that
  // connect the region to other lattices.
  virtual std::vector<int> terms() const = 0;
  // Area of the cells that belongs to each node, relative to the area of a full cell of the lattice.
  virtual std::vector<double> cell_shares() const = 0;
  // Material points that lie on a crack. A crack must not pass through material points, because these would belong to
  // neither face. Empty for lattices in which a crack may pass through them.
  virtual std::vector<Point> points_on_crack(const scene::Crack& crack) const = 0;
  // Adds to `bonds` the numbers of the scene's bonds that a crack cuts; `number` is the crack's id.
  virtual void cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
                   std::vector<std::string>& warnings) const = 0;
  // Data for cracks that grow as lines (in steps of one lattice spacing); empty if cracks in the region grow in another
  // way.
  virtual std::optional<pd::TipLaw> tip_law(const scene::Options& /*options*/) const { return std::nullopt; }
  // Lattice in which faces of cracks can press on each other; empty if contact is not possible in the region.
  virtual std::optional<pd::FaceLattice> face_lattice() const { return std::nullopt; }
};

}  // namespace bempd::regions
