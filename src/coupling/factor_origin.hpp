#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "coupling/constraints.hpp"
#include "coupling/operators.hpp"
#include "coupling/term_law.hpp"

namespace bempd::coupling {

// Change of a matrix by the sum of c c^T over sparse columns c, which is added or subtracted.
struct FactorChange {
  bool adds = false;
  std::vector<int> end;      // end of each column in the arrays below
  std::vector<int> unknown;  // row (unknown) of each entry
  std::vector<double> weight;
  bool operator==(const FactorChange&) const = default;
};

// Nodes between which constraints with a penalty need entries of the matrix: one list of nodes per constraint.
using PlacesMet = std::vector<std::vector<int>>;

// Record of how a factor was made, from which it can be made again with the same digits. (A factor that was changed
// differs by rounding from a fresh factor of the same matrix.)
struct FactorOrigin {
  std::vector<StageChange> stages;    // stages of terms at that time, if different now
  std::size_t springs = 0;            // number of the present springs that already existed
  std::vector<Constraint> closed;     // constraints with a penalty that were closed
  PlacesMet places;                   // entries for constraints in the matrix
  std::vector<FactorChange> changes;  // changes of the factor since it was made
};

// State of a system from which its factor was made.
struct FactorSource {
  std::vector<std::uint8_t> stages;  // stages of all terms
  std::vector<HoldingSpring> springs;
  std::vector<Constraint> closed;           // closed constraints with a penalty
  std::vector<char> closed_exact;           // flags of the exact constraints
  std::shared_ptr<const PlacesMet> places;  // null: none
  bool is_awaited = false;                  // the factor is not yet made and changed by `to_repeat`
  std::vector<FactorChange> to_repeat;

  static FactorSource of(const std::vector<std::uint8_t>& stages, const std::vector<HoldingSpring>& springs,
                         const Constraints& constraints, const std::shared_ptr<const PlacesMet>& places) {
    FactorSource source{stages, springs, {}, constraints.closed_exact(), places, false, {}};
    constraints.for_each_closed_penalty([&](const Constraint& one) { source.closed.push_back(one); });
    return source;
  }

  bool has_matrix_of(const FactorSource& other) const {
    const bool has_places = places && other.places ? *places == *other.places : places == other.places;
    return stages == other.stages && springs == other.springs && closed == other.closed &&
           closed_exact == other.closed_exact && has_places;
  }
};

}  // namespace bempd::coupling
