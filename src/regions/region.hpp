#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "pd/varied_energy.hpp"
#include "regions/crack_elements.hpp"
#include "regions/preparation.hpp"
#include "regions/region_bonds.hpp"
#include "regions/region_borders.hpp"
#include "regions/region_loads.hpp"
#include "regions/region_operators.hpp"
#include "regions/region_results.hpp"
#include "regions/region_statistics.hpp"
#include "regions/region_swelling.hpp"
#include "scene/material.hpp"

namespace bempd::regions {

// Lattice of material points at origin + spacing * (i, j), turned about the origin by the angle (counter-clockwise).
struct LatticeGrid {
  Point origin;
  double spacing, horizon;  // [m]
  double angle = 0;         // [rad]
};

// Region of a discretized scene: its nodes, and its parts, such as loads, results, operators and bonds. A class for a
// kind of region implements build(), loads(), results() and add_statistics(), and overrides the functions of those
// other parts that the kind has. The region numbers its own nodes from 0; nodes() gives their numbers in the scene.
class Region {
 public:
  Region(int id, const scene::Material& material) : id_(id), material_(material) {}
  virtual ~Region() = default;
  Region(const Region&) = delete;
  Region& operator=(const Region&) = delete;

  int id() const { return id_; }
  const scene::Material& material() const { return material_; }
  const PlaneElasticity& elasticity() const { return material_.elasticity; }
  const pd::VariedEnergy& toughness() const { return toughness_; }
  void vary_toughness(pd::VariedEnergy toughness) { toughness_ = std::move(toughness); }
  const std::vector<int>& nodes() const { return nodes_; }

  // --- Preparation: mesh() is called for all regions in the order of their ids, then build() in the same order.

  virtual void mesh(const Preparation& /*preparation*/) {}
  // Numbers the region's nodes, builds its operators, and adds its bonds to the scene's.
  virtual void build(const Preparation& preparation, Contributions& contributions) = 0;

  // --- Parts of the region; null, or empty, if the region does not have the part

  virtual const RegionLoads& loads() const = 0;
  virtual const RegionResults& results() const = 0;
  virtual const RegionOperators* operators() const { return nullptr; }
  virtual const RegionBonds* bonds() const { return nullptr; }
  virtual const CrackElements* crack_elements() const { return nullptr; }
  virtual const ElementBorders* element_borders() const { return nullptr; }
  virtual PointBorders* point_borders() { return nullptr; }
  virtual RegionSwelling* swelling() { return nullptr; }
  const RegionSwelling* swelling() const { return const_cast<Region*>(this)->swelling(); }
  // Lattice of the region; empty if stress intensity factors cannot be computed from its bonds.
  virtual std::optional<LatticeGrid> lattice_grid() const { return std::nullopt; }

  virtual void add_statistics(RegionStatistics& statistics) const = 0;

  // Values at the region's nodes (two for each node), taken from the values at all nodes of the scene.
  Eigen::VectorXd gather(const Eigen::VectorXd& of_scene) const;
  // Adds values at the region's nodes to the values at all nodes of the scene.
  void scatter(const Eigen::VectorXd& own, Eigen::Ref<Eigen::VectorXd> of_scene) const;

  double seconds_preparing = 0;

 protected:
  std::vector<int> nodes_;

 private:
  int id_;
  scene::Material material_;
  pd::VariedEnergy toughness_;
};

}  // namespace bempd::regions
