#pragma once

#include <cmath>
#include <limits>

#include "crack/order.hpp"
#include "fracture/stepping_options.hpp"

namespace bempd::fracture {

// The way of the load factor: where it begins, its direction, and what is held on it.
struct LoadWay {
  double present;
  bool upwards = true;
  Control control = Control::load;

  double sense() const { return upwards ? 1 : -1; }
  double ahead(double load_factor) const { return sense() * load_factor; }  // grows on the way
  double end() const { return ahead(std::numeric_limits<double>::infinity()); }
  // Load factor at which something happens that is critical at another one: the present, if that lies behind and the
  // load factor is held.
  double place_of(double critical) const {
    return control == Control::load && ahead(critical) < ahead(present) ? present : critical;
  }
  // Whether one load factor comes before another one on the way, by more than rounding.
  bool is_before(double one, double other) const {
    if (std::isinf(other)) return ahead(one) < ahead(other);
    return ahead(one) < ahead(other) - crack::tie_share * std::abs(other);
  }
};

}  // namespace bempd::fracture
