#pragma once

#include <memory>
#include <string>
#include <vector>

#include "coupling/node_ties.hpp"
#include "coupling/operators.hpp"
#include "geometry/arrangement.hpp"
#include "regions/crack_parts.hpp"
#include "regions/region.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Scene in discretized form: regions with their nodes, and the energy terms and ties between nodes.
struct Discretization {
  double tolerance;  // distance below which places count as the same [m]
  Arrangement arrangement;
  std::vector<Point> positions;                  // places of the scene's nodes [m]
  std::vector<std::unique_ptr<Region>> regions;  // by ascending id
  coupling::Terms bonds;                         // energy terms: bonds and cell squares
  coupling::NodeTies ties;  // ties of nodes on interfaces to elements of a neighbour that do not match them
  std::vector<double> critical_stretch;  // critical stretch of each term of `bonds`
  std::vector<std::string> warnings;
  std::string gap;  // sentence about the narrowest gap between regions that nearly touch; empty if there is none
  std::vector<PartedCrack> cracks;  // divided into parts by the regions through which they run
  std::vector<int> off_rows;        // Preparation::off_rows

  const Region& region(int id) const;  // with an id that the scene has
  std::vector<coupling::DenseOperator> dense_operators() const;
  RegionStatistics statistics() const;
  // Names the regions that have any of the nodes, such as "region 2" or "regions 1 and 3".
  std::string regions_with(const std::vector<int>& nodes) const;
};

// Discretizes the scene. Throws Error (argument) if regions overlap, touch at points only, or do not match at
// interfaces. `before` is the discretization of the same scene with shorter cracks, whose unchanged parts are reused;
// null if there is none.
Discretization discretize(const scene::Scene& scene, const scene::Options& options,
                          const Discretization* before = nullptr);

}  // namespace bempd::regions
