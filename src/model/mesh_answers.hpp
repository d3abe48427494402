#pragma once

#include <Eigen/Core>
#include <set>
#include <vector>

#include "model/prepared_scene.hpp"
#include "regions/tip_values.hpp"

namespace bempd::model {

// Load factor at which a tip grows; infinite if the tip never grows.
struct TipLoad {
  crack::TipId tip;
  double load_factor;
};

// Load factors at which the tips of a body in equilibrium grow, in elements and in lattices; infinite for the tips
// `frozen`. The load factor 0 of this body stands for the load factor `shift` (scene::moved()).
std::vector<TipLoad> growth_loads(const PreparedScene& scene, const std::vector<regions::TipValues>& tips,
                                  const std::set<crack::TipId>& frozen, double shift);
// Smallest load factor at which a tip of some cracks (ids) grows; NaN if none of these cracks has a tip.
double first_load(const std::vector<TipLoad>& loads, const std::vector<int>& cracks);

// Results of a scene with one mesh, to compare with those of another mesh.
struct MeshAnswers {
  // Places of nodes, ascending by x, then y; places with two nodes (crack faces) are left out.
  std::vector<Point> places;
  std::vector<Eigen::Vector2d> displacements;
  std::vector<Eigen::Vector2d> reactions;
  bool supports_share = false;           // whether several supports hold the same node
  double carried = 0;                    // half the sum of the magnitudes of reactions and nodal loads [N]
  std::vector<regions::TipValues> tips;  // tips of cracks with boundary elements
  std::vector<TipLoad> loads;
  double growth_load = 0;  // load factor of the first growth; infinite if no tip grows
  crack::TipId first;      // tip that grows first
};

// Reads the results of a body in equilibrium. `supports` is the number of supports; `tips` and `loads` are those of the
// same body.
MeshAnswers read_answers(const PreparedScene& scene, std::size_t supports, std::vector<regions::TipValues> tips,
                         std::vector<TipLoad> loads);

}  // namespace bempd::model
