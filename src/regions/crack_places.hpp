#pragma once

#include <vector>

#include "pd/face_places.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Lattices of the body in which crack faces can touch, with their stiffness per gap.
pd::FacePlaces face_lattices(const Discretization& discretization);

// Contact places of initial cracks in lattices: where the two faces of the cut can touch. One lies at each crossing of
// a crack with the columns or rows of a lattice.
std::vector<pd::FacePlace> places_on_cracks(const std::vector<scene::Crack>& cracks,
                                            const Discretization& discretization, const pd::FacePlaces& lattices);

}  // namespace bempd::regions
