#pragma once

#include <functional>

#include "crack/laws/tip_cycle.hpp"

namespace bempd::crack {

// Fracture energy that a tip meets, by a function of the host [J/m^2].
class HostResistance {
 public:
  // Function of the host, which is told of a held load as a cycle with equal factors at its two ends. The cycle's
  // length is that by which the tip has grown.
  using Function = std::function<double(const TipCycle&)>;

  explicit HostResistance(Function function) : function_(std::move(function)) {}

  // Throws Error (argument) if the function gives no fracture energy.
  double energy(const TipCycle& held) const;

 private:
  Function function_;
};

// Tip, with all that the host's function for its fracture energy is told about it. Where the function is null, the
// fracture energy is the number given for the material.
struct AskingTip {
  const HostResistance* function = nullptr;
  TipId id{};
  Point place{0, 0};
  double grown = 0;      // in the model [m]
  Point t_stress{0, 0};  // constant and proportional part of T [Pa]
};

}  // namespace bempd::crack
