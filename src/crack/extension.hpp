#pragma once

#include <cstdint>

#include "crack/factors.hpp"
#include "crack/tip.hpp"

namespace bempd::crack {

// Record of the growth of one tip in one event: a straight extension to (x, y), which is the tip's new place or, by its
// state, the place where the tip has ended. A crack that begins in the run is recorded as two extensions from its
// middle.
struct Extension {
  std::int64_t event = 0;
  int crack = 0, end = 0;  // id of the crack; end 1: its last point, 0: its first point
  TipState state = TipState::grows;
  double from_x = 0, from_y = 0;
  double x = 0, y = 0;
  double angle = 0;  // angle by which the crack turned, counter-clockwise [rad]
  double length = 0, crack_length = 0;
  double load_factor = 0;
  // Energy release rates at the beginning and at the end of the extension [J/m^2]; 0 at an end that is no tip.
  double rate_before = 0, rate_after = 0;
  // Released energy [J]: the integral of the energy release rate over the new crack area; for a crack line, the energy
  // that the event released.
  double released_energy = 0;
  double factor_1 = 0, factor_2 = 0;  // K_I and K_II of the tip before it grew [Pa m^(1/2)]
  double resistance = 0;              // fracture energy at the tip [J/m^2]
  double surface_energy = 0;          // part of the released energy that the new crack area took [J]

  TipId tip() const { return {crack, end}; }
  bool has_ended() const { return crack::has_ended(state); }
};

// Begins the record of an extension of the tip at the place `from`, which turns by `angle` [rad]. `resistance` is the
// energy that the growth takes per new crack area [J/m^2].
inline Extension begin_extension(const TipId& tip, const Point& from, double angle, double load_factor,
                                 const AffineFactors& factors, double resistance) {
  Extension e;
  e.crack = tip.crack, e.end = tip.end;
  e.from_x = from.x(), e.from_y = from.y();
  e.angle = angle, e.load_factor = load_factor, e.resistance = resistance;
  const Point present = factors.at(load_factor);
  e.factor_1 = present.x(), e.factor_2 = present.y();
  return e;
}

// Completes the record `e` with the tip's new place `to`, the length of the extension and the tip's new state.
inline void arrive(Extension& e, const Point& to, double length, TipState state) {
  e.x = to.x(), e.y = to.y(), e.length = length, e.state = state;
}

}  // namespace bempd::crack
