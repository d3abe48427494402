#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/contact/face_places.hpp"
#include "fracture/contact/face_state.hpp"
#include "pd/face_places.hpp"

namespace bempd::fracture {

// Contact settings of the host, and the contact places on initial cracks.
struct ContactPlan {
  bool faces_meet = false;
  pd::FacePlaces lattices;
  std::vector<pd::FacePlace> initial;
};

// Contact of crack faces in lattices: constraints with a penalty (stiffness against overlap) at contact places. Contact
// places lie on the initial cracks, and at every bond between neighbouring points that has broken since. The normal at
// such a bond follows from the broken bonds around and may change while the place is open. In the system's list these
// constraints follow the exact ones (faces of boundary elements).
class CrackFaces {
 public:
  // Creates the contact places on initial cracks. `cut` are the bonds that initial cracks have cut.
  CrackFaces(coupling::EquilibriumSystem& system, const std::vector<Point>& positions, ContactPlan plan,
             const std::vector<int>& cut);

  // Whether the body has no contact in lattices at all.
  bool are_none() const { return !plan_.faces_meet; }
  const coupling::Constraints& constraints() const { return system_.constraints(); }

  // Number in the system's list of the first constraint that a broken bond has added.
  std::size_t first_grown() const { return system_.constraints().exact_count() + plan_.initial.size(); }
  // Whether a contact place of a saved state is possible in this body.
  bool can_have(const GrownFace& face) const;

  // Notes terms (bonds and cell squares) that have broken together; the next update() adds their contact places.
  void note_broken(std::span<const int> terms, FaceState& state);
  // Terms that have broken but whose contact places are not added yet, grouped by event.
  const std::vector<std::vector<int>>& pending() const { return pending_; }
  // Keeps only the first `events` pending events, because the later ones are taken back.
  void keep_first_pending(std::size_t events, FaceState& state) noexcept {
    pending_.resize(events);
    state.pending.resize(events);
  }
  // Adds the contact places of terms noted as broken, and renews the normals of open places near them. A normal is kept
  // if the faces would overlap with the new normal at this displacement.
  void update(const Eigen::VectorXd& displacement, FaceState& state);
  // Rule shared by updates and forecasts: adds to `places` the contact places of terms that have broken together, and
  // renews the normals of open places near them. From this call on, the broken bonds among the terms count when normals
  // are determined; the result lists these bonds for forget_terms(), which ends that.
  std::vector<int> follow(std::span<const int> broken, FacePlaces& places);
  void forget_terms(std::span<const int> terms);
  // Makes the system's constraints those of a saved state, whose damage stages of terms the system already has. Broken
  // terms without contact places (pending) remain pending.
  void restore(const FaceState& state);
  // Makes the system's constraints those of a state, while the system's factor belongs to another matrix, as in an open
  // window (region around crack tips that is solved alone).
  void go_on_from(const FaceState& state);
  coupling::Constraints constraints_of(const FaceState& state) const;

 private:
  class PresentPlaces;
  void take_over(const FaceState& state);
  bool can_be_a_place(int term) const;
  std::vector<int> newly_broken(std::span<const int> terms) const;
  void count_for_normals(int term);
  void stop_counting(int term);
  std::vector<int> places_affected(std::span<const int> terms) const;
  Point middle(int term) const;
  double spacing(int term) const;
  // Broken bonds between neighbouring points within about a horizon of the middle of a term.
  std::vector<int> near(int term) const;
  Point normal_at(int term, std::span<const int> others) const;
  std::optional<coupling::Constraint> constraint_at(int term, const Point& normal) const;

  coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  ContactPlan plan_;
  std::vector<int> cut_;  // bonds that initial cracks cut, ascending
  double reach_ = 1;      // distance within which broken bonds determine a normal [m]
  std::unordered_map<std::uint64_t, std::vector<int>> broken_near_;  // broken bonds by the grid cells of their middles
  std::unordered_set<int> counted_;                                  // all bonds in broken_near_
  std::unordered_map<int, std::size_t> grown_;  // place in FaceState::grown of each broken bond that has one
  std::vector<std::vector<int>> pending_;
};

}  // namespace bempd::fracture
