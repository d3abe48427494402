#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "coupling/terms.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Material points on the outline of lattices, and the area of each such point as a share of the area of an inner point:
// a half on a straight edge, a quarter at a corner.
class OutlinePoints {
 public:
  OutlinePoints(const coupling::Terms& terms, const std::vector<Point>& positions, const pd::TipLaws& laws);

  bool has(int node) const { return share_[static_cast<std::size_t>(node)] > 0; }
  double share_of(int node) const { return has(node) ? share_[static_cast<std::size_t>(node)] : 1; }

  // Matrix M that gives the stress M s of a point near an outline, where s (xx, yy, xy) is the sum of moment_at() times
  // tension over the terms (bonds and cell squares) of the point. M is exact under uniform stress. Dividing s by the
  // volume of the point is not exact, because bonds at a corner have directions of a quarter plane only. Null far from
  // outlines, and at borders between two kinds of lattices.
  const Eigen::Matrix3d* stress_of_moments(int node) const {
    const auto found = stress_of_moments_.find(node);
    return found == stress_of_moments_.end() ? nullptr : &found->second;
  }

 private:
  void find_shares(const coupling::Terms& terms, const pd::TipLaws& laws, const std::vector<double>& stiffness);
  void find_stresses(const coupling::Terms& terms, const std::vector<Point>& positions, const pd::TipLaws& laws,
                     const std::vector<double>& stiffness);

  std::vector<double> share_;  // share of each node; 0 for points inside
  std::map<int, Eigen::Matrix3d> stress_of_moments_;
};

}  // namespace bempd::fracture
