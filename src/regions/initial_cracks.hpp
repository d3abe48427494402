#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "crack/tip.hpp"
#include "pd/tip_law.hpp"
#include "pd/weakened_term.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Initial cracks with the cuts that they make through the bonds of lattices. A cut follows the described crack, with
// two exceptions. A crack through material points is shifted beside these points. If the crack grows as a line (in
// steps of one lattice spacing), the cut ends where it puts the effective tip at the crack's described end, and some
// bonds there keep a share of their stiffness.
struct LatticeCracks {
  using Ends = std::array<Point, 2>;  // first and last point of the part that the host described
  std::vector<scene::Crack> cracks;
  std::vector<Ends> ends;                                        // places of the effective tips of each crack
  std::vector<std::array<std::optional<double>, 2>> even_ahead;  // GrowingTip::even_ahead of each end [m]
  std::vector<pd::WeakenedTerm> weakened;
  std::vector<std::string> warnings;
};
LatticeCracks cracks_in_lattices(const scene::Scene& scene, const Discretization& discretization,
                                 const scene::Options& options);

// Numbers of the scene's bonds that the cracks cut, ascending. Throws Error (argument) for a crack that runs along a
// boundary and through the material points on it. In lattices with cell-centred points a crack at 45 degrees cannot
// miss the points; such points stay bonded to both faces of the crack, and a warning is added.
std::vector<int> bonds_cut_by_cracks(const std::vector<scene::Crack>& cracks, const Discretization& discretization,
                                     std::vector<std::string>& warnings);

// Tip of a crack that cuts bonds, in a region in which cracks grow as lines (in steps of one lattice spacing).
struct StartingTip {
  Point place, direction;
  int region;  // id of the region
  crack::TipId id;
  std::optional<double> even_ahead;  // GrowingTip::even_ahead [m]
};
std::vector<StartingTip> tips_of_cracks(const scene::Scene& scene, const LatticeCracks& found,
                                        const Discretization& discretization, const scene::Options& options);

// Length of each crack between its described ends, and distances from these ends to the ends of its cut.
std::vector<pd::CrackLength> lengths_of(const LatticeCracks& found);

}  // namespace bempd::regions
