#pragma once

#include <memory>
#include <vector>

#include "pd/deformation.hpp"
#include "pd/network.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Bonds at the points of a region, including those to other regions of its body. `first` and `listed` give its own
// consecutive bonds in the scene. These are the bonds between two of its points, except those that an earlier region of
// the same body also has both ends of.
struct RegionBonds {
  std::shared_ptr<const pd::Network> network;  // shared by regions that are alike
  std::size_t first = 0, listed = 0;           // start and length of its row
  std::vector<int> of_scene;                   // per bond; empty if all are in its row
  // Points of other regions at which bonds of this region end; they are numbered after the region's own points.
  std::vector<int> far_nodes;     // of the scene
  std::vector<Point> far_points;  // in grid coordinates
  // Number of the first square (a term of the scene) for each grid point that is the lower left corner of a cell, -1
  // for other points. In regions with points on their outline: for each patch of cells. Empty if the material has no
  // squares.
  std::vector<int> squares;
};

// Peridynamic region: material points and the bonds between them. Derived classes say where the points lie.
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

  // Swelling of the region (lattice_swelling.cpp).
  void swell(const Swelling& strain, LatticeSwelling& lattices) override;
  void set_rests(const LatticeSwelling& lattices, coupling::Terms& terms) const override;
  std::optional<Eigen::Matrix2d> free_displacement(const Point& place) const override;
  // Whether bonds connect this region to another one where the two touch.
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
  std::vector<double> energy_shares() const { return toughness().shares(positions()); }

 protected:
  // Volume of each point over that of a full cell, for body forces.
  virtual std::vector<double> cell_shares() const = 0;
  // Damage of each point: 1 - number of intact bonds / number of bonds without any crack.
  virtual FieldValues damage(const std::vector<char>& intact) const;
  // Crack in grid coordinates; and whether it may pass through material points, which stay bonded to both faces.
  std::vector<Point> on_grid(const scene::Crack& crack) const;
  virtual bool cracks_may_meet_points() const { return false; }

  // Corrects the stress at points that have lost squares of cells, not only bonds.
  virtual void correct_at_losses(const Solution& /*solution*/, const std::vector<Eigen::Vector3d>& /*strains*/,
                                 const pd::BondStates& /*states*/, std::vector<Eigen::Vector3d>& /*stresses*/) const {}
  // Swelling strains (constant and proportional part) at the region's points and then at the far points of RegionBonds.
  std::vector<Eigen::RowVector2d> strains_of_points(const LatticeSwelling& lattices) const;

  // Adds the bonds of the region's network to the scene's; they become consecutive there.
  void add_own_bonds(const Preparation& preparation, const Contributions& contributions);

  // Ties `points` on a straight interface, in order and `apart` from each other, to elements of the region `leader`.
  void tie_points(const LeadingElements& leading, int leader, const std::vector<int>& points, double apart,
                  coupling::NodeTies& ties) const;

  int point_count() const { return static_cast<int>(points_.size()); }
  int horizon_ratio() const { return horizon_ratio_; }
  double critical_stretch(const scene::Options& options) const;
  // Flags of all bonds at the region's points: nonzero if the bond is broken or cut.
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
  // Positions in grid coordinates of all ends of bonds: the region's points, then the far points.
  std::vector<Point> bond_ends() const;
  FieldValues stress(const Solution& solution) const;
  FieldValues bond_stretch(const Solution& solution) const;

  double spacing_;
  int horizon_ratio_;
  bool is_swollen_ = false;
  std::optional<FreeSwelling> free_swelling_;  // empty if the region cannot swell freely
};

}  // namespace bempd::regions
