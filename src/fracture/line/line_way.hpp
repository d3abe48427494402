#pragma once

#include <optional>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "crack/tip.hpp"
#include "fracture/line/tip_stress.hpp"
#include "linalg/adjacency.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// What the way of a tip meets: bonds across it, the face of a crack, a free edge.
class LineWay {
 public:
  LineWay(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions, const TipStress& stress);

  struct Step {
    double length = 0;
    std::vector<int> bonds;  // across it; none where nothing lies ahead
    crack::TipState ends_as = crack::TipState::grows;

    bool arrives() const { return crack::has_ended(ends_as); }  // at the face of a crack or at an edge
  };
  Step next(const Point& place, const Point& direction, const pd::TipLaw& law) const;

  // Bonds that are left across a way.
  std::vector<int> across(const Point& from, const Point& to, double horizon) const;

  // How many spacings lie ahead before the face of a crack or an edge, at most so many.
  int clear_spacings(const Point& place, const Point& direction, const pd::TipLaw& law, int most) const;

  const linalg::Adjacency& terms_from() const { return terms_from_; }

 private:
  std::optional<double> face_ahead(const Point& tip, const Point& way, const pd::TipLaw& law) const;
  std::optional<double> edge_ahead(const Point& tip, const Point& way, const pd::TipLaw& law) const;
  bool is_free(const Point& edge, double reach) const;

  const coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  const TipStress& stress_;
  linalg::Adjacency terms_from_;  // nodes, the first ones of terms
};

}  // namespace bempd::fracture
