#pragma once

#include <string>
#include <utility>
#include <vector>

#include "crack/tip.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Cracks of the scene as they are in lattices. They are as described, except that a crack through material points is
// shifted beside them; with pd.crack_tip = stated, cracks end so that their effective tips are at the described places.
// There some bonds keep a share of their stiffness.
struct LatticeCracks {
  std::vector<scene::Crack> cracks;
  std::vector<std::pair<int, double>> weakened;  // of the whole scene, and their shares
  std::vector<std::string> warnings;
};
LatticeCracks cracks_in_lattices(const scene::Scene& scene, const Discretization& discretization,
                                 const scene::Options& options);

// Bonds (of the whole scene) cut by the cracks, ascending. Throws Error (argument) for a crack that runs along a
// boundary through its points. Cell-centred points are an exception, because a crack at 45 degrees cannot miss them:
// there the points stay bonded to both faces, with a warning.
std::vector<int> bonds_cut_by_cracks(const std::vector<scene::Crack>& cracks, const Discretization& discretization,
                                     std::vector<std::string>& warnings);

// End of a crack that cuts bonds, inside a region in which cracks grow as lines.
struct StartingTip {
  Point place, direction;
  int region;  // id
  crack::TipId id;
};
std::vector<StartingTip> tips_of_cracks(const scene::Scene& scene, const std::vector<scene::Crack>& cracks,
                                        const Discretization& discretization, const scene::Options& options);

}  // namespace bempd::regions
