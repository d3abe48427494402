#pragma once

#include <memory>

#include "crack/laws/host_resistance.hpp"
#include "crack/laws/resistance_curve.hpp"
#include "crack/laws/resistance_directions.hpp"

namespace bempd::crack {

// Rules by which the fracture energy at a tip differs from the constant value of its material; a null pointer is a rule
// that is not used.
struct Resistance {
  std::shared_ptr<const ResistanceCurve> curve;
  std::shared_ptr<const ResistanceDirections> directions;
  std::shared_ptr<const HostResistance> function;  // replaces the material's number and both tables

  bool is_constant() const { return !curve && !directions && !function; }
  bool operator==(const Resistance& other) const {
    return are_same(curve.get(), other.curve.get()) && are_same(directions.get(), other.directions.get()) &&
           function == other.function;
  }

 private:
  template <class Table>
  static bool are_same(const Table* one, const Table* other) {
    return one == other || (one && other && *one == *other);
  }
};

}  // namespace bempd::crack
