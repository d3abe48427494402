#pragma once

#include <vector>

#include "geometry/arc.hpp"
#include "geometry/crack_lines.hpp"

namespace bempd::bem {

struct CrackGrading {
  // Along what a line has not grown; what is left of them is due to the graded ends.
  int elements_per_line = 8;
  // Growth has elements as long, but no more of them along one segment.
  int elements_per_growth = 4;
  // Elements at kinks and branches are this many times halved, for the stresses are singular there, if weakly.
  int halvings_at_kinks = 4;
};

// The least distance of a line from another one or from the boundary that it does not lead to.
struct NarrowGap {
  int line = -1, other = -1;  // other: -1 is the boundary; line: -1 if there is no gap at all
  double width;
  Point place;  // on the line
};

// A mouth on a row of nodes that are so far apart: elements of the crack are as short there, and grow from it.
struct MouthOnRow {
  Point place;
  double spacing;
};

// Lengths that elements on cracks and around them may have: no longer than the way to the next crack, edge or tip that
// is not just the continuation of their own line. Along a gap that is narrow over its length they are longer away from
// its ends, as only at ends do fields vary within the width of a gap.
class CrackSizes {
 public:
  // `panel_ends`: places on the boundary where supports or loads end; corners are known.
  CrackSizes(const CrackLines& cracks, const std::vector<Edge>& boundary, double tolerance,
             const CrackGrading& grading = {}, const std::vector<Point>& panel_ends = {},
             std::vector<MouthOnRow> mouths = {});

  // Ways along each line at which its elements end, from 0 to its length.
  const std::vector<std::vector<double>>& stations() const { return stations_; }

  // Stations of a piece of the boundary, in parts of its length, with elements halved until they are short enough.
  std::vector<double> refined(const Arc& piece, const std::vector<double>& stations) const;

  NarrowGap narrowest_gap() const;

 private:
  // A thing beside a place on a line.
  struct Neighbour {
    double gap;
    double apart;  // way along the line to where it meets the thing; infinite if it does not lead there
    int line;      // -1: an edge of the boundary
  };
  std::vector<Neighbour> neighbours(int line, double way, const Point& x) const;
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
  double tolerance_;
  CrackGrading grading_;
  std::vector<MouthOnRow> mouths_;
  std::vector<std::vector<double>> ways_;  // of the points of each line
  std::vector<double> targets_;            // of the elements on what each line has not grown
  std::vector<Point> ends_;                // of gaps: where fields vary quickly along them
  std::vector<std::vector<double>> stations_;
};

}  // namespace bempd::bem
