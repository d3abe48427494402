#pragma once

#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"

namespace bempd::fracture {

// Shortest bonds at the nodes of bodies that cannot break (boundary element regions). If such a bond has broken, a
// crack has reached the body and can only run along its border.
class InterfaceBonds {
 public:
  // Collects the shortest bonds that are intact at present.
  InterfaceBonds(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions);

  // Node of a body that cannot break at which a collected bond has broken; empty if none has.
  std::optional<int> reached() const;

 private:
  struct Bond {
    int term, node;
  };
  const coupling::EquilibriumSystem& system_;
  std::vector<Bond> bonds_;
};

}  // namespace bempd::fracture
