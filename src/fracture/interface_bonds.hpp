#pragma once

#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"

namespace bempd::fracture {

// Shortest bonds at nodes of bodies that cannot break. Once one of them breaks, a crack has reached the body and can
// only run along it.
class InterfaceBonds {
 public:
  // Collects the bonds that are intact now.
  InterfaceBonds(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions);

  // Node of such a body at which one of the collected bonds has broken since; empty if there is none.
  std::optional<int> reached() const;

 private:
  struct Bond {
    int term, node;
  };
  const coupling::EquilibriumSystem& system_;
  std::vector<Bond> bonds_;
};

}  // namespace bempd::fracture
