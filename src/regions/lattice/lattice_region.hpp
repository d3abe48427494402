#pragma once

#include <memory>
#include <vector>

#include "geometry/rectilinear.hpp"
#include "pd/cell_lattice.hpp"
#include "regions/lattice/bonded_region.hpp"
#include "regions/lattice/grid_squares.hpp"
#include "regions/lattice/peridynamic_description.hpp"

namespace bempd::regions {

class LatticeGroup;

// Peridynamic region whose material points are the corners of lattice cells. Other schemes override the protected
// virtual functions.
class LatticeRegion : public BondedRegion {
 public:
  LatticeRegion(int id, const PeridynamicDescription& described, const scene::Material& material);

  void mesh(const Preparation& preparation) override;
  void build(const Preparation& preparation, Contributions& contributions) override;
  void follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const override;
  std::vector<Point> interface_points(const Preparation& preparation, const Contact& own) override;

  std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const override;
  void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                    Eigen::Ref<Eigen::VectorXd> force) const override;

  std::optional<LatticeGrid> lattice_grid() const override {
    return LatticeGrid{origin_, spacing(), horizon_ratio() * spacing()};
  }
  std::optional<pd::FaceLattice> face_lattice() const override { return pd::FaceLattice{origin_, spacing(), 0}; }

  std::vector<double> cell_shares() const override;

  std::int64_t cell_count() const override { return grid_.cell_count(); }
  Cells cells() const override;
  std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                       bool with_stress) const override;

  // --- Functions for the group of regions that form one lattice

  // Whether this region and another one form a single lattice where they touch along an edge: class, material and
  // horizon ratio are equal. (Lattices that touch must have one spacing, see require_compatible().)
  virtual bool acts_as_one_with(const LatticeRegion& other) const;
  virtual pd::Network make_network(const pd::CellLattice& cells, int threads) const;
  const pd::CellLattice& grid() const { return grid_; }

  bool shares_bonds_with(const BondedRegion& other) const override;
  const RegionSquares* squares() const override { return &squares_; }

 protected:
  // Material point on which supports and loads on an edge act.
  struct EdgePoint {
    int point;
    double fraction;  // place as a fraction of the edge
  };

  // Adds material points that the edges of neighbours need; the points of the grid exist already.
  virtual void place_points(const Preparation& /*preparation*/) {}
  // Flags of material points that are nodes of other regions, too: all points on matching interfaces, and only the two
  // end points of other interfaces.
  virtual std::vector<char> shared_points(const Preparation& preparation) const;
  // Whether another region of the same class has the same network of bonds, so that both can share it.
  virtual bool is_alike(const LatticeRegion& other) const;
  virtual std::vector<EdgePoint> edge_points(int edge) const;
  // Adds the nodal forces of a traction on the straight piece of boundary from a to b, in grid coordinates.
  virtual void add_edge_forces(const Point& a, const Point& b, const std::function<Point(const Point&)>& traction,
                               Eigen::Ref<Eigen::VectorXd> forces) const;
  // Distance from the grid's cells, in spacings, up to which places outside of the cells are still evaluated.
  virtual double reach_beyond_cells() const { return 0; }

  void use_grid(pd::CellLattice grid, const Point& origin);

  const LatticeOutline& outline() const { return outline_; }
  // Material points on an edge or a part of it between two corners of cells, ends included. Only for lattices whose
  // points are the corners of cells.
  std::vector<int> points_along(const Point& start, const Point& end) const;

 private:
  class LatticeEvaluator;

  void place_points_of_grid(const Point& origin);
  void bond_alone(const Preparation& preparation, Contributions& contributions);
  void take_network(const Preparation& preparation, std::vector<std::string>& warnings);

  LatticeOutline outline_;  // outline of the cells
  pd::CellLattice grid_;    // points of the grid and the cells between them
  GridSquares squares_;
  std::shared_ptr<LatticeGroup> group_;  // null if the region is alone, or once its bonds exist
};

}  // namespace bempd::regions
