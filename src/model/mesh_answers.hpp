#pragma once

#include <Eigen/Core>
#include <set>
#include <vector>

#include "model/prepared_scene.hpp"
#include "regions/tip_values.hpp"

namespace bempd::model {

// Load factor at which a tip grows; infinite if it never does.
struct TipLoad {
  crack::TipId tip;
  double load_factor;
};

// Load factors of growth of all tips that may grow, in elements and in lattices, of a body in equilibrium. The body's
// own load factor 0 stands for the load factor `shift` (scene::moved()).
std::vector<TipLoad> growth_loads(const PreparedScene& scene, const std::vector<regions::TipValues>& tips,
                                  const std::set<crack::TipId>& frozen, double shift);
// The lowest load of some cracks (ids); NaN if none of them is there.
double first_load(const std::vector<TipLoad>& loads, const std::vector<int>& cracks);

// Results of a scene with one mesh, to compare with those of another mesh.
struct MeshAnswers {
  std::vector<Point> places;  // of nodes, ascending by x, then y; places with two nodes (crack faces) are left out
  std::vector<Eigen::Vector2d> displacements;
  std::vector<Eigen::Vector2d> reactions;
  bool supports_share = false;           // forces of nodes that several of them hold
  double carried = 0;                    // half the sum of the magnitudes of reactions and nodal loads [N]
  std::vector<regions::TipValues> tips;  // with boundary elements
  std::vector<TipLoad> loads;
  double growth_load = 0;  // load factor of the first growth; infinite if no tip grows
  crack::TipId first;      // tip that grows then
};

// Reads the results of a body in equilibrium, with its tips there.
MeshAnswers read_answers(const PreparedScene& scene, std::size_t supports, std::vector<regions::TipValues> tips,
                         std::vector<TipLoad> loads);

}  // namespace bempd::model
