#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/condensation.hpp"

namespace bempd::fracture {

// Gaps of all places that have points outside of a window, as functions of the displacements kept; each takes the part
// of half a solution that its points reach.
class OutsideGaps {
 public:
  OutsideGaps() = default;
  OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation);

  const std::vector<std::size_t>& places() const { return places_; }  // by their numbers in the system
  // One row a place, one column a state; `part`: of the load.
  Eigen::MatrixXd at(std::span<const coupling::Affine> kept, int part) const;

  struct Gap {
    coupling::CondensedFunction function;

    double at(const coupling::Affine& kept, int part) const {
      return function.constant[part] + function.weights.dot(kept.col(part));
    }
  };
  // Gaps of faces inside operators, all of which are open where windows are.
  const std::vector<Gap>& faces() const { return faces_; }

 private:
  void add_faces(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation);

  std::vector<std::size_t> places_;
  Eigen::MatrixXd weights_;    // of kept displacements, one column a place
  coupling::Affine constant_;  // one row a place
  std::vector<Gap> faces_;
};

}  // namespace bempd::fracture
