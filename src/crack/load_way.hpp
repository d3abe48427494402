#pragma once

#include <cmath>
#include <limits>

namespace bempd::crack {

// Control of the load factor while cracks grow.
enum class Control {
  // The load factor is held: where growth is unstable, events follow each other at one load factor, out of equilibrium.
  load,
  // The load factor follows the equilibrium path: at each event a tip just reaches its toughness, or the most stretched
  // bonds their critical stretch. The load factor falls where growth is unstable.
  path
};

// Relative difference below which two load factors, or two ratios of equivalent factor to toughness, count as equal (a
// tie), because rounding may put either first.
constexpr double tie_share = 1e-9;

// Path of the load factor: its present value, the direction in which it changes, and its control during growth.
struct LoadWay {
  double present;
  bool upwards = true;
  Control control = Control::load;

  LoadWay back() const { return {present, !upwards, control}; }
  double sense() const { return upwards ? 1 : -1; }
  // Number that is larger for load factors that come later on the path.
  double ahead(double load_factor) const { return sense() * load_factor; }
  double end() const { return ahead(std::numeric_limits<double>::infinity()); }
  // Load factor at which an event with the critical load factor `critical` takes place: the present one if the load
  // factor is held and has already passed `critical`, else `critical` itself.
  double place_of(double critical) const {
    return control == Control::load && ahead(critical) < ahead(present) ? present : critical;
  }
  // Whether the load factor `one` comes before `other` on the path by more than rounding (tie_share).
  bool is_before(double one, double other) const {
    if (std::isinf(other)) return ahead(one) < ahead(other);
    return ahead(one) < ahead(other) - tie_share * std::abs(other);
  }
};

}  // namespace bempd::crack
