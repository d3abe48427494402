#pragma once

#include <cstddef>
#include <optional>

#include "coupling/constraints.hpp"
#include "fracture/contact/face_state.hpp"

namespace bempd::fracture {

// Places of crack faces that CrackFaces::follow() updates: those of the body now, or those forecast for the states that
// a window computes ahead. Places have the numbers of the system's constraints.
class FacePlaces {
 public:
  FacePlaces() = default;
  FacePlaces(const FacePlaces&) = delete;
  FacePlaces& operator=(const FacePlaces&) = delete;
  virtual ~FacePlaces() = default;

  // Number of the place that a broken term has made; empty if it has made none.
  virtual std::optional<std::size_t> place_of(int term) const = 0;
  virtual bool is_closed(std::size_t place) const = 0;
  // Adds a place, which is open.
  virtual void add(const GrownFace& face, coupling::Constraint constraint) = 0;
  // Gives an open place another normal, unless its faces would overlap.
  virtual void renew(std::size_t place, const GrownFace& face, coupling::Constraint constraint) = 0;
};

}  // namespace bempd::fracture
