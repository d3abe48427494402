#pragma once

#include <cstdint>

#include "regions/region.hpp"

namespace bempd::results {

// Record of a tip at an event or, with the event 0, at the end of a step.
struct TipRecord {
  std::int64_t event, total_broken_bonds;
  double load_factor;
  regions::TipValues tip;
};

}  // namespace bempd::results
