#pragma once

#include <vector>

namespace bempd::pd {

// What the growth of a crack as a line asks of the lattice and the material around its tip.
struct TipLaw {
  double spacing = 0;    // [m]
  double horizon = 0;    // [m]
  double thickness = 1;  // [m]
  double modulus = 0;    // E, in plane strain E / (1 - nu^2) [Pa]
  double toughness = 0;  // [Pa m^(1/2)]; infinite for a material that does not break
  int crack = 0;         // id of the one whose tip it is
};

// Those of the tips that there are at first, and after them one for every region in which further cracks may begin.
struct TipLaws {
  std::vector<TipLaw> laws;
  std::vector<int> of_node;  // law of its region; -1 where none can begin
};

}  // namespace bempd::pd
