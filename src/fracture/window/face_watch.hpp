#pragma once

#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include "coupling/contacts.hpp"

namespace bempd::fracture {

struct ForeseenEvent;
class CrackFaces;

// The gaps of the faces of cracks in the states that a window goes through. A window knows closed places as stiffness
// and open ones not at all: what it has computed counts as long as none closes or opens.
class FaceWatch {
 public:
  // Nothing to watch.
  FaceWatch() = default;
  // Places that there are, and those that events make.
  FaceWatch(const coupling::Contacts& places, const CrackFaces& faces, const std::vector<ForeseenEvent>& events,
            double from, bool proportional);

  bool is_idle() const { return places_.empty(); }

  // Whether all places are in a state as they were at first, at the load factors from the event that led there to the
  // one that follows; `constant(dof)` and `proportional(dof)` are its displacements, the largest of which are given.
  template <class Part>
  bool holds(int state, const Part& constant, const Part& proportional, const std::array<double, 2>& largest) const {
    for (const double load_factor : load_factors_[static_cast<std::size_t>(state)]) {
      const double zero = rounding(largest[0] + std::abs(load_factor) * largest[1]);
      for (const Place& place : places_) {
        if (place.since > state) continue;
        double gap = 0;
        for (const coupling::TermEntry& e : place.contact.pull) {
          gap += e.x * (constant(2 * e.node) + load_factor * proportional(2 * e.node)) +
                 e.y * (constant(2 * e.node + 1) + load_factor * proportional(2 * e.node + 1));
        }
        if (place.closed ? gap > zero : gap < -zero) return false;
      }
    }
    return true;
  }

 private:
  static double rounding(double largest);

  struct Place {
    coupling::Contact contact;
    bool closed;
    int since;  // the first state in which it is there
  };
  std::vector<Place> places_;
  std::vector<std::array<double, 2>> load_factors_;  // of every state
};

}  // namespace bempd::fracture
