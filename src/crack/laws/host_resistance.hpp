#pragma once

#include <functional>

#include "crack/laws/tip_cycle.hpp"

namespace bempd::crack {

// Fracture energy at a tip [J/m^2], given by a function of the host.
class HostResistance {
 public:
  // Function of the host, which receives a constant load as a cycle whose two loads are equal. The cycle's `length` is
  // the length by which the tip has grown [m].
  using Function = std::function<double(const TipCycle&)>;

  explicit HostResistance(Function function) : function_(std::move(function)) {}

  // Fracture energy that the function gives [J/m^2]. Throws Error (argument) if it is not a finite number > 0.
  double energy(const TipCycle& held) const;

 private:
  Function function_;
};

// Tip, with the data that the host's function for the fracture energy receives. If `function` is null, the fracture
// energy is the number given for the material.
struct AskingTip {
  const HostResistance* function = nullptr;
  TipId id{};
  Point place{0, 0};
  double grown = 0;      // growth of the tip in the model [m]
  Point t_stress{0, 0};  // constant and proportional part of the T-stress [Pa]
};

}  // namespace bempd::crack
