#pragma once

#include <cmath>
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

// Data that regions are built from.
struct Preparation {
  const scene::Scene& scene;
  const scene::Options& options;
  const Scheme& scheme;
  const Arrangement& arrangement;
  double tolerance;                                     // distance below which places are the same
  const std::vector<std::unique_ptr<Region>>& regions;  // all of them, by ascending id
  const std::vector<PartedCrack>& cracks;               // once all regions are there
  // Regions of the same scene with shorter cracks, whose unchanged operators are reused; null if there are none.
  const std::vector<std::unique_ptr<Region>>* before;
  const std::vector<PartedCrack>* cracks_before;  // likewise
};

// Lists of the scene to which regions add their nodes, terms and warnings.
struct Contributions {
  NodeRegistry& registry;
  coupling::Terms& terms;
  std::vector<double>& critical_stretch;  // per term
  std::vector<std::string>& warnings;

  // Breaking behaviour of a region's bonds: critical stretch, bond law, and contraction.
  struct Breaking {
    double limit;        // stretch
    int law;             // of `terms`
    double contraction;  // 0: compression across a bond is not counted apart

    // Breaking behaviour of a bond between two nodes. `energy_shares` are the nodes' shares of the material's fracture
    // energy; if empty, the bond has all of it.
    Breaking between(const std::vector<double>& energy_shares, int first, int second) const {
      if (energy_shares.empty()) return *this;
      const double at_first = energy_shares[static_cast<std::size_t>(first)];
      const double at_second = energy_shares[static_cast<std::size_t>(second)];
      return {limit * std::sqrt((at_first + at_second) / 2), law, contraction};
    }
  };
  // Adds a bond between two nodes of the scene. `step` is the vector from one to the other in spacings, `spacing` [m].
  void add_bond(const pd::Bond& between_nodes, const Point& step, double spacing, const Breaking& breaking) const;
  // Adds the squares of all cells: terms of four nodes whose energy is the square of a combination of the corners'
  // displacements. A square breaks with any bond of its cell. `node` maps points of the grid to the scene's nodes,
  // `term` maps bonds of the grid to the scene's terms. Returns SceneBonds::squares.
  std::vector<int> add_squares(const pd::CellLattice& grid, const std::vector<pd::Bond>& of_grid,
                               const PlaneElasticity& elasticity, double spacing, const std::function<int(int)>& node,
                               const std::function<int(int)>& term) const;
};

}  // namespace bempd::regions
