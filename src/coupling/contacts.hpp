#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "coupling/terms.hpp"

namespace bempd::coupling {

// Place of contact, where two faces can meet. Its gap is c.u; where the gap is negative the faces press on each other
// with the penalty energy k/2 (c.u)^2.
struct Contact {
  std::vector<TermEntry> pull;  // c
  double stiffness;             // k [N/m]
  bool operator==(const Contact&) const = default;

  double gap(const double* displacement) const {
    double sum = 0;
    for (const TermEntry& e : pull) sum += e.x * displacement[2 * e.node] + e.y * displacement[2 * e.node + 1];
    return sum;
  }
};

// All places of contact and which of them are closed. Closed ones are squares of the energy like terms; open ones add
// nothing. Both energies have the same slope where the gap is zero, so that the energy stays convex and equilibrium
// unique.
class Contacts {
 public:
  std::size_t size() const { return places_.size(); }
  const Contact& operator[](std::size_t i) const { return places_[i]; }
  bool is_closed(std::size_t i) const { return closed_[i] != 0; }
  std::size_t closed_count() const { return closed_count_; }
  const std::vector<char>& closed() const { return closed_; }
  double present_stiffness(std::size_t i) const { return closed_[i] ? places_[i].stiffness : 0; }

  // Adds a place, which is open at first.
  void add(Contact place) {
    places_.push_back(std::move(place));
    closed_.push_back(0);
  }
  // Replaces an open place.
  void replace(std::size_t i, Contact place) { places_[i] = std::move(place); }
  void set_closed(std::size_t i, bool closed) {
    closed_count_ += closed == (closed_[i] != 0) ? 0 : closed ? 1 : -1;
    closed_[i] = closed ? 1 : 0;
  }

  // Whether contact at the place is excluded, because it would only push a loose part away.
  bool is_barred(std::size_t i) const { return i < barred_.size() && barred_[i] != 0; }
  std::size_t barred_count() const { return barred_.size(); }  // number of places of which this is known
  const std::vector<char>& barred() const { return barred_; }
  void bar(std::vector<char> barred) { barred_ = std::move(barred); }

  // Calls visit(contact) for the closed places.
  template <class Visit>
  void for_each_closed(const Visit& visit) const {
    if (closed_count_ == 0) return;
    for (std::size_t i = 0; i < size(); ++i) {
      if (closed_[i]) visit(places_[i]);
    }
  }

  // Adds the forces k (c.u) c of the closed places.
  void add_forces(const double* displacement, double* force) const {
    for_each_closed([&](const Contact& place) {
      const double tension = place.stiffness * place.gap(displacement);
      for (const TermEntry& e : place.pull) {
        force[2 * e.node] += tension * e.x;
        force[2 * e.node + 1] += tension * e.y;
      }
    });
  }
  double energy(const double* displacement) const {
    double sum = 0;
    for_each_closed([&](const Contact& place) {
      const double gap = place.gap(displacement);
      sum += 0.5 * place.stiffness * gap * gap;
    });
    return sum;
  }

 private:
  std::vector<Contact> places_;
  std::vector<char> closed_, barred_;
  std::size_t closed_count_ = 0;
};

}  // namespace bempd::coupling
