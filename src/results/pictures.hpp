#pragma once

#include <string>
#include <vector>

#include "output/vtu.hpp"
#include "results/point_values.hpp"

namespace bempd::results {

// Crack faces and tips that a snapshot shows.
struct CracksShown {
  std::vector<regions::CrackPicture> faces;
  std::vector<regions::TipValues> tips;
};

// Part of a snapshot, which is written to a file of its own. Viewers show parts in the order of their numbers.
struct PicturePart {
  int number;
  std::string name;
  output::VtuGrid grid;
};

// Makes the parts of a snapshot of the body under one solution: its regions by kind, the inside of boundary element
// regions, and its cracks. The inside is shown on triangles whose sides are the square root of the region's area over
// `inside_divisions`; 0: the inside is not shown.
std::vector<PicturePart> pictures(const scene::Scene& scene, const regions::Discretization& discretization,
                                  const regions::Solution& solution, const FieldsOfScene& fields,
                                  const CracksShown& cracks, double inside_divisions);

}  // namespace bempd::results
