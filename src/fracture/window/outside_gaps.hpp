#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"

namespace bempd::fracture {

// Gaps as functions of the displacements that a window keeps; each takes the part of half a solution that its points
// reach.
struct CondensedGaps {
  std::vector<std::size_t> places;  // by their numbers in the system
  Eigen::MatrixXd weights;          // of kept displacements, one column a place
  coupling::Affine constant;        // one row a place

  // One row a place, one column a state; `part`: of the load.
  Eigen::MatrixXd at(std::span<const coupling::Affine> kept, int part) const;
  // `weights_of(place)`: of all displacements.
  void condense(const coupling::Condensation& condensation,
                const std::function<Eigen::VectorXd(std::size_t)>& weights_of);
};

// Of all places that have points outside of a window, and of the faces inside operators, all of which are open where
// windows are.
class OutsideGaps {
 public:
  OutsideGaps() = default;
  OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation);

  const CondensedGaps& places() const { return places_; }
  const CondensedGaps& faces() const { return faces_; }

 private:
  CondensedGaps places_, faces_;
};

}  // namespace bempd::fracture
