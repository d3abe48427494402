#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/terms.hpp"
#include "geometry/arrangement.hpp"
#include "pd/network.hpp"
#include "regions/crack_parts.hpp"
#include "regions/node_registry.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

class Region;
class Scheme;

// Data that regions are built from.
struct Preparation {
  const scene::Scene& scene;
  const scene::Options& options;
  const Scheme& scheme;
  const Arrangement& arrangement;
  double tolerance;                                     // distance below which places count as the same [m]
  const std::vector<std::unique_ptr<Region>>& regions;  // all of them, by ascending id
  const std::vector<PartedCrack>& cracks;               // divided into parts once all regions exist
  // Ids (ascending) of regions whose outlines follow lattice rows, but whose material points lie on their outlines,
  // because they are one body with a region whose outline follows no lattice rows.
  const std::vector<int>& off_rows;
  // Regions of the same scene with shorter cracks, whose unchanged operators are reused; null if there are none.
  const std::vector<std::unique_ptr<Region>>* before;
  const std::vector<PartedCrack>* cracks_before;  // the cracks before they grew; null if there are none

  bool leaves_rows(int region) const { return std::binary_search(off_rows.begin(), off_rows.end(), region); }
  // Grid of the nodes of a region (id) as it is built; empty if the nodes lie on no grid.
  std::optional<scene::NodeGrid> node_grid(int region) const {
    return leaves_rows(region) ? std::nullopt : scene.region(region).node_grid();
  }
};

// Lists of the scene to which regions add their nodes, energy terms (bonds and cell squares) and warnings.
struct Contributions {
  NodeRegistry& registry;
  coupling::Terms& terms;
  std::vector<double>& critical_stretch;  // critical stretch of each term
  std::vector<std::string>& warnings;

  // Breaking behaviour of a region's bonds: critical stretch, bond law, and contraction.
  struct Breaking {
    double limit;        // stretch
    int law;             // number of the bond law in `terms`
    double contraction;  // Poisson's ratio for the effect of compression across a bond; 0: not corrected

    // Breaking behaviour of a bond between two points. `energy_shares` has the fracture energy at each point, relative
    // to that of the material; if the list is empty, the fracture energy is the material's everywhere.
    Breaking between(const std::vector<double>& energy_shares, int first, int second) const {
      if (energy_shares.empty()) return *this;
      const double at_first = energy_shares[static_cast<std::size_t>(first)];
      const double at_second = energy_shares[static_cast<std::size_t>(second)];
      return {limit * std::sqrt((at_first + at_second) / 2), law, contraction};
    }
  };
  // Adds a bond between two nodes of the scene. `step` is the vector from the bond's first node to its second in
  // spacings, `spacing` is the spacing [m].
  void add_bond(const pd::Bond& between_nodes, const Point& step, double spacing, const Breaking& breaking) const;
  // Adds the cell squares of all cells: energy terms of four nodes, whose energy is the square of a linear combination
  // of the displacements at the cell's corners. A cell square breaks with the first bond of its cell. `node` maps
  // points of the grid to the scene's nodes, `term` maps bonds of the grid to the scene's terms. Returns
  // SceneBonds::squares.
  std::vector<int> add_squares(const pd::CellLattice& grid, const std::vector<pd::Bond>& of_grid,
                               const PlaneElasticity& elasticity, double spacing, const std::function<int(int)>& node,
                               const std::function<int(int)>& term) const;
};

}  // namespace bempd::regions
