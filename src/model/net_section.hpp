#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/point.hpp"
#include "regions/fields.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Tip of a crack line in a lattice. The lattice smooths the stress, which is unbounded at the tip of an ideal crack,
// over a radius around the tip.
struct SpreadTip {
  Point place{0, 0};
  double radius = 0;  // distance from the tip beyond which the lattice has the body's stress [m]
};

// Net section of a tip: the straight line through the tip in the direction of growth, from edge to edge of the tip's
// region, without holes and without cracks along the line.
class NetSection {
 public:
  // `outline`: of the region; `cracks`: all cracks by id; `crack`: id of the crack whose tip is at `place`; `spread`:
  // tips with the distance over which a lattice spreads their stress, 0 in boundary elements.
  NetSection(const Outline& outline, const std::vector<scene::Crack>& cracks, int crack, const Point& place,
             const Point& direction, const std::vector<SpreadTip>& spread);

  // Places at which the stress must be known.
  std::vector<Point> places() const;
  // Load on the section over its limit load as a rigid, perfectly plastic section: the largest ratio of the work of the
  // stresses to `flow_stress` times the opening, over the translation and all rotations that open the tip. 0 if the
  // loads press the section together. `stresses` are those at places(); `factors` are the mode I factors of the spread
  // tips.
  double share(const std::vector<regions::PointValue>& stresses, double flow_stress,
               const std::vector<double>& factors) const;

 private:
  // End of a piece of the section at a spread tip (tip in a lattice). Within the radius the singular field of the tip
  // replaces the stress of the lattice.
  struct SpreadEnd {
    std::size_t tip = 0;
    double radius = 0;  // 0: the piece does not end at such a tip [m]
  };
  struct Piece {
    double from, to;  // along the section, from the tip [m]
    std::array<SpreadEnd, 2> ends{};

    double first() const { return from + ends[0].radius; }
    double last() const { return to - ends[1].radius; }
  };
  // Force on the section and moment about the tip, per thickness.
  struct Resultant {
    double force = 0, moment = 0;
  };

  void find_spread_ends(const std::vector<SpreadTip>& spread);
  Resultant resultant(const std::vector<double>& pulls, const std::vector<double>& factors) const;

  void take_out(const scene::Crack& crack, double half_width);
  void take_out(const Piece& part);
  // Integral of the distance from the place `centre` over the section: the opening by a unit rotation about that place.
  // `centre` is measured along the section from the tip.
  double opening_about(double centre) const;

  Point place_, direction_;
  std::vector<Piece> pieces_;
};

}  // namespace bempd::model
