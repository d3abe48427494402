#pragma once

#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "crack/tip.hpp"
#include "fracture/line/tip_stress.hpp"
#include "linalg/adjacency.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Path of the tip of a crack line (crack that grows in a lattice by steps): the bonds across it, and whether it meets
// the face of a crack or a free edge.
class LinePath {
 public:
  LinePath(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions, const TipStress& stress);

  struct Step {
    double length = 0;
    std::vector<int> bonds;  // bonds across the step; none if no bond lies ahead
    crack::TipState ends_as = crack::TipState::grows;

    bool arrives() const { return crack::has_ended(ends_as); }  // at a crack face or an edge
  };
  // Next step of a tip at a place in a direction.
  Step next(const Point& place, const Point& direction, const pd::TipLaw& law) const;

  // Side of a straight path to which material points exactly on the path are counted.
  enum class PointsOnPath { right, left };
  // Intact bonds across the straight path between two places. All points exactly on the path count to the same `side`
  // of it, so that none of them stays bonded to both crack faces.
  std::vector<int> across(const Point& from, const Point& to, double horizon,
                          PointsOnPath side = PointsOnPath::right) const;

  // Number of spacings from a tip at a place to the next crack face or edge in a direction, at most `most`.
  int clear_spacings(const Point& place, const Point& direction, const pd::TipLaw& law, int most) const;

  // Whether a place lies at a free edge or outside of the body, with no bonds ahead.
  bool leaves_body(const Point& place, const Point& direction, const pd::TipLaw& law) const;

  const linalg::Adjacency& terms_from() const { return terms_from_; }

 private:
  std::optional<double> face_ahead(const Point& tip, const Point& direction, const pd::TipLaw& law) const;
  std::optional<double> edge_ahead(const Point& tip, const Point& direction, const pd::TipLaw& law) const;
  bool is_free(const Point& edge, double reach) const;

  const coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  const TipStress& stress_;
  linalg::Adjacency terms_from_;  // terms by their first nodes
};

}  // namespace bempd::fracture
