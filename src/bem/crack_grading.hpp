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

// Lengths that elements on cracks and around them may have: no longer than the way to the next crack, edge or tip that
// is not just the continuation of their own line.
class CrackSizes {
 public:
  CrackSizes(const CrackLines& cracks, const std::vector<Edge>& boundary, double tolerance,
             const CrackGrading& grading = {});

  // Ways along each line at which its elements end, from 0 to its length.
  const std::vector<std::vector<double>>& stations() const { return stations_; }

  // Stations of a piece of the boundary, in parts of its length, with elements halved until they are short enough.
  std::vector<double> refined(const Arc& piece, const std::vector<double>& stations) const;

 private:
  double target(int line, std::size_t segment) const;
  double from_tips(int line, double way) const;
  double on_line(int line, double way) const;
  double on_boundary(const Point& x) const;
  double from_kinks(int line, double way) const;
  std::vector<double> stations_of(int line) const;

  const CrackLines& cracks_;
  const std::vector<Edge>& boundary_;
  double tolerance_;
  CrackGrading grading_;
  std::vector<std::vector<double>> ways_;  // of the points of each line
  std::vector<double> targets_;            // of the elements on what each line has not grown
  std::vector<std::vector<double>> stations_;
};

}  // namespace bempd::bem
