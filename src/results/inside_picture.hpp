#pragma once

#include "output/vtu.hpp"
#include "regions/region.hpp"
#include "scene/scene.hpp"

namespace bempd::results {

// Adds the inside of a region of boundary elements to `grid`: triangles with sides of about `size`, with displacement
// and stress. Triangles on the two sides of a crack are not connected.
void add_inside(output::VtuGrid& grid, const regions::Region& region, const scene::Region& described, double size,
                const regions::Solution& solution, const regions::FieldsOfRegion& fields);

}  // namespace bempd::results
