#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "crack/extension.hpp"
#include "crack/growth_law.hpp"
#include "crack/order.hpp"

namespace bempd::crack {

// Crack tip as its carrier sees it under the present loads.
struct Tip {
  TipId id;
  Point place{0, 0}, direction{1, 0};  // unit vector in which a straight crack would go on
  AffineFactors factors;
  GrowthLaw law;
  GrowthRange range;      // of load factors, between which it does not grow
  double kink_angle = 0;  // by which it turns at the present load factor, counter-clockwise [rad]
  double critical_kink_angle = std::numeric_limits<double>::quiet_NaN();  // at the highest of the range, if it has one
  LoadRule load_rule = LoadRule::factors;
  double load_error = std::numeric_limits<double>::quiet_NaN();  // relative, of the highest of the range, if it has one
  bool closed = false;                                           // its faces press on each other
};

// Range of load factors in which none of `tips` grows.
inline GrowthRange common_range(std::span<const Tip> tips) {
  GrowthRange common;
  for (const Tip& tip : tips)
    common = {std::max(common.lowest, tip.range.lowest), std::min(common.highest, tip.range.highest)};
  return common;
}

// Step that a tip is to take at the present load factor.
struct Step {
  TipId tip;
  int ties = 0;       // others that would have grown as soon
  double length = 0;  // of the extension [m]; 0: the carrier chooses
  // Whether the load makes it grow. If not, another process does, such as cycles of the loads, at any load factor.
  bool is_driven = true;
  std::optional<Point> direction{};  // unit vector in which a line goes that is not driven; empty: by its criterion
};

// Outcome of a step that a carrier was to take.
struct Advance {
  std::vector<Extension> extensions;  // of the tips that have grown; none if no tip can
  bool has_stopped = false;           // whether a crack has stopped, at an interface or because it cannot grow
};

// Carrier: a part of the model that contains cracks and lets them grow. It is made of lattices, in which a crack is a
// line that cuts bonds (fracture/line_carrier), or of boundary elements along the crack faces (model/element_carrier).
// The run (fracture/event_loop) asks the carriers for candidates, chooses by order.hpp the tip that grows first,
// whichever carries it, and lets that carrier advance it.
class Carrier {
 public:
  Carrier() = default;
  Carrier(const Carrier&) = delete;
  Carrier& operator=(const Carrier&) = delete;
  virtual ~Carrier() = default;

  // Tips that may grow, sorted by crack and end.
  virtual std::vector<Tip> tips() = 0;
  // Candidates for growth on the load path `way`: tips with the load factors at which they grow. Tips that do not grow
  // on it are left out.
  virtual std::vector<Candidate> candidates(const LoadWay& way) = 0;
  // Lets a candidate grow at the present load factor: bonds are cut, or the run goes on in a body with more elements.
  // The growth is an event of the run's history. Throws FreesLoadedPart.
  virtual Advance advance(const Step& step) = 0;
  // Openings of a crack at fractions of its length: displacement of its left face less that of its right face, as
  // tangential and normal component [m]. NaN where the crack lies elsewhere.
  virtual std::vector<Point> openings(int crack, const std::vector<double>& fractions) = 0;
};

}  // namespace bempd::crack
