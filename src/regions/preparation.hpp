#pragma once

#include <memory>
#include <string>
#include <vector>

#include "coupling/operators.hpp"
#include "geometry/arrangement.hpp"
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
  const std::vector<int>& crack_regions;  // per crack: the region that has elements on it; 0: it cuts bonds
};

// What they add to.
struct Contributions {
  NodeRegistry& registry;
  coupling::BondSet& bonds;
  std::vector<double>& critical_stretch;  // per bond
  std::vector<std::string>& warnings;
};

}  // namespace bempd::regions
