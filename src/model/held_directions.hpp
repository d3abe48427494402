#pragma once

#include "model/model.hpp"

namespace bempd::model {

// What supports hold of some nodes.
std::vector<coupling::HeldDirection> held_directions(const PreparedScene& prepared, const std::vector<int>& nodes);

}  // namespace bempd::model
