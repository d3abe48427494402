#pragma once

#include <cstddef>
#include <optional>

#include "coupling/constraints.hpp"
#include "fracture/contact/face_state.hpp"

namespace bempd::fracture {

// Contact places that CrackFaces::follow() updates: the places of the body, or the places forecast for states that a
// window (region around crack tips that is solved alone) computes ahead. The number of a place is the number of its
// constraint in the system.
class FacePlaces {
 public:
  FacePlaces() = default;
  FacePlaces(const FacePlaces&) = delete;
  FacePlaces& operator=(const FacePlaces&) = delete;
  virtual ~FacePlaces() = default;

  // Number of the place that a broken term has added; empty if it has added none.
  virtual std::optional<std::size_t> place_of(int term) const = 0;
  virtual bool is_closed(std::size_t place) const = 0;
  // Adds a contact place, which is open at first.
  virtual void add(const GrownFace& face, coupling::Constraint constraint) = 0;
  // Gives an open place another normal, unless the faces would overlap in that direction.
  virtual void renew(std::size_t place, const GrownFace& face, coupling::Constraint constraint) = 0;
};

}  // namespace bempd::fracture
