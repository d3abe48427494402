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

// Stresses around tips from the forces of terms: half of force times bond vector of every bond belongs to the point at
// either end, a quarter of what a cell's squares carry to each of its corners (the mean of the stress over the area of
// a point). All that is asked of them is linear in the displacements, and asked of points ahead of the tip only that it
// sees, none of which lies beside its crack.
class TipStress {
 public:
  TipStress(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions, const pd::TipLaws& laws);

  // `pressure`: in its crack, constant and proportional part. The body is looked at under that on all sides besides, by
  // which the crack's faces are free.
  AffineIntensity at(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                     const Eigen::RowVector2d& pressure) const;
  // The series as it is fitted, and its factors as a tip has them: K_II is fitted too large.
  WilliamsFit fitted(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                     const Eigen::RowVector2d& pressure) const;
  AffineIntensity as_read(AffineIntensity fitted) const;

  // The intensity by the mean stress closely ahead: the better ratio of both modes where another tip lies closely
  // behind.
  AffineIntensity closely_ahead_of(const GrowingTip& tip, const pd::TipLaw& law, const coupling::Affine& displacement,
                                   const Eigen::RowVector2d& pressure) const;

  // Nodes on whose displacements the first of both depends, or both; some of them more than once.
  void add_nodes_asked(const GrowingTip& tip, const pd::TipLaw& law, bool closely_ahead, std::vector<int>& nodes) const;

  // Unit vector across the largest principal stress where a bond is.
  Point across_tension(int bond, const pd::TipLaw& law, const coupling::Affine& displacement, double load_factor) const;

  // Whether something lies so near that the stress ahead is not the tip's own: an edge, the face of another crack, or
  // points of another material.
  bool is_crowded(const GrowingTip& tip, const pd::TipLaw& law, double reach) const;
  bool meets_other_material(const GrowingTip& tip, const pd::TipLaw& law, double reach) const;

  const NearPoints& near() const { return near_; }
  double nearest_outline(const Point& place, double at_most) const;

 private:
  using Stress = WilliamsFit::Stress;
  struct Reach {
    double inner, outer;  // in horizons, of what is asked around a tip
  };

  // A point whose stress is asked.
  struct Station {
    int node;
    double distance, ahead, across;  // of the tip, in horizons
  };
  struct Fit {
    int terms;  // of Williams' series
    std::vector<Station> stations;
  };
  GrowingTip as_fitted(GrowingTip tip) const;
  Fit fit_of(const GrowingTip& growing, const pd::TipLaw& law) const;
  std::vector<Station> stations_closely_ahead(const GrowingTip& tip, const pd::TipLaw& law) const;
  // The material points with bonds ahead of a tip that lie within reach and that it sees.
  std::vector<Station> stations(const GrowingTip& tip, const pd::TipLaw& law, const Reach& reach, double least_cosine,
                                const TipSight& sight) const;

  // Terms that are left at a node, on which its stress depends.
  template <class Visit>
  void for_each_term(int node, const Visit& visit) const {
    for (const linalg::Adjacency* list : {&bonds_at_, &wide_at_})
      for (const int term : list->of(node))
        if (system_.intact()[static_cast<std::size_t>(term)]) visit(static_cast<std::size_t>(term));
  }

  double nearest_disturbance(const GrowingTip& tip, const pd::TipLaw& law) const;
  Reach reach_at(double nearest_surface, double horizon) const;
  TipSight sight_of(const GrowingTip& tip, const pd::TipLaw& law) const;
  Eigen::RowVector2d tension(std::size_t term, const coupling::Affine& displacement) const;  // both parts [N]
  Eigen::Vector3d moment_about(int node, std::size_t wide, const Point& direction) const;
  Stress stress(int node, const Point& direction, const pd::TipLaw& law, const coupling::Affine& displacement) const;

  Stress stress_times_volume(int node, const Point& direction, const coupling::Affine& displacement) const;
  double volume_of(int node, const pd::TipLaw& law) const;  // where its region has none, by this one [m^3]

  const coupling::EquilibriumSystem& system_;
  const std::vector<Point>& positions_;
  const pd::TipLaws& laws_;
  NearPoints near_;
  linalg::Adjacency bonds_at_, wide_at_;  // nodes
  OutlinePoints outline_;
  JointPoints joints_;
};

}  // namespace bempd::fracture
