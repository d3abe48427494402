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

// The places where faces of cracks can meet: on the initial cracks, and one for every bond between neighbours that has
// broken since, with the normal of the broken ones around it. The normal of a place may change while it is open.
class CrackFaces {
 public:
  // Bonds in `cut` are broken from the start.
  CrackFaces(coupling::EquilibriumSystem& system, const std::vector<Point>& positions, ContactPlan plan,
             const std::vector<int>& cut);

  // No place will ever be there.
  bool are_none() const { return !plan_.faces_meet; }
  const coupling::Contacts& places() const { return system_.contacts(); }

  std::size_t initial_count() const { return initial_count_; }
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
  // Makes the system's places those of a state, whose stages it has; what is pending there stays so.
  void restore(const FaceState& state);
  // Makes the system's places those of a state while the factor of another matrix is at work, as in a window.
  void go_on_from(const FaceState& state);
  coupling::Contacts contacts_of(const FaceState& state) const;

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
  std::optional<coupling::Contact> contact_at(int term, const Point& normal) const;

  coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  ContactPlan plan_;
  std::vector<int> cut_;  // ascending
  std::size_t initial_count_ = 0;
  double reach_ = 1;                                            // of what tells a normal [m]
  std::unordered_map<std::uint64_t, std::vector<int>> parted_;  // neighbours, by where their middles are
  std::unordered_set<int> entered_;                             // the same as a set
  std::unordered_map<int, std::size_t> grown_;                  // term -> its place among the grown ones
  std::vector<std::vector<int>> pending_;
};

// Places that are not as their gaps ask for at a load factor. Where a gap is zero the next one in a direction counts: 1
// or -1; 0: it stays as it is.
std::vector<int> wrong_places(const coupling::Contacts& places, const coupling::Affine& displacement,
                              double load_factor, double direction);

// Load factor on the way to another one at which the first place opens or closes; nothing if none does.
std::optional<double> next_switch(const coupling::Contacts& places, const coupling::Affine& displacement, double from,
                                  double to);

// Wrong places and the next switch of faces inside the system's operators.
std::vector<int> wrong_faces(const coupling::EquilibriumSystem& system, const coupling::Affine& displacement,
                             double load_factor, double direction);
std::optional<double> next_face_switch(const coupling::EquilibriumSystem& system, const coupling::Affine& displacement,
                                       double from, double to);
double face_rounding(double largest_displacement);

// Whether a place is wrong where displacements are known as numbers: how far its gap counts as zero.
double gap_rounding(double largest_displacement);

}  // namespace bempd::fracture
