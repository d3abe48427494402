#pragma once

#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "crack/tip.hpp"
#include "fracture/line/tip_stress.hpp"
#include "linalg/adjacency.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Path of a tip: bonds across it, and whether it meets the face of a crack or a free edge.
class LinePath {
 public:
  LinePath(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions, const TipStress& stress);

  struct Step {
    double length = 0;
    std::vector<int> bonds;  // across it; none where nothing lies ahead
    crack::TipState ends_as = crack::TipState::grows;

    bool arrives() const { return crack::has_ended(ends_as); }  // at the face of a crack or at an edge
  };
  Step next(const Point& place, const Point& direction, const pd::TipLaw& law) const;

  // Intact bonds across the straight path between two places. Points on the path count as lying on its right side, so
  // that none stays bonded to both faces, or all of them on its left side.
  enum class PointsOnPath { right, left };
  std::vector<int> across(const Point& from, const Point& to, double horizon,
                          PointsOnPath side = PointsOnPath::right) const;

  // Number of spacings ahead of a tip before the face of a crack or an edge, at most `most`.
  int clear_spacings(const Point& place, const Point& direction, const pd::TipLaw& law, int most) const;

  // Whether a place lies at a free edge or outside of it, with nothing ahead.
  bool leaves_body(const Point& place, const Point& direction, const pd::TipLaw& law) const;

  const linalg::Adjacency& terms_from() const { return terms_from_; }

 private:
  std::optional<double> face_ahead(const Point& tip, const Point& direction, const pd::TipLaw& law) const;
  std::optional<double> edge_ahead(const Point& tip, const Point& direction, const pd::TipLaw& law) const;
  bool is_free(const Point& edge, double reach) const;

  const coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  const TipStress& stress_;
  linalg::Adjacency terms_from_;  // nodes, the first ones of terms
};

}  // namespace bempd::fracture
