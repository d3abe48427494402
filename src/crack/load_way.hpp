#pragma once

#include <cmath>
#include <limits>

namespace bempd::crack {

// What is held while cracks grow.
enum class Control {
  // The load factor: where growth is unstable events follow each other at one load factor, out of equilibrium.
  load,
  // Nothing: each event lies where a tip just reaches its toughness, or the most stretched bonds their critical
  // stretch, so that the load factor falls where growth is unstable, and every state is one of equilibrium.
  path
};

// Load factors or ratios that differ by less than this share are a tie: rounding may put either first.
constexpr double tie_share = 1e-9;

// Way of the load factor: from where, in which direction, and what is held on it.
struct LoadWay {
  double present;
  bool upwards = true;
  Control control = Control::load;

  LoadWay back() const { return {present, !upwards, control}; }
  double sense() const { return upwards ? 1 : -1; }
  double ahead(double load_factor) const { return sense() * load_factor; }  // grows on the way
  double end() const { return ahead(std::numeric_limits<double>::infinity()); }
  // Load factor at which that happens which is critical at another one: here, if that lies behind and the load factor
  // is held.
  double place_of(double critical) const {
    return control == Control::load && ahead(critical) < ahead(present) ? present : critical;
  }
  // Whether one load factor comes before another one on the way, by more than rounding.
  bool is_before(double one, double other) const {
    if (std::isinf(other)) return ahead(one) < ahead(other);
    return ahead(one) < ahead(other) - tie_share * std::abs(other);
  }
};

}  // namespace bempd::crack
