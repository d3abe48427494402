#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "coupling/affine.hpp"
#include "fracture/contact/crack_faces.hpp"
#include "fracture/window/outside_gaps.hpp"

namespace bempd::fracture {

struct ForeseenEvent;

// The gaps of the faces of cracks in the states that a window goes through. A window knows closed places as stiffness
// and open ones not at all: what it has computed counts as long as none closes or opens.
class FaceWatch {
 public:
  // Nothing to watch.
  FaceWatch() = default;
  // All places in the states after 0, 1, ... of the events, the first at the load factor `from`.
  FaceWatch(CrackFaces& faces, const std::vector<ForeseenEvent>& events, double from, bool proportional);

  bool is_idle() const { return places_.empty(); }

  // How many of the events come before places open or close whose points are all among the degrees of freedom kept or
  // prescribed, or whose gaps are known as functions of those; and before one that makes a place with other points.
  int events_before_change(const std::vector<coupling::Affine>& kept, const std::vector<int>& dofs,
                           const coupling::EquilibriumSystem& system, const OutsideGaps& outside) const;

  // Whether all places are in a state as they were at first, at the load factors from the event that led there to the
  // one that follows; `constant(dof)` and `proportional(dof)` are its displacements, the largest of which are given.
  template <class Part>
  bool holds(int state, const Part& constant, const Part& proportional, const std::array<double, 2>& largest) const {
    for (const WatchedPlace& place : places_)
      if (!holds(place, state, constant, proportional, largest)) return false;
    return true;
  }

 private:
  template <class Part>
  bool holds(const WatchedPlace& place, int state, const Part& constant, const Part& proportional,
             const std::array<double, 2>& largest) const {
    if (state < place.since || state >= place.until) return true;
    double gap = 0, rate = 0;
    for (const coupling::TermEntry& e : place.contact.pull) {
      gap += e.x * constant(2 * e.node) + e.y * constant(2 * e.node + 1);
      rate += e.x * proportional(2 * e.node) + e.y * proportional(2 * e.node + 1);
    }
    return holds(place, state, gap, rate, largest);
  }
  bool holds(const WatchedPlace& place, int state, double gap, double rate, const std::array<double, 2>& largest) const;
  // Of an open face inside an operator.
  bool overlaps(int state, double gap, double rate, const std::array<double, 2>& largest) const;

  std::vector<WatchedPlace> places_;
  std::vector<std::array<double, 2>> load_factors_;  // of every state
};

}  // namespace bempd::fracture
