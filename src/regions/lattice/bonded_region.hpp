#pragma once

#include <memory>
#include <vector>

#include "regions/lattice/bonded_swelling.hpp"
#include "regions/lattice/material_points.hpp"
#include "regions/lattice/region_squares.hpp"
#include "regions/lattice/tied_points.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

// Peridynamic region: material points and the bonds between them. Derived classes say where the points lie.
class BondedRegion : public Region,
                     public MaterialPoints,
                     public PointBorders,
                     public RegionBonds,
                     public RegionLoads,
                     public RegionResults {
 public:
  BondedRegion(int id, const scene::Material& material, double spacing, int horizon_ratio)
      : Region(id, material), MaterialPoints(spacing, horizon_ratio), swelling_(*this, bonds_) {}

  const RegionLoads& loads() const override { return *this; }
  const RegionResults& results() const override { return *this; }
  const RegionBonds* bonds() const override { return this; }
  PointBorders* point_borders() override { return this; }
  RegionSwelling* swelling() override { return &swelling_; }

  const std::shared_ptr<const pd::Network>& network() const { return bonds_.network; }

  void add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const override;
  std::vector<Point> forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                    const FieldsOfRegion& fields) const override;

  std::optional<pd::TipLaw> tip_law(const scene::Options& options) const override;
  std::vector<Point> points_on_crack(const scene::Crack& crack) const override;
  void cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
           std::vector<std::string>& warnings) const override;
  std::span<const pd::Bond> list() const override {
    return std::span<const pd::Bond>(network()->bonds).first(bonds_.listed);
  }
  std::size_t first_bond() const override { return bonds_.first; }
  std::vector<int> terms() const override;

  // Cell squares of the region (extra energy terms of lattice cells, for Poisson's ratios that bonds alone cannot
  // have); null if this class of regions has none.
  virtual const RegionSquares* squares() const { return nullptr; }
  // Whether bonds connect this region to another one where the two touch.
  virtual bool shares_bonds_with(const BondedRegion& other) const { return this == &other; }

  std::vector<int> entries_of_nodes() const override;
  std::vector<int> nodes_of_entries() const override { return nodes_; }
  FieldSize field_size(Field field) const override;
  FieldValues field(Field field, const Solution& solution) const override;
  SnapshotBlock snapshot_block() const override;
  RegionPicture picture(const Solution& solution) const override;
  int rank_at_interfaces() const override { return 2; }
  void add_statistics(RegionStatistics& statistics) const override;

  void take_bonds(SceneBonds bonds) { bonds_ = std::move(bonds); }
  virtual double critical_stretch(const Preparation& preparation) const;
  Contributions::Breaking breaking(const Preparation& preparation, const Contributions& contributions) const;
  std::vector<double> energy_shares() const { return toughness().shares(positions()); }

 protected:
  // Damage of each point: 1 - n / n0 with the numbers n of its intact bonds and n0 of its bonds without any crack.
  virtual FieldValues damage(const std::vector<char>& intact) const;
  // Points of a crack in grid coordinates (in spacings from the origin of the region's grid).
  std::vector<Point> on_grid(const scene::Crack& crack) const;
  // Whether cracks may pass through material points, which then stay bonded to both faces.
  virtual bool cracks_may_meet_points() const { return false; }

  // Adds the bonds of the region's network to the scene's bonds, where they become consecutive.
  void add_own_bonds(const Preparation& preparation, const Contributions& contributions);

  // Row of material points on a straight interface, in order, with the distance `point_distance` between neighbours
  // [m].
  PointRow row_of(const std::vector<int>& points, double point_distance) const;

  double critical_stretch(const scene::Options& options) const;

  SceneBonds bonds_;

 private:
  FieldValues stress(const Solution& solution) const;

  BondedSwelling swelling_;
};

}  // namespace bempd::regions
