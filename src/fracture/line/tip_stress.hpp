#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/line/growing_tip.hpp"
#include "fracture/line/joint_points.hpp"
#include "fracture/line/near_points.hpp"
#include "fracture/line/outline_points.hpp"
#include "fracture/line/tip_sight.hpp"
#include "fracture/line/williams_fit.hpp"
#include "linalg/adjacency.hpp"
#include "pd/tip_law.hpp"

namespace bempd::fracture {

// Stresses around tips of crack lines (cracks that grow in a lattice by steps) from the forces of terms (bonds and cell
// squares). The stress of a point is the mean over its area: half of force times bond vector of every bond belongs to
// the point at either end, and the moment of a cell square belongs to its points in equal parts. At points of the
// outline the stress is exact under uniform stress (OutlinePoints). All results are linear in the displacements. Only
// points ahead of the tip are used that do not lie beside its crack and that no other crack hides.
class TipStress {
 public:
  // Distance from the tip, in horizons, of the farthest points of the fit: for tips away from surfaces (outer_reach),
  // and for tips beside a surface (outer_reach_beside).
  static constexpr double outer_reach = 2, outer_reach_beside = 1.25;

  TipStress(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions, const pd::TipLaws& laws);

  // Fit of Williams' series to the stress ahead of the tip. `pressure` is the fluid pressure in its crack (constant and
  // proportional part). The stress of a uniform compression by this pressure is subtracted first, so that the faces are
  // free of load.
  WilliamsFit fitted(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                     const Eigen::RowVector2d& pressure) const;
  // Stress intensity factors of a tip from those of its fit. If the tip laws take load factors from energies, K_II is
  // reduced, because the fit gives it too large; otherwise the factors stay unchanged.
  AffineIntensity corrected_factors(AffineIntensity fitted) const;
  // Stress intensity factors of a tip that give the load factor of its growth, corrected from those of its fit.
  AffineIntensity factors_for_load(const WilliamsFit& fit, double horizon) const;

  // Stress intensity factors from the mean stress closely ahead of the tip. If another tip is closely behind, their
  // ratio K_II / K_I is more accurate than that of the fit.
  AffineIntensity closely_ahead_of(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                                   const Eigen::RowVector2d& pressure) const;

  // Adds the nodes on whose displacements fitted() depends and, with `closely_ahead`, those on which closely_ahead_of()
  // depends; some nodes are added more than once.
  void add_nodes_asked(const GrowingTip& tip, const pd::TipLaw& law, bool closely_ahead, std::vector<int>& nodes) const;

  // Unit vector perpendicular to the largest principal stress at a bond. The stress there is the mean of the stresses
  // of the bond's two points.
  Point across_tension(int bond, const pd::TipLaw& law, const coupling::Affine& displacement, double load_factor) const;

  // Whether an edge ahead of the tip or another crack's face lies within `reach` [m], so that the stress field ahead is
  // not that of the tip alone.
  bool is_crowded(const GrowingTip& tip, const pd::TipLaw& law, double reach) const;
  // Whether another crack's face lies within `reach` [m] of the tip.
  bool is_beside_face(const GrowingTip& tip, const pd::TipLaw& law, double reach) const {
    return sight_of(tip, law).nearest_face() < reach;
  }
  // Whether points of a material with another modulus lie within `reach` [m] of the tip.
  bool meets_other_material(const GrowingTip& tip, const pd::TipLaw& law, double reach) const;
  // Whether the fit of stresses lacks points because a border with boundary elements of the same material is near.
  bool lacks_points(const GrowingTip& tip, const pd::TipLaw& law) const;

  const NearPoints& near() const { return near_; }
  // Distance from a place to the nearest point on an outline, at most `at_most` [m].
  double nearest_outline(const Point& place, double at_most) const;

 private:
  using Stress = WilliamsFit::Stress;
  struct Reach {
    double inner, outer;  // least and largest distance from the tip, in horizons
  };

  // Stress point: a material point near a tip whose stress is used in the fit of Williams' series.
  struct StressPoint {
    int node;
    double distance, ahead, across;  // from the tip, in horizons
  };
  struct Fit {
    int terms;  // number of terms of Williams' series
    std::vector<StressPoint> stress_points;
  };
  GrowingTip as_fitted(GrowingTip tip) const;
  Fit fit_of(const GrowingTip& growing, const pd::TipLaw& law) const;
  std::vector<StressPoint> points_closely_ahead(const GrowingTip& tip, const pd::TipLaw& law) const;
  // Stress points ahead of a tip: material points with bonds within `reach` that no other crack hides. `least_cosine`
  // limits the angle to the tip's direction.
  std::vector<StressPoint> stress_points(const GrowingTip& tip, const pd::TipLaw& law, const Reach& reach,
                                         double least_cosine, const TipSight& sight) const;

  // Calls visit(term) for the intact terms at a node, on which the stress of the node depends.
  template <class Visit>
  void for_each_term(int node, const Visit& visit) const {
    for (const linalg::Adjacency* list : {&bonds_at_, &wide_at_})
      for (const int term : list->of(node))
        if (system_.stages().intact()[static_cast<std::size_t>(term)]) visit(static_cast<std::size_t>(term));
  }

  double nearest_disturbance(const GrowingTip& tip, const pd::TipLaw& law) const;
  Reach reach_at(double nearest_surface, double horizon) const;
  TipSight sight_of(const GrowingTip& tip, const pd::TipLaw& law) const;
  // Tension of a term: constant and proportional part [N].
  Eigen::RowVector2d tension(std::size_t term, const coupling::Affine& displacement) const;
  Stress stress(int node, const Point& direction, const pd::TipLaw& law, const coupling::Affine& displacement) const;

  Stress stress_times_volume(int node, const Point& direction, const coupling::Affine& displacement) const;
  double volume_of(int node, const pd::TipLaw& law) const;  // of a point; by `law` if its region has no tip law [m^3]

  const coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  const pd::TipLaws& laws_;
  NearPoints near_;
  linalg::Adjacency bonds_at_, wide_at_;  // bonds and cell squares at each node
  OutlinePoints outline_;
  JointPoints joints_;
};

}  // namespace bempd::fracture
