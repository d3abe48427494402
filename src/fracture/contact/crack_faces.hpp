#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/contact/face_places.hpp"
#include "fracture/contact/face_state.hpp"
#include "pd/face_places.hpp"

namespace bempd::fracture {

// What a host has said of contact, and where its initial cracks can close.
struct ContactPlan {
  bool faces_meet = false;
  pd::FacePlaces lattices;
  std::vector<pd::FacePlace> initial;
};

// The constraints with a penalty of a body: places where faces of cracks in lattices can meet. They lie on the initial
// cracks, and one at every bond between neighbours that has broken since, with the normal of the broken ones around it.
// The normal of a place may change while it is open. In the system's list they follow the exact constraints.
class CrackFaces {
 public:
  // Bonds in `cut` are broken from the start.
  CrackFaces(coupling::EquilibriumSystem& system, const std::vector<Point>& positions, ContactPlan plan,
             const std::vector<int>& cut);

  // No place will ever be there.
  bool are_none() const { return !plan_.faces_meet; }
  const coupling::Constraints& constraints() const { return system_.constraints(); }

  // Number, in the system's list, of the first constraint that a broken bond makes.
  std::size_t first_grown() const { return system_.constraints().exact_count() + plan_.initial.size(); }
  bool can_have(const GrownFace& face) const;

  // Notes terms that have broken; their places follow with the next update().
  void note_broken(std::span<const int> terms, FaceState& state);
  // Terms that have broken, together those of one event, whose places have not been looked at yet.
  const std::vector<std::vector<int>>& pending() const { return pending_; }
  // New places of these terms, and normals of open ones near them where they do not overlap for it at this
  // displacement.
  void update(const Eigen::VectorXd& displacement, FaceState& state);
  // The rule of both updates and forecasts: places of terms that have broken together, and normals of open ones near
  // them. Returns the terms that tell normals from now on; forget_terms() takes them back.
  std::vector<int> follow(std::span<const int> broken, FacePlaces& places);
  void forget_terms(std::span<const int> terms);
  // Makes the system's constraints those of a state, whose stages it has; what is pending there stays so.
  void restore(const FaceState& state);
  // Makes the system's constraints those of a state while the factor of another matrix is at work, as in a window.
  void go_on_from(const FaceState& state);
  coupling::Constraints constraints_of(const FaceState& state) const;

 private:
  class PresentPlaces;
  void enter(const FaceState& state);
  bool can_be_a_place(int term) const;
  std::vector<int> fresh(std::span<const int> terms) const;
  void enter(int term);
  void leave(int term);
  std::vector<int> around(std::span<const int> terms) const;
  Point middle(int term) const;
  double spacing(int term) const;
  // The parted neighbours around a place.
  std::vector<int> near(int term) const;
  Point normal_at(int term, std::span<const int> others) const;
  std::optional<coupling::Constraint> constraint_at(int term, const Point& normal) const;

  coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  ContactPlan plan_;
  std::vector<int> cut_;                                        // ascending
  double reach_ = 1;                                            // of what tells a normal [m]
  std::unordered_map<std::uint64_t, std::vector<int>> parted_;  // neighbours, by where their middles are
  std::unordered_set<int> entered_;                             // the same as a set
  std::unordered_map<int, std::size_t> grown_;                  // term -> its place among the grown ones
  std::vector<std::vector<int>> pending_;
};

}  // namespace bempd::fracture
