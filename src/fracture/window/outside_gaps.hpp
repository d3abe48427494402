#pragma once

#include <vector>

#include "coupling/condensation.hpp"

namespace bempd::fracture {

// Gaps of places that have points outside of a window, as functions of the displacements kept: of the ones nearest to
// closing or opening, as each takes half a solution. Gaps of the others are looked at in states of the whole body only.
class OutsideGaps {
 public:
  OutsideGaps() = default;
  // At the displacement and load factor at which the window is opened.
  OutsideGaps(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
              const coupling::Affine& displacement, double load_factor);

  struct Gap {
    std::size_t place;
    coupling::CondensedFunction function;

    double at(const coupling::Affine& kept, int part) const {
      return function.constant[part] + function.weights.dot(kept.col(part));
    }
  };
  const std::vector<Gap>& gaps() const { return gaps_; }
  // Of faces inside operators, all of which are open where windows are.
  const std::vector<Gap>& faces() const { return faces_; }

 private:
  void add_faces(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                 const coupling::Affine& displacement, double load_factor);

  std::vector<Gap> gaps_, faces_;
};

}  // namespace bempd::fracture
