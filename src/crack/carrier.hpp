#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "crack/extension.hpp"
#include "crack/growth_law.hpp"
#include "crack/order.hpp"

namespace bempd::crack {

// Crack tip under the present loads, as its carrier (part of the model in which the crack grows) describes it.
struct Tip {
  TipId id;
  Point place{0, 0}, direction{1, 0};  // place of the tip [m]; unit vector straight ahead
  AffineFactors factors;
  GrowthLaw law;
  GrowthRange range;      // load factors between which the tip does not grow
  double kink_angle = 0;  // turn of the tip if it grew at the present load factor, counter-clockwise [rad]
  // Kink angle if the tip grows at range.highest, the load factor of its growth under rising loads [rad]; NaN if the
  // range has no upper end.
  double critical_kink_angle = std::numeric_limits<double>::quiet_NaN();
  LoadRule load_rule = LoadRule::factors;
  // Relative error of range.highest, the load factor of growth under rising loads; NaN if there is no such load factor,
  // or if its error is unknown.
  double load_error = std::numeric_limits<double>::quiet_NaN();
  bool closed = false;  // crack faces press on each other at the tip
};

// Range of load factors in which none of `tips` grows.
inline GrowthRange common_range(std::span<const Tip> tips) {
  GrowthRange common;
  for (const Tip& tip : tips)
    common = {std::max(common.lowest, tip.range.lowest), std::min(common.highest, tip.range.highest)};
  return common;
}

// Growth of one tip at the present load factor, which a carrier (part of the model with cracks) is asked to carry out.
struct Step {
  TipId tip;
  int ties = 0;       // number of other tips that would have grown at the same load factor
  double length = 0;  // length of the extension [m]; 0: the carrier chooses the length
  // Whether the load makes the tip grow. If false, another process such as fatigue (load cycles) makes the tip grow, at
  // any load factor.
  bool is_driven = true;
  // Direction (unit vector) in which a crack line (crack in a lattice) grows if the load does not drive it; empty: the
  // growth criterion chooses the direction.
  std::optional<Point> direction{};
};

// What a carrier did when it was asked to let a tip grow (Step).
struct Advance {
  std::vector<Extension> extensions;  // one for each tip that has grown; empty if no tip can grow
  bool has_stopped = false;           // whether a crack has stopped, at an interface or because it cannot grow
};

// Carrier: the part of the model that represents cracks and lets them grow. In lattices a crack is a crack line, which
// grows by one spacing at a time and cuts bonds (fracture/line_carrier). In boundary element regions the crack faces
// have elements (model/element_carrier). The run (fracture/event_loop) asks all carriers for candidates, chooses the
// tip that grows first (order.hpp), and lets the carrier of that tip advance it.
class Carrier {
 public:
  Carrier() = default;
  Carrier(const Carrier&) = delete;
  Carrier& operator=(const Carrier&) = delete;
  virtual ~Carrier() = default;

  // Tips that may grow, sorted by crack and end.
  virtual std::vector<Tip> tips() = 0;
  // Candidates for growth on the load path `way`: tips with the load factors at which they grow. Tips that do not grow
  // on this path are left out.
  virtual std::vector<Candidate> candidates(const LoadWay& way) = 0;
  // Lets a candidate tip grow at the present load factor: cuts bonds, or continues the run in a body with more
  // elements. The growth is an event in the history of the run. Throws FreesLoadedPart.
  virtual Advance advance(const Step& step) = 0;
  // Openings of a crack at fractions of its length: the displacement of the left face minus that of the right face, as
  // tangential and normal component [m]; NaN at places where another carrier represents the crack.
  virtual std::vector<Point> openings(int crack, const std::vector<double>& fractions) = 0;
};

}  // namespace bempd::crack
