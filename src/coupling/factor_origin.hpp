#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "coupling/contacts.hpp"
#include "coupling/operators.hpp"
#include "coupling/term_law.hpp"

namespace bempd::coupling {

// Columns c by which a matrix has changed at once, by plus or minus the sum of c c^T.
struct FactorChange {
  bool adds = false;
  std::vector<int> end;      // of every column, in the arrays below
  std::vector<int> unknown;  // rows of the matrix
  std::vector<double> weight;
  bool operator==(const FactorChange&) const = default;
};

// The nodes that each place of contact needs entries of a matrix between.
using PlacesMet = std::vector<std::vector<int>>;

// How a factor has come about, from which it can be made again with the same digits: those of a factor that has been
// changed differ from a fresh one's.
struct FactorOrigin {
  std::vector<StageChange> stages;    // of terms that were in other ones when it was made
  std::size_t springs = 0;            // so many of the present ones were there
  std::vector<Contact> closed;        // places of contact that pressed
  PlacesMet places;                   // entries that the matrix had room for
  std::vector<FactorChange> changes;  // since
};

// What a system's factor was made of.
struct FactorSource {
  std::vector<std::uint8_t> stages;  // of all terms
  std::vector<HoldingSpring> springs;
  std::vector<Contact> closed;
  std::vector<char> closed_faces;           // inside operators
  std::shared_ptr<const PlacesMet> places;  // null: none
  bool is_awaited = false;                  // it is to be made of that, and then changed
  std::vector<FactorChange> to_repeat;

  bool has_matrix_of(const FactorSource& other) const {
    const bool has_places = places && other.places ? *places == *other.places : places == other.places;
    return stages == other.stages && springs == other.springs && closed == other.closed &&
           closed_faces == other.closed_faces && has_places;
  }
};

}  // namespace bempd::coupling
