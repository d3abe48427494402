#pragma once

#include <Eigen/Core>
#include <set>
#include <vector>

#include "model/prepared_scene.hpp"
#include "regions/tip_values.hpp"

namespace bempd::model {

// Errors of results that come from the boundary elements, each relative to the largest result of its kind.
struct MeshErrors {
  double displacement = 0, reaction = 0, intensity = 0;
  double growth_load = 0;  // load factor of the first growth, relative to itself

  double largest() const;
};

// Load factor at which a tip grows; infinite if it never does.
struct TipLoad {
  crack::TipId tip;
  double load_factor;
};

// Loads of all tips that may grow, in elements and in lattices, of a body in equilibrium. `shift` is the load factor at
// which its loads act, where that counts as 0.
std::vector<TipLoad> growth_loads(const PreparedScene& scene, const std::vector<regions::TipValues>& tips,
                                  const std::set<crack::TipId>& frozen, double shift);
// The lowest load of some cracks (ids); NaN if none of them is there.
double first_load(const std::vector<TipLoad>& loads, const std::vector<int>& cracks);

// Results of a scene with one mesh, to compare with those of another mesh.
struct MeshAnswers {
  std::vector<Point> places;  // of nodes, ascending by x, then y; places with two nodes (crack faces) are left out
  std::vector<Eigen::Vector2d> displacements;
  std::vector<Eigen::Vector2d> reactions;
  std::vector<regions::TipValues> tips;  // with boundary elements
  std::vector<TipLoad> loads;
  double growth_load = 0;  // load factor of the first growth; infinite if no tip grows
  crack::TipId first;      // tip that grows then
};

// Reads the results of a body in equilibrium, with its tips there.
MeshAnswers read_answers(const PreparedScene& scene, std::size_t supports, std::vector<regions::TipValues> tips,
                         std::vector<TipLoad> loads);

// Differences of results between a mesh and a coarser one.
MeshErrors difference(const MeshAnswers& fine, const MeshAnswers& coarse, double tolerance);

MeshErrors operator*(double factor, MeshErrors errors);

// Estimated errors of the finest mesh, from the differences of successive meshes, the last of which is that of the
// finest; each mesh has elements half as long as those of the one before.
MeshErrors estimated(const std::vector<MeshErrors>& differences);

// Factor by which the largest error falls with the next halving, from the same differences.
double expected_reduction(const std::vector<MeshErrors>& differences);

}  // namespace bempd::model
