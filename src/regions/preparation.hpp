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

// What regions are built from.
struct Preparation {
  const scene::Scene& scene;
  const scene::Options& options;
  const Scheme& scheme;
  const Arrangement& arrangement;
  double tolerance;                                     // distance below which places are the same
  const std::vector<std::unique_ptr<Region>>& regions;  // all of them, by ascending id
  const std::vector<PartedCrack>& cracks;               // once all regions are there
  // Those of the same scene with shorter cracks, of which what has not changed is taken over; null if there are none.
  const std::vector<std::unique_ptr<Region>>* before;
};

// What they add to.
struct Contributions {
  NodeRegistry& registry;
  coupling::Terms& bonds;
  std::vector<double>& critical_stretch;  // per term
  std::vector<std::string>& warnings;

  // What bonds of a region break by.
  struct Breaking {
    double limit;        // stretch
    int law;             // of `bonds`
    double contraction;  // 0: compression across a bond is not counted apart
  };
  // Adds one between nodes of the scene, a step of the lattice apart.
  void add_bond(const pd::Bond& between_nodes, const Point& step, double spacing, const Breaking& breaking) const;
  // Adds the squares of all cells, which follow their own bonds; `node` gives those of the scene for points of the
  // grid, `term` those of it for bonds. Returns RegionBonds::squares.
  std::vector<int> add_squares(const pd::CellLattice& grid, const std::vector<pd::Bond>& of_grid,
                               const PlaneElasticity& elasticity, double spacing, const std::function<int(int)>& node,
                               const std::function<int(int)>& term) const;
};

}  // namespace bempd::regions
