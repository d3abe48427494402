#pragma once

#include "model/model.hpp"

namespace bempd::model {

// Displacement components of some nodes that supports hold.
std::vector<coupling::HeldDirection> held_directions(const PreparedScene& prepared, const std::vector<int>& nodes);

}  // namespace bempd::model
