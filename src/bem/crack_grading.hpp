#pragma once

#include <vector>

#include "geometry/arc.hpp"
#include "geometry/crack_lines.hpp"

namespace bempd::bem {

struct CrackGrading {
  // Number of elements along the part of a line that has not grown, before grading makes more of them near its ends.
  int elements_per_line = 8;
  // Largest number of elements on one segment of growth, which are otherwise as long as those of the line.
  int elements_per_growth = 4;
  // Number of halvings of elements at kinks and branches, where stress has a weak singularity.
  int halvings_at_kinks = 4;
};

// Least distance of a line from another line, or from the boundary, that it does not lead to.
struct NarrowGap {
  int line = -1, other = -1;  // other: -1 is the boundary; line: -1 if there is no gap at all
  double width;
  Point place;  // on the line
};

// Mouth on an edge whose nodes have a fixed spacing (a row of material points): crack elements begin with that length
// there and grow away from it.
struct MouthOnRow {
  Point place;
  double spacing;
};

// Lengths of elements on cracks and near them on the boundary. An element is no longer than the distance to the next
// crack, edge or tip that is not just the continuation of its own line. Along a gap that is long and narrow, elements
// away from its ends may be longer, because fields vary over the width of the gap only near its ends.
class CrackSizes {
 public:
  // `panel_ends`: places on the boundary where supports or loads end; corners are known.
  CrackSizes(const CrackLines& cracks, const std::vector<Edge>& boundary, double tolerance,
             const CrackGrading& grading = {}, const std::vector<Point>& panel_ends = {},
             std::vector<MouthOnRow> mouths = {});

  // Distances along each line at which its elements end, from 0 to its length.
  const std::vector<std::vector<double>>& stations() const { return stations_; }

  // Stations of a piece of the boundary, as fractions of its length, with elements halved until they are short enough.
  std::vector<double> refined(const Arc& piece, const std::vector<double>& stations) const;

  NarrowGap narrowest_gap() const;

 private:
  // A crack or an edge near a place on a line.
  struct Neighbour {
    double gap;
    double apart;  // distance along the line to the place where it meets the neighbour; infinite if it does not
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
  std::vector<double> targets_;            // length of elements on the part of each line that has not grown
  std::vector<Point> ends_;                // of gaps: where fields vary quickly along them
  std::vector<std::vector<double>> stations_;
};

}  // namespace bempd::bem
