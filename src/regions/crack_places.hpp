#pragma once

#include <vector>

#include "pd/face_places.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// Lattices in which crack faces can touch.
pd::FacePlaces face_lattices(const Discretization& discretization);

// Places where the faces of initial cracks can touch.
std::vector<pd::FacePlace> places_on_cracks(const std::vector<scene::Crack>& cracks,
                                            const Discretization& discretization, const pd::FacePlaces& lattices);

}  // namespace bempd::regions
