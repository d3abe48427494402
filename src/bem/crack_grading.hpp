#pragma once

#include <vector>

#include "geometry/arc.hpp"
#include "geometry/box_tree.hpp"
#include "geometry/crack_lines.hpp"

namespace bempd::bem {

struct CrackGrading {
  // Number of elements along the described part of a crack line (without its growth), before grading adds more near its
  // ends.
  int elements_per_line = 8;
  // Largest number of elements on one segment of growth. A segment gets fewer if elements as long as those on the
  // described part of the line are short enough.
  int elements_per_growth = 4;
  // Number of halvings of elements at kinks and branches, where stress has a weak singularity.
  int halvings_at_kinks = 4;
};

// Narrowest gap: the least distance between a crack line and another crack line, or the boundary, where the two do not
// meet.
struct NarrowGap {
  int line = -1, other = -1;  // line: -1 if there is no gap; other: -1 for the boundary
  double width;
  Point place;  // on the line
};

// Crack mouth on an edge whose nodes have a fixed spacing (a row of material points). The crack element at the mouth is
// as long as this spacing, and elements grow with the distance from the mouth.
struct MouthOnRow {
  Point place;
  double spacing;
};

// Lengths of the elements on cracks, and of boundary elements near cracks. An element is no longer than its distance to
// the next crack, edge or tip; a crack or edge that leads away from a joint with the element's own line sets no limit.
// Along a narrow gap, elements away from the gap's ends may be longer, because fields vary over the width of the gap
// only near these ends.
class CrackSizes {
 public:
  // Chooses the elements on all cracks. `panel_ends` are places on the boundary where supports or loads end; the
  // corners are taken from `boundary`.
  CrackSizes(const CrackLines& cracks, const std::vector<Edge>& boundary, double tolerance,
             const CrackGrading& grading = {}, const std::vector<Point>& panel_ends = {},
             std::vector<MouthOnRow> mouths = {});

  // Distances along each crack line at which its elements end, from 0 to the length of the line.
  const std::vector<std::vector<double>>& stations() const { return stations_; }

  // Ends of boundary elements on a piece of the boundary, as fractions of its length. The elements between `stations`
  // are halved until they are short enough for the cracks nearby.
  std::vector<double> refined(const Arc& piece, const std::vector<double>& stations) const;

  NarrowGap narrowest_gap() const;

 private:
  // Crack or edge near a place on a crack line.
  struct Neighbour {
    double gap;
    // Distance along the line to the place where the line meets this neighbour; infinite if the two do not meet.
    double distance_along;
    int line;  // number of the neighbouring crack line; -1: an edge of the boundary
  };
  // Calls visit(neighbour) for the cracks and edges near x, the place at the distance `way` along a crack line. Edges
  // that are certainly at least `limit` away may be left out; visit() may lower `limit`.
  template <class Visit>
  void for_neighbours(int line, double way, const Point& x, const double& limit, const Visit& visit) const;
  std::size_t segment_at(int line, double way) const;
  Point place_at(int line, double way) const;
  double along_gap(double gap, double shortest, double undivided, const Point& x) const;
  double target(int line, std::size_t segment) const;
  double from_tips(int line, double way) const;
  double on_line(int line, double way) const;
  double on_boundary(const Point& x, double undivided) const;
  double from_kinks(int line, double way) const;
  double from_rows(const Point& x) const;
  std::vector<double> stations_of(int line) const;

  const CrackLines& cracks_;
  const std::vector<Edge>& boundary_;
  BoxTree edges_;  // boxes around the boundary's edges
  double tolerance_;
  CrackGrading grading_;
  std::vector<MouthOnRow> mouths_;
  std::vector<std::vector<double>> ways_;  // distances of each line's points along the line
  std::vector<Box> around_;                // box around each line
  std::vector<double> targets_;            // element length on the described part of each line
  std::vector<Point> ends_;                // ends of gaps, near which fields vary quickly along the gap
  std::vector<std::vector<double>> stations_;
};

}  // namespace bempd::bem
