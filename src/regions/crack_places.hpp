#pragma once

#include <vector>

#include "pd/face_places.hpp"
#include "regions/discretization.hpp"

namespace bempd::regions {

// The lattices in which faces of cracks are found to meet.
pd::FacePlaces face_lattices(const Discretization& discretization);

// Where the faces of initial cracks can press on each other.
std::vector<pd::FacePlace> places_on_cracks(const std::vector<scene::Crack>& cracks,
                                            const Discretization& discretization, const pd::FacePlaces& lattices);

}  // namespace bempd::regions
