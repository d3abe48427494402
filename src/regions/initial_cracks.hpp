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

// Initial cracks as they are cut into lattices: as described, with two exceptions. A crack through material points is
// shifted beside them. The cut of a crack that grows as a line ends where it puts the effective tip at the described
// place, and some bonds there keep a share of their stiffness.
struct LatticeCracks {
  using Ends = std::array<Point, 2>;  // of what the host has given
  std::vector<scene::Crack> cracks;
  std::vector<Ends> ends;                                        // of each crack, where they are felt
  std::vector<std::array<std::optional<double>, 2>> even_ahead;  // of their tips, as fracture::GrowingTip has it
  std::vector<pd::WeakenedTerm> weakened;
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
  std::optional<double> even_ahead;  // as fracture::GrowingTip has it
};
std::vector<StartingTip> tips_of_cracks(const scene::Scene& scene, const LatticeCracks& found,
                                        const Discretization& discretization, const scene::Options& options);

std::vector<pd::CrackLength> lengths_of(const LatticeCracks& found);

}  // namespace bempd::regions
