#pragma once

#include <cstdint>
#include <vector>

#include "fracture/contact/crack_faces.hpp"
#include "fracture/part_holder.hpp"

namespace bempd::fracture {

// Contact of crack faces in the whole body at its load factor: finds which faces press on each other (the active set of
// constraints).
class BodyContact {
 public:
  BodyContact(coupling::EquilibriumSystem& system, const std::vector<Point>& positions, BodyState& state,
              CrackFaces& faces, BodyResponse& response, PartHolder& holder)
      : system_(system), positions_(positions), state_(state), faces_(faces), response_(response), holder_(holder) {}

  // Result of settle().
  struct Settled {
    std::int64_t switched = 0, fragments = 0;  // numbers of constraints, and of parts that lost loads which push them
    std::vector<int> held;                     // nodes of parts that could move freely
  };
  // Opens and closes constraints, with a solution after each round, until all agree with their gaps at the present load
  // factor. If a gap is zero, its sign just ahead in `direction` decides. A part that only closed faces held is held by
  // springs when the faces open.
  Settled settle(double direction);
  // Load factor up to which the last settle() is valid in a direction: the present load factor, or one slightly farther
  // if the constraints agreed with their gaps only there.
  double settled_until(double direction) const;
  // Whether constraints open or close as soon as the load factor moves in a direction.
  bool switches_at_once(double direction) const;
  // Settles constraints as they are just ahead in a direction, and moves the state's load factor there. The caller
  // restores the state afterwards.
  void look_ahead(double direction);

  // Adds the contact places of bonds that have broken since the last update, at the state's displacements.
  void update_faces() { faces_.update(state_.total_displacement, state_.faces); }
  // Adds contact places as update_faces() does, and bars places on parts that only springs hold from closing.
  void refresh_faces() {
    update_faces();
    bar_held_parts();
  }
  std::size_t changes_that_bar() const { return changes_that_bar_; }
  void bar(std::vector<char> barred, std::size_t changes);

 private:
  void bar_held_parts();
  double farther_on(double share, double direction) const;

  coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  BodyState& state_;
  CrackFaces& faces_;
  BodyResponse& response_;
  PartHolder& holder_;
  // Load factor of the state at the last settle(), and load factor (the same or slightly farther) at which gaps were
  // evaluated.
  double settled_at_ = 0, settled_farther_on_ = 0;
  std::size_t changes_that_bar_ = 0;  // number of springs and broken terms when constraints were barred
};

}  // namespace bempd::fracture
