#pragma once

#include <string>
#include <utility>
#include <vector>

#include "crack/tip.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// The scene's cracks as they are in lattices: as described, but for those through material points, which pass them by;
// with pd.crack_tip = stated, they end so that their tips are felt at the described places. There some bonds have a
// share of their stiffness only.
struct LatticeCracks {
  std::vector<scene::Crack> cracks;
  std::vector<std::pair<int, double>> weakened;  // of the whole scene, and their shares
  std::vector<std::string> warnings;
};
LatticeCracks cracks_in_lattices(const scene::Scene& scene, const Discretization& discretization,
                                 const scene::Options& options);

// Bonds (of the whole scene) cut by them, ascending. Throws Error (argument) for one that runs along a boundary through
// its points, but for cell-centred points, which a crack at 45 degrees cannot miss: there the points stay bonded
// to both faces, with a warning.
std::vector<int> bonds_cut_by_cracks(const std::vector<scene::Crack>& cracks, const Discretization& discretization,
                                     std::vector<std::string>& warnings);

// Where cracks that cut bonds end inside a region in which they grow as lines.
struct StartingTip {
  Point place, direction;
  int region;  // id
  crack::TipId id;
};
std::vector<StartingTip> tips_of_cracks(const scene::Scene& scene, const std::vector<scene::Crack>& cracks,
                                        const Discretization& discretization, const scene::Options& options);

}  // namespace bempd::regions
