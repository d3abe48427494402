#pragma once

#include <limits>

#include "crack/laws/host_resistance.hpp"
#include "crack/laws/resistance_directions.hpp"
#include "crack/tip.hpp"
#include "geometry/point.hpp"

namespace bempd::regions {

enum class TipMethod { elements = 1, contours = 2, stress_ahead = 3 };

// Tip of a crack with its results; unknown results are NaN.
struct TipValues {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  crack::TipId id() const { return {crack, end}; }

  int crack = 0;                             // id
  int end = 0;                               // 1: the crack's last point, 0: its first
  Point place{0, 0}, direction{1, 0};        // unit vector in which a straight crack would go on
  Point factors{unknown, unknown};           // K_I, K_II [Pa m^(1/2)]
  double energy_release_rate = unknown;      // G of growth straight on [J/m^2]
  double stress_along = unknown;             // T-stress [Pa]
  double error = unknown;                    // estimated error of the factors [Pa m^(1/2)]
  Point constant_factors{unknown, unknown};  // K_I and K_II of the constant part of the loads
  Point proportional_factors{unknown, unknown};
  double toughness = 0;      // K_I at which the tip grows straight on; 0: it does not grow [Pa m^(1/2)]
  double plane_modulus = 0;  // [Pa]
  const crack::ResistanceDirections* directions = nullptr;  // null: the toughness is the same in all directions
  crack::AskingTip asking{};  // tip for a host's function that gives the toughness at the present loads

  // Results of the chosen growth criterion, set by complete() (model/element_growth.hpp). A load factor is +- the
  // largest double if the tip never grows.
  double kink_angle = unknown;                 // turn from the direction, counter-clockwise, at the present loads [rad]
  double critical_load_factor = unknown;       // at which the tip grows while the load factor rises
  double critical_load_factor_down = unknown;  // at which the tip grows while the load factor falls
  double critical_kink_angle = unknown;        // angle by which the tip turns at critical_load_factor [rad]
  double straight_load_factor = unknown;       // smallest >= 0 at which G of straight growth is the fracture energy
  crack::LoadRule load_rule = crack::LoadRule::unknown;  // what the critical load factors come from
  double load_error = unknown;                           // relative error of critical_load_factor
  double valid_radius = unknown;  // radius around the tip without other disturbances of its field [m]

  // Members from here on are set for tips in lattices only.
  TipMethod method = TipMethod::elements;
  int contours = 0;
  bool grown = false, branched = false;
  double contour_radius = 0, felt_ahead = 0;  // radius of the largest ring; place to effective tip [m]
  bool closed = false;                        // faces press on each other at the tip
};

}  // namespace bempd::regions
