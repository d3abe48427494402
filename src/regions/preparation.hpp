#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "coupling/operators.hpp"
#include "geometry/arrangement.hpp"
#include "pd/network.hpp"
#include "regions/crack_parts.hpp"
#include "regions/node_registry.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

class Region;
class Scheme;

// Everything that regions are built from.
struct Preparation {
  const scene::Scene& scene;
  const scene::Options& options;
  const Scheme& scheme;
  const Arrangement& arrangement;
  double tolerance;                                     // distance below which places are the same
  const std::vector<std::unique_ptr<Region>>& regions;  // all of them, by ascending id
  const std::vector<PartedCrack>& cracks;               // once all regions are there
  // Regions of the same scene with shorter cracks, from which unchanged parts are taken; null if there are none.
  const std::vector<std::unique_ptr<Region>>* before;
};

// Lists of the scene to which regions add their contributions.
struct Contributions {
  NodeRegistry& registry;
  coupling::Terms& terms;
  std::vector<double>& critical_stretch;  // per term
  std::vector<std::string>& warnings;

  // Critical stretch, law and contraction of bonds of a region.
  struct Breaking {
    double limit;        // stretch
    int law;             // of `terms`
    double contraction;  // 0: compression across a bond is not counted apart
  };
  // Adds a bond between nodes of the scene, a step of the lattice apart.
  void add_bond(const pd::Bond& between_nodes, const Point& step, double spacing, const Breaking& breaking) const;
  // Adds the squares of all cells, which follow their own bonds. `node` gives the scene's node for a point of the grid,
  // `term` the scene's term for a bond. Returns RegionBonds::squares.
  std::vector<int> add_squares(const pd::CellLattice& grid, const std::vector<pd::Bond>& of_grid,
                               const PlaneElasticity& elasticity, double spacing, const std::function<int(int)>& node,
                               const std::function<int(int)>& term) const;
};

}  // namespace bempd::regions
