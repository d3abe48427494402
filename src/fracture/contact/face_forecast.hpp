#pragma once

#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

#include "fracture/contact/crack_faces.hpp"

namespace bempd::fracture {

// Contact constraint in a range of states: from the state `since` on, before the state `until`.
struct WatchedConstraint {
  coupling::Constraint constraint;
  bool closed;
  bool known;  // from the beginning
  int since, until;
  std::size_t number;  // in the system, also of places to come
  int event;           // that made it as it is
};

// Contact constraints in the states that a window computes ahead (0 is the present one), by the rule of
// CrackFaces::follow(). The constraints of the body itself stay unchanged.
class FaceForecast final : public FacePlaces {
 public:
  FaceForecast(CrackFaces& faces, const FaceState& state);
  ~FaceForecast() override;

  // Follows the terms that an event breaks on the way to `state`: adds their contact places, and renews normals of open
  // ones.
  void follow(std::span<const int> broken, int state);
  void switch_constraint(std::size_t watched, int state);
  void forget_after(int state);  // and no more is asked but constraints()

  // Constraints of all states, each with the range of states in which it holds. Those of the system come first, in its
  // order.
  const std::vector<WatchedConstraint>& constraints() const { return watched_; }
  // Indices in constraints() of the constraints that are in force in the last state and may press.
  std::vector<std::size_t> last() const;
  FaceState last_state() const;

  std::optional<std::size_t> place_of(int term) const override;
  bool is_closed(std::size_t place) const override { return watched_[latest_[place]].closed; }
  void add(const GrownFace& face, coupling::Constraint constraint) override;
  void renew(std::size_t place, const GrownFace& face, coupling::Constraint constraint) override;

 private:
  CrackFaces& faces_;
  std::vector<WatchedConstraint> watched_;
  std::vector<std::size_t> latest_;  // by numbers in the system: which of them in the last state
  std::vector<GrownFace> grown_;
  std::unordered_map<int, std::size_t> number_of_;  // of terms that have a place
  std::vector<int> counted_;
  int state_ = 0;  // that is being followed
};

}  // namespace bempd::fracture
