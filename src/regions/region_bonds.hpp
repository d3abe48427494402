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

// Bonds of a region, which cracks cut.
class RegionBonds {
 public:
  virtual ~RegionBonds() = default;

  // Bonds of the region as pairs of its own nodes, the scene's bonds from first_bond() on. Bonds of the scene across
  // interfaces belong to no region.
  virtual std::span<const pd::Bond> list() const = 0;
  virtual std::size_t first_bond() const = 0;
  // Numbers of the scene's terms at the region's nodes, each once, including those that connect it to other lattices.
  virtual std::vector<int> terms() const = 0;
  // Area of each node's cells over that of a full cell of the lattice.
  virtual std::vector<double> cell_shares() const = 0;
  // Material points on which a crack lies. It must not: they would belong to neither face.
  virtual std::vector<Point> points_on_crack(const scene::Crack& crack) const = 0;
  // Adds the scene's bonds that a crack cuts to `bonds`; `number` is the crack's id.
  virtual void cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
                   std::vector<std::string>& warnings) const = 0;
  // Data for the growth of crack lines in the region; empty if cracks cannot grow as lines in it.
  virtual std::optional<pd::TipLaw> tip_law(const scene::Options& /*options*/) const { return std::nullopt; }
  // Lattice on whose rows contact of crack faces is possible; empty if it is not.
  virtual std::optional<pd::FaceLattice> face_lattice() const { return std::nullopt; }
};

}  // namespace bempd::regions
