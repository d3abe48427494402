#pragma once

#include <memory>
#include <vector>

#include "geometry/rectilinear.hpp"
#include "pd/cell_lattice.hpp"
#include "pd/deformation.hpp"
#include "pd/network.hpp"
#include "regions/lattice/lattice_description.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

class LatticeGroup;

// The bonds at the points of a region. Its row of the scene's bonds comes first: those between two of its points,
// unless a region before that it acts as one with has both ends too.
struct RegionBonds {
  std::shared_ptr<const pd::Network> network;  // shared by regions that are alike
  std::size_t first = 0, listed = 0;           // where its row begins, and how long it is
  std::vector<int> of_scene;                   // per bond; empty if all are in its row
  // Points of other regions where bonds end, numbered after its own.
  std::vector<int> far_nodes;     // of the scene
  std::vector<Point> far_points;  // in grid coordinates
  // Per point of the grid: the first of the squares of the cell whose lower left corner it is, a term of the scene; -1
  // without a cell. Empty where bonds alone make the material.
  std::vector<int> squares;
};

// A peridynamic region on its material points, the corners of its cells. What other lattices do differently are the
// protected virtual functions.
class LatticeRegion : public Region {
 public:
  LatticeRegion(int id, const LatticeDescription& described, const scene::Material& material);

  const std::shared_ptr<const pd::Network>& network() const { return bonds_.network; }

  void mesh(const Preparation& preparation) override;
  void build(const Preparation& preparation, Contributions& contributions) override;
  void follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const override;

  std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const override;
  void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                    Eigen::Ref<Eigen::VectorXd> force) const override;
  std::vector<Point> forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                    const FieldsOfRegion& fields) const override;
  void add_body_force(const Point& body_force, Eigen::Ref<Eigen::VectorXd> force) const override;

  bool takes_cracks() const override { return true; }
  std::optional<pd::TipLaw> tip_law(const scene::Options& options) const override;
  void cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
           std::vector<std::string>& warnings) const override;
  std::optional<std::span<const pd::Bond>> bonds() const override {
    return std::span<const pd::Bond>(network()->bonds).first(bonds_.listed);
  }
  std::size_t first_bond() const override { return bonds_.first; }
  std::optional<LatticeGrid> lattice_grid() const override {
    return LatticeGrid{origin_, spacing(), horizon_ratio_ * spacing()};
  }

  // lattice_swelling.cpp
  void swell(const Swelling& strain, LatticeSwelling& lattices) override;
  void set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const override;
  std::optional<Eigen::Matrix2d> free_displacement(const Point& place) const override;

  FieldSize field_size(Field field) const override;
  FieldValues field(Field field, const Solution& solution) const override;
  std::int64_t cell_count() const override { return grid_->cell_count(); }
  Cells cells() const override;
  SnapshotBlock snapshot_block() const override;
  std::unique_ptr<Evaluator> evaluator(const Solution& solution, const FieldsOfRegion& fields,
                                       bool with_stress) const override;
  int rank_at_interfaces() const override { return 2; }
  void add_statistics(RegionStatistics& statistics) const override;

  // --- For the group of regions that it acts as one with

  // Whether both act as one where they touch along an edge: one material, spacing and horizon.
  virtual bool acts_as_one_with(const LatticeRegion& other) const;
  virtual pd::Network make_network(const pd::CellLattice& cells, int threads) const;
  virtual double critical_stretch(const Preparation& preparation) const;
  double spacing() const { return outline_.spacing; }
  const pd::CellLattice& grid() const { return *grid_; }
  const Point& origin() const { return origin_; }
  void take_bonds(RegionBonds bonds) { bonds_ = std::move(bonds); }

 protected:
  // Where supports and loads on an edge act.
  struct EdgePoint {
    int point;
    double fraction;  // of the edge
  };

  // Puts points where the edges of neighbours ask for them; those of the grid are there.
  virtual void place_points(const Preparation& /*preparation*/) {}
  // Material points that are nodes of other regions too: all on interfaces that match, the ends of others.
  virtual std::vector<char> shared_points(const Preparation& preparation) const;
  // Whether another region, of the same class, has the same network.
  virtual bool is_alike(const LatticeRegion& other) const;
  virtual std::vector<EdgePoint> edge_points(int edge) const;
  // Adds forces at the points of a traction on a straight piece of boundary, all in coordinates of the cells.
  virtual void add_edge_forces(const Point& a, const Point& b, const std::function<Point(const Point&)>& traction,
                               Eigen::Ref<Eigen::VectorXd> forces) const;
  // Share of a full cell's volume that every point takes of a force per volume.
  virtual std::vector<double> cell_shares() const;
  // 1 - intact bonds / bonds before any crack.
  virtual FieldValues damage(const std::vector<char>& intact) const;
  // Whether a crack may pass through points, which then stay bonded to both of its faces.
  virtual bool cracks_may_meet_points() const { return false; }
  // How far beyond the grid's cells values are asked for, in spacings.
  virtual double reach_beyond_cells() const { return 0; }

  void use_grid(pd::CellLattice grid, const Point& origin);

  int point_count() const { return static_cast<int>(points_.size()); }
  const LatticeOutline& outline() const { return outline_; }
  int horizon_ratio() const { return horizon_ratio_; }
  double critical_stretch(const scene::Options& options) const;
  // One entry a bond at its points, nonzero where it is broken or cut.
  std::vector<std::uint8_t> broken_bonds(const std::vector<char>& intact) const;
  // Points on an edge or a part of it between corners of cells, ends included; only where the corners are the points.
  std::vector<int> points_along(const Point& start, const Point& end) const;
  Point position(int point) const { return from_grid(points_[static_cast<std::size_t>(point)]); }
  Point to_grid(const Point& p) const { return (p - origin_) / spacing(); }
  Point from_grid(const Point& p) const { return origin_ + spacing() * p; }

  std::vector<Point> points_;  // all material points, in grid coordinates; those of the grid first

 private:
  class LatticeEvaluator;

  void bond_alone(const Preparation& preparation, Contributions& contributions);
  void take_network(const Preparation& preparation, std::vector<std::string>& warnings);
  std::size_t scene_bond(std::size_t bond) const {
    return bonds_.of_scene.empty() ? bonds_.first + bond : static_cast<std::size_t>(bonds_.of_scene[bond]);
  }
  pd::BondStates bond_states(const Solution& solution) const;
  FieldValues stress(const Solution& solution) const;
  // Where bonds or squares of cells are gone: stresses of what is left of both, the mean over the cells at a point.
  void correct_at_losses(const Solution& solution, const std::vector<Eigen::Vector3d>& strains,
                         const pd::BondStates& states, std::vector<Eigen::Vector3d>& stresses) const;
  Eigen::Vector3d stress_of_squares(const Solution& solution, int first_square) const;
  FieldValues bond_stretch(const Solution& solution) const;

  LatticeOutline outline_;                 // of the cells
  std::unique_ptr<pd::CellLattice> grid_;  // points of the grid and the cells between them
  Point origin_ = Point::Zero();           // place of the grid's point (0, 0) [m]
  int horizon_ratio_;
  RegionBonds bonds_;
  bool is_swollen_ = false;
  std::optional<FreeSwelling> free_swelling_;  // none if it cannot follow
  std::shared_ptr<LatticeGroup> group_;        // null if it is alone, and when bonds are there
};

}  // namespace bempd::regions
