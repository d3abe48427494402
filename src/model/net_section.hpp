#pragma once

#include <vector>

#include "geometry/point.hpp"
#include "regions/region.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Net section of a tip: the straight line through it in the direction in which it grows, from edge to edge of its
// region, without holes and without the cracks along it.
class NetSection {
 public:
  // `outline` of the region; `cracks` by id; `crack` has the tip at `place`.
  NetSection(const Outline& outline, const std::vector<scene::Crack>& cracks, int crack, const Point& place,
             const Point& direction);

  // Places at which the stress has to be known.
  std::vector<Point> places() const;
  // Load over the one that the section bears as a rigid, perfectly plastic one: the largest ratio of the work of the
  // stresses to `flow_stress` times the opening, over all rotations and the translation that open the tip. 0 if the
  // loads press the section together.
  double share(const std::vector<regions::PointValue>& stresses, double flow_stress) const;

 private:
  struct Piece {
    double from, to;  // along the line, from the tip [m]
  };

  void take_out(const scene::Crack& crack, double half_width);
  void take_out(const Piece& part);
  // Integral of the distance from a place over the section.
  double opening_about(double centre) const;

  Point place_, direction_;
  std::vector<Piece> pieces_;
};

}  // namespace bempd::model
