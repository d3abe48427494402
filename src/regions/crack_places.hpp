#pragma once

#include <vector>

#include "pd/face_places.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Lattices of all regions in which crack faces can touch each other, with the stiffness of their material.
pd::FacePlaces face_lattices(const Discretization& discretization);

// Contact places of initial cracks in lattices, at which the two faces of a crack can touch. A contact place lies at
// each crossing of a crack with the columns or rows of a lattice that has material points on both sides of the crack
// nearby.
std::vector<pd::FacePlace> places_on_cracks(const std::vector<scene::Crack>& cracks,
                                            const Discretization& discretization, const pd::FacePlaces& lattices);

}  // namespace bempd::regions
