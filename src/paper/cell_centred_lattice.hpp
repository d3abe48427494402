#pragma once

#include "paper/uncorrected_lattice.hpp"

namespace bempd::paper {

// Lattice of the scheme `paper` with material points at the centres of its cells, followed by points on interfaces, at
// the nodes of the boundary elements there.
class CellCentredLattice final : public UncorrectedLattice {
 public:
  CellCentredLattice(int id, const regions::PeridynamicDescription& described, const scene::Material& material);

  // Rank 0, which is that of boundary elements, because the points of the cells do not lie on interfaces.
  int rank_at_interfaces() const override { return 0; }
  std::vector<double> cell_shares() const override;

 protected:
  void place_points(const regions::Preparation& preparation) override;
  std::vector<char> shared_points(const regions::Preparation& preparation) const override;
  // Points on which loads of an edge act: the centres of the cells that border on the edge.
  std::vector<EdgePoint> edge_points(int edge) const override;
  void add_edge_forces(const Point& a, const Point& b, const std::function<Point(const Point&)>& traction,
                       Eigen::Ref<Eigen::VectorXd> forces) const override;
  // Cracks may pass through material points, because a crack at 45 degrees cannot miss all centres of cells.
  bool cracks_may_meet_points() const override { return true; }
  double reach_beyond_cells() const override { return 0.5; }
};

}  // namespace bempd::paper
