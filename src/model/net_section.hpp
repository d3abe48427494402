#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/point.hpp"
#include "regions/region.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Tip of a line in a lattice, which spreads the stress that is unbounded at the tip over about a horizon.
struct SpreadTip {
  Point place{0, 0};
  double radius = 0;  // beyond which the stress of the lattice is that of the body [m]
};

// Net section of a tip: the straight line through it in the direction in which it grows, from edge to edge of its
// region, without holes and without the cracks along it.
class NetSection {
 public:
  // `outline` of the region; `cracks` by id; `crack` has the tip at `place`; `spread`: tips of lines in lattices.
  NetSection(const Outline& outline, const std::vector<scene::Crack>& cracks, int crack, const Point& place,
             const Point& direction, const std::vector<SpreadTip>& spread);

  // Places at which the stress has to be known.
  std::vector<Point> places() const;
  // Load over the one that the section bears as a rigid, perfectly plastic one: the largest ratio of the work of the
  // stresses to `flow_stress` times the opening, over all rotations and the translation that open the tip. 0 if the
  // loads press the section together. `factors` of mode I belong to the spread tips.
  double share(const std::vector<regions::PointValue>& stresses, double flow_stress,
               const std::vector<double>& factors) const;

 private:
  // End of a piece at a spread tip: within the radius the field of the tip takes the place of the stress.
  struct SpreadEnd {
    std::size_t tip = 0;
    double radius = 0;  // 0: the piece does not end at such a tip [m]
  };
  struct Piece {
    double from, to;  // along the line, from the tip [m]
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
  // Integral of the distance from a place over the section.
  double opening_about(double centre) const;

  Point place_, direction_;
  std::vector<Piece> pieces_;
};

}  // namespace bempd::model
