#pragma once

#include <limits>

#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::crack {

// One load cycle at a tip. Equivalent factors are stress intensity factors of mode I in the direction of the tip's
// growth.
struct TipCycle {
  TipId tip;
  Point high{0, 0}, low{0, 0};     // K_I and K_II at the highest and the lowest load of the cycle [Pa m^(1/2)]
  double highest = 0, lowest = 0;  // equivalent factors at these loads [Pa m^(1/2)]
  // Equivalent factor at which the tip breaks; infinite: unknown.
  double critical = std::numeric_limits<double>::infinity();
  double t_stress = 0;  // T-stress at the highest load, if the law needs it [Pa]
  double length = 0;    // length of the crack [m]
  Point place{0, 0};    // place of the tip [m]

  double range() const { return highest - lowest; }
  double ratio() const { return lowest / highest; }  // load ratio R
};

}  // namespace bempd::crack
