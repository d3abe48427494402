#pragma once

#include <string>
#include <vector>

#include "elasticity/plane_elasticity.hpp"
#include "output/vtu.hpp"

namespace bempd::results {

// Appends values to the array `name`, which is added if there is no such array.
void append(std::vector<output::VtuArray>& arrays, const std::string& name, int components,
            const std::vector<double>& values);

// Appends stresses, given as xx, yy, xy, in the form that viewers need: "stress", a 3 x 3 tensor with the component
// across the plane, and the largest and smallest principal stress in the plane.
void append_stress(std::vector<output::VtuArray>& arrays, const PlaneElasticity& elasticity,
                   const std::vector<double>& values);

}  // namespace bempd::results
