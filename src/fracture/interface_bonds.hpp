#pragma once

#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"

namespace bempd::fracture {

// The shortest bonds of nodes that a body which cannot break shares: once one of them breaks a crack has reached that
// body, and can only run along it.
class InterfaceBonds {
 public:
  // Finds the bonds that are there now.
  InterfaceBonds(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions);

  // Node of the body at which one of them has broken since.
  std::optional<int> reached() const;

 private:
  struct Bond {
    int term, node;
  };
  const coupling::EquilibriumSystem& system_;
  std::vector<Bond> bonds_;
};

}  // namespace bempd::fracture
