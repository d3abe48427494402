#pragma once

#include <memory>
#include <vector>

#include "geometry/rectilinear.hpp"
#include "pd/cell_lattice.hpp"
#include "regions/lattice/bonded_region.hpp"
#include "regions/lattice/lattice_description.hpp"

namespace bempd::regions {

class LatticeGroup;

// Peridynamic region on its material points, the corners of its cells. Other lattices override the protected virtual
// functions.
class LatticeRegion : public BondedRegion {
 public:
  LatticeRegion(int id, const LatticeDescription& described, const scene::Material& material);

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

  std::int64_t cell_count() const override { return grid_->cell_count(); }
  Cells cells() const override;
  std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                       bool with_stress) const override;

  // --- For the group of regions that it acts as one with

  // Whether two regions act as one where they touch along an edge: one material, spacing and horizon.
  virtual bool acts_as_one_with(const LatticeRegion& other) const;
  virtual pd::Network make_network(const pd::CellLattice& cells, int threads) const;
  const pd::CellLattice& grid() const { return *grid_; }

  void set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const override;
  bool shares_bonds_with(const BondedRegion& other) const override;

 protected:
  // Point where supports and loads on an edge act.
  struct EdgePoint {
    int point;
    double fraction;  // of the edge
  };

  // Adds points where the edges of neighbours ask for them; the points of the grid exist already.
  virtual void place_points(const Preparation& /*preparation*/) {}
  // Material points that are nodes of other regions, too: all on interfaces that match, the ends of others.
  virtual std::vector<char> shared_points(const Preparation& preparation) const;
  // Whether another region, of the same class, has the same network.
  virtual bool is_alike(const LatticeRegion& other) const;
  virtual std::vector<EdgePoint> edge_points(int edge) const;
  // Adds the forces at points of a traction on a straight piece of boundary, all in coordinates of the cells.
  virtual void add_edge_forces(const Point& a, const Point& b, const std::function<Point(const Point&)>& traction,
                               Eigen::Ref<Eigen::VectorXd> forces) const;
  std::vector<double> cell_shares() const override;
  // Distance beyond the grid's cells up to which values are asked for, in spacings.
  virtual double reach_beyond_cells() const { return 0; }

  void use_grid(pd::CellLattice grid, const Point& origin);

  const LatticeOutline& outline() const { return outline_; }
  // Points on an edge or a part of it between corners of cells, ends included; only where the corners are the points.
  std::vector<int> points_along(const Point& start, const Point& end) const;

 private:
  class LatticeEvaluator;

  // Replaces the stresses where bonds or squares of cells are broken by those of the remaining ones, the mean over the
  // cells at a point.
  void correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                         const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const override;
  Eigen::Vector3d stress_of_squares(const Solution& solution, int first_square) const;
  void bond_alone(const Preparation& preparation, Contributions& contributions);
  void take_network(const Preparation& preparation, std::vector<std::string>& warnings);

  LatticeOutline outline_;                 // of the cells
  std::unique_ptr<pd::CellLattice> grid_;  // points of the grid and the cells between them
  std::shared_ptr<LatticeGroup> group_;    // null if the region is alone, or once its bonds exist
};

}  // namespace bempd::regions
