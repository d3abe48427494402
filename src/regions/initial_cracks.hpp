#pragma once

#include <string>
#include <utility>
#include <vector>

#include "crack/tip.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Initial cracks as they are cut into lattices: as described, except that a crack through material points is shifted
// beside them. With pd.crack_tip = stated, a cut ends where it puts the effective tip at the described place, and some
// bonds ahead of it keep only a share of their stiffness.
struct LatticeCracks {
  std::vector<scene::Crack> cracks;
  std::vector<std::pair<int, double>> weakened;  // of the whole scene, and their shares
  std::vector<std::string> warnings;
};
LatticeCracks cracks_in_lattices(const scene::Scene& scene, const Discretization& discretization,
                                 const scene::Options& options);

// Numbers of the scene's bonds that the cracks cut, ascending. Throws Error (argument) for a crack that runs along a
// boundary through its points. Lattices with cell-centred points are an exception, because a crack at 45 degrees cannot
// miss these points: there they stay bonded to both faces, with a warning.
std::vector<int> bonds_cut_by_cracks(const std::vector<scene::Crack>& cracks, const Discretization& discretization,
                                     std::vector<std::string>& warnings);

// Tip of a crack that cuts bonds, inside a region in which cracks grow as lines.
struct StartingTip {
  Point place, direction;
  int region;  // id
  crack::TipId id;
};
std::vector<StartingTip> tips_of_cracks(const scene::Scene& scene, const std::vector<scene::Crack>& cracks,
                                        const Discretization& discretization, const scene::Options& options);

}  // namespace bempd::regions
