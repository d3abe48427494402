#pragma once

#include <memory>
#include <vector>

#include "pd/deformation.hpp"
#include "pd/network.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Bonds at the points of a region. Its row of the scene's bonds comes first: those between two of its points, unless a
// region before that acts as one with it has both ends, too.
struct RegionBonds {
  std::shared_ptr<const pd::Network> network;  // shared by regions that are alike
  std::size_t first = 0, listed = 0;           // start and length of its row
  std::vector<int> of_scene;                   // per bond; empty if all are in its row
  // Points of other regions where bonds end, numbered after its own.
  std::vector<int> far_nodes;     // of the scene
  std::vector<Point> far_points;  // in grid coordinates
  // First square of the cell whose lower left corner is a point of the grid, per point: a term of the scene, -1 without
  // a cell. With points on the outline: first square of each patch of cells. Empty where bonds alone make the material.
  std::vector<int> squares;
};

// Peridynamic region as material points and bonds between them, wherever they lie.
class BondedRegion : public Region {
 public:
  BondedRegion(int id, const scene::Material& material, double spacing, int horizon_ratio)
      : Region(id, material), spacing_(spacing), horizon_ratio_(horizon_ratio) {}

  const std::shared_ptr<const pd::Network>& network() const { return bonds_.network; }

  void add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const override;
  std::vector<Point> forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                    const FieldsOfRegion& fields) const override;

  bool takes_cracks() const override { return true; }
  std::optional<pd::TipLaw> tip_law(const scene::Options& options) const override;
  std::vector<double> shares_of_cells() const override { return cell_shares(); }
  pd::FeltEnd end_felt_at(const Point& tip, const Point& direction, double backward) const override;
  std::vector<Point> points_on_crack(const scene::Crack& crack) const override;
  void cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
           std::vector<std::string>& warnings) const override;
  std::optional<std::span<const pd::Bond>> bonds() const override {
    return std::span<const pd::Bond>(network()->bonds).first(bonds_.listed);
  }
  std::size_t first_bond() const override { return bonds_.first; }
  std::vector<int> terms() const override;

  // Swelling (lattice_swelling.cpp).
  void swell(const Swelling& strain, LatticeSwelling& lattices) override;
  void set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const override;
  std::optional<Eigen::Matrix2d> free_displacement(const Point& place) const override;
  // Whether bonds cross to the other region where both touch.
  virtual bool shares_bonds_with(const BondedRegion& other) const { return this == &other; }

  FieldSize field_size(Field field) const override;
  FieldValues field(Field field, const Solution& solution) const override;
  SnapshotBlock snapshot_block() const override;
  RegionPicture picture(const Solution& solution) const override;
  int rank_at_interfaces() const override { return 2; }
  void add_statistics(RegionStatistics& statistics) const override;

  double spacing() const { return spacing_; }
  const Point& origin() const { return origin_; }
  void take_bonds(RegionBonds bonds) { bonds_ = std::move(bonds); }
  virtual double critical_stretch(const Preparation& preparation) const;
  Contributions::Breaking breaking(const Preparation& preparation, const Contributions& contributions) const;

 protected:
  // Share of a full cell's volume that every point takes of a force per volume.
  virtual std::vector<double> cell_shares() const = 0;
  // 1 - intact bonds / bonds before any crack.
  virtual FieldValues damage(const std::vector<char>& intact) const;
  // Whether a crack may pass through points, which then stay bonded to both of its faces.
  std::vector<Point> on_grid(const scene::Crack& crack) const;
  virtual bool cracks_may_meet_points() const { return false; }

  // Corrects stresses of points where more than bonds is broken.
  virtual void correct_at_losses(const Solution& /*solution*/, const std::vector<Eigen::Vector3d>& /*strains*/,
                                 const pd::BondStates& /*states*/, std::vector<Eigen::Vector3d>& /*stresses*/) const {}
  // Swelling strains at the region's points, then at the far ones: constant and proportional part.
  std::vector<Eigen::RowVector2d> strains_of_points(const LatticeSwelling& lattices) const;

  // Adds the bonds of its network to the scene's, as a row.
  void add_own_bonds(const Preparation& preparation, const Contributions& contributions);

  // Ties points of a straight interface, in order and at a distance `apart`, to the elements of the region that leads
  // there.
  void tie_points(const LeadingElements& leading, int leader, const std::vector<int>& points, double apart,
                  coupling::NodeTies& ties) const;

  int point_count() const { return static_cast<int>(points_.size()); }
  int horizon_ratio() const { return horizon_ratio_; }
  double critical_stretch(const scene::Options& options) const;
  // One entry for each bond at its points, nonzero where it is broken or cut.
  std::vector<std::uint8_t> broken_bonds(const std::vector<char>& intact) const;
  Point position(int point) const { return from_grid(points_[static_cast<std::size_t>(point)]); }
  std::vector<Point> positions() const;
  Point to_grid(const Point& p) const { return (p - origin_) / spacing(); }
  Point from_grid(const Point& p) const { return origin_ + spacing() * p; }

  std::vector<Point> points_;     // all material points, in grid coordinates
  Point origin_ = Point::Zero();  // place of (0, 0) [m]
  RegionBonds bonds_;

 private:
  std::size_t scene_bond(std::size_t bond) const {
    return bonds_.of_scene.empty() ? bonds_.first + bond : static_cast<std::size_t>(bonds_.of_scene[bond]);
  }
  pd::BondStates bond_states(const Solution& solution) const;
  // Ends of bonds in grid coordinates: its own points, then the far ones.
  std::vector<Point> bond_ends() const;
  FieldValues stress(const Solution& solution) const;
  FieldValues bond_stretch(const Solution& solution) const;

  double spacing_;
  int horizon_ratio_;
  bool is_swollen_ = false;
  std::optional<FreeSwelling> free_swelling_;  // empty if the region cannot swell freely
};

}  // namespace bempd::regions
