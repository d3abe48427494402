#pragma once

#include <functional>
#include <span>
#include <vector>

#include "fracture/body_loads.hpp"
#include "fracture/body_response.hpp"
#include "fracture/contact/held_parts.hpp"
#include "fracture/freed_parts.hpp"

namespace bempd::fracture {

// Whether both displacements of a node are unknown or prescribed in the sparse system. Such nodes show how a dense body
// (boundary element region) moves; the system has eliminated the displacements of its other nodes.
bool shows_motion(const coupling::EquilibriumSystem& system, int node);

// Motions of parts that had to be held to make the equilibrium unique.
struct HeldMotions {
  std::vector<int> nodes;      // nodes that got a spring
  bool loads_lost = false;     // loads were removed because they pushed a part that moves freely
  std::int64_t fragments = 0;  // number of parts that lost their loads
};

// Holder of parts of the body that can move freely: holds them by springs, and keeps loads and fluid off them.
class PartHolder {
 public:
  PartHolder(coupling::EquilibriumSystem& system, const std::vector<Point>& positions, BodyState& state,
             const FreedPartFinder& freed_parts, BodyResponse& response, BodyLoads& loads)
      : system_(system),
        positions_(positions),
        state_(state),
        freed_parts_(freed_parts),
        response_(response),
        loads_(loads) {}

  // Solves the body's system, and holds free motions in the solution by springs at the displacement `before`.
  // `looks_free` is asked after each solution whether some motion looks free; `broken` are the terms that broke last.
  // Throws Error (unsolvable) if holding does not help.
  HeldMotions solve(std::span<const int> broken, const Eigen::VectorXd& before,
                    const std::function<bool()>& looks_free);

  HeldParts held_parts() const;
  // Excludes parts that only springs hold from the fluid in cracks, because the fluid would push such parts away if it
  // reached them later.
  void exclude_from_fluid();
  // If the fluid in cracks pushes parts that only springs hold, removes the loads of such parts and solves again.
  // Returns whether loads were removed.
  bool unload_pushed();

 private:
  coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  BodyState& state_;
  const FreedPartFinder& freed_parts_;
  BodyResponse& response_;
  BodyLoads& loads_;
};

}  // namespace bempd::fracture
