#pragma once

#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

#include "fracture/contact/crack_faces.hpp"

namespace bempd::fracture {

// Contact constraint that is closed or open in some of the states that a window (region around crack tips that is
// solved alone) computes: from the state `since` to the state before `until`. State n is the state after n events.
struct WatchedConstraint {
  coupling::Constraint constraint;
  bool closed;
  bool known;  // whether the body has this constraint in state 0
  int since, until;
  std::size_t number;  // number in the system's list, continued for places to come
  int event;           // number of the event that gave it this status or normal
};

// Contact constraints in the states that a window computes ahead (state 0 is the present one), by the rule of
// CrackFaces::follow(). The constraints of the body itself stay unchanged.
class FaceForecast final : public FacePlaces {
 public:
  FaceForecast(CrackFaces& faces, const FaceState& state);
  ~FaceForecast() override;

  // Adds the contact places of terms that the event leading to `state` breaks, and renews the normals of open places
  // near them.
  void follow(std::span<const int> broken, int state);
  // Closes or opens the constraint with the index `watched` in constraints(), in `state` and later states.
  void switch_constraint(std::size_t watched, int state);
  // Forgets the states after `state`. Only constraints() may be called afterwards.
  void forget_after(int state);

  // Contact constraints in all states, each with the range of states in which it has its status and normal. The
  // constraints of the system come first, in the order of its list.
  const std::vector<WatchedConstraint>& constraints() const { return watched_; }
  // Indices in constraints() of those that are valid in the last state and are not barred from closing.
  std::vector<std::size_t> last() const;
  FaceState last_state() const;

  std::optional<std::size_t> place_of(int term) const override;
  bool is_closed(std::size_t place) const override { return watched_[latest_[place]].closed; }
  void add(const GrownFace& face, coupling::Constraint constraint) override;
  void renew(std::size_t place, const GrownFace& face, coupling::Constraint constraint) override;

 private:
  CrackFaces& faces_;
  std::vector<WatchedConstraint> watched_;
  std::vector<std::size_t> latest_;  // by number in the system: index in watched_ for the last state
  std::vector<GrownFace> grown_;
  std::unordered_map<int, std::size_t> number_of_;  // number of the place of each term that has one
  std::vector<int> counted_;
  int state_ = 0;  // state to which the present event leads
};

}  // namespace bempd::fracture
