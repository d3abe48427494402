#pragma once

#include <limits>

#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::crack {

// One cycle of the loads at a tip. Its equivalent factors are those of mode I in the direction in which the tip grows.
struct TipCycle {
  TipId tip;
  Point high{0, 0}, low{0, 0};     // K_I and K_II at the highest and the lowest load of the cycle [Pa m^(1/2)]
  double highest = 0, lowest = 0;  // equivalent factors there [Pa m^(1/2)]
  double critical = std::numeric_limits<double>::infinity();  // factor at which the tip breaks; infinite: unknown
  double t_stress = 0;                                        // T at the highest load, if the law asks for it [Pa]
  double length = 0;                                          // of the crack [m]
  Point place{0, 0};                                          // of the tip [m]

  double range() const { return highest - lowest; }
  double ratio() const { return lowest / highest; }  // R
};

}  // namespace bempd::crack
