#pragma once

#include <vector>

#include "model/mesh_answers.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// Errors of the vector (K_I, K_II) of a tip: the relative error of its length (`size`), and the error of its direction
// [rad].
struct TipErrors {
  crack::TipId tip;
  Point place{0, 0};
  double size = 0, turn = 0;

  double relative() const;
};

// Errors of results that come from the boundary elements, each relative to the largest result of its kind.
struct MeshErrors {
  double displacement = 0, reaction = 0, intensity = 0;
  double growth_load = 0;       // load factor of the first growth, relative to itself
  std::vector<TipErrors> tips;  // tips of cracks with boundary elements

  double largest() const;
};

MeshErrors operator*(double factor, MeshErrors errors);

// Estimated errors of the finest of at least two meshes, each with elements half as long as those of the previous mesh.
// Places closer than `tolerance` count as the same.
MeshErrors estimated(const std::vector<const MeshAnswers*>& meshes, double tolerance, const scene::Options& options);

// Estimated errors of `mesh`, from its difference from the mesh `finer` with halved elements.
MeshErrors estimated_by_finer(const MeshAnswers& finer, const MeshAnswers& mesh, double tolerance,
                              const scene::Options& options);

// Factor by which the largest error of the finest mesh falls if the elements are halved once more.
double expected_reduction(const std::vector<const MeshAnswers*>& meshes, double tolerance,
                          const scene::Options& options);

}  // namespace bempd::model
