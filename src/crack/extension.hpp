#pragma once

#include <cstdint>

#include "crack/factors.hpp"
#include "crack/tip.hpp"

namespace bempd::crack {

// Record of the growth of one tip in one event: a straight extension to (x, y), which is the tip's new place, or where
// it ended if its state says so. A crack that nucleates is recorded as two extensions from its middle.
struct Extension {
  std::int64_t event = 0;
  int crack = 0, end = 0;  // id; 1: the crack's last point, 0: its first
  TipState state = TipState::grows;
  double from_x = 0, from_y = 0;
  double x = 0, y = 0;
  double angle = 0;  // by which it turned, counter-clockwise
  double length = 0, crack_length = 0;
  double load_factor = 0;
  double rate_before = 0, rate_after = 0;  // energy release rates along the way [J/m^2]; none where it has ended
  double released_energy = 0;              // their integral [J]; of a line what the event released
  double factor_1 = 0, factor_2 = 0;       // K_I and K_II of the tip before it grew [Pa m^(1/2)]
  double resistance = 0;                   // energy per area that it met [J/m^2]
  double surface_energy = 0;               // what the new area took of the released energy [J]

  TipId tip() const { return {crack, end}; }
  bool has_ended() const { return crack::has_ended(state); }
};

// Starts the record of the growth of a tip at `from`, which turns by `angle`. `resistance` is the energy per new area
// that growth takes there [J/m^2].
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
