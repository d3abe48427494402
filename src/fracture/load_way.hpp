#pragma once

#include "crack/load_way.hpp"

namespace bempd::fracture {

using crack::Control;
using crack::LoadWay;

}  // namespace bempd::fracture
