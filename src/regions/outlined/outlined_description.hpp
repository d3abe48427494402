#pragma once

#include "pd/outlined/outline_balance.hpp"
#include "regions/lattice/lattice_description.hpp"

namespace bempd::regions {

// Choices of the host for the material points of a region.
struct PointChoice {
  bool on_outline = false;  // whether points lie on the outline even if it follows lattice rows
  double angle = 0;         // of the lattice's rows [rad]
  // Goal for the bonds near an outline that has points on it.
  pd::OutlineBalance balance = pd::OutlineBalance::constant_stress;

  bool is_plain() const { return !on_outline && angle == 0; }
};

// Peridynamic region with any outline as the host described it. It becomes a lattice if all edges are parallel to the
// axes, else a region with points on its outline.
class OutlinedDescription final : public LatticeDescription {
 public:
  OutlinedDescription(int material_id, const scene::Material& material, const Outline& outline, double spacing,
                      int horizon_ratio, const PointChoice& choice);

  const PointChoice& choice() const { return choice_; }

  void set_outline(Outline outline) override;
  bool may_be_curved() const override { return true; }
  std::optional<scene::NodeGrid> node_grid() const override;
  double resolution() const override { return lattice().spacing; }
  void identify(Hash& hash) const override;
  std::unique_ptr<regions::Region> build(int id, const Preparation& preparation) const override;

 private:
  // Whether the region becomes a lattice: all edges are parallel to the axes, and the host has not chosen otherwise.
  bool is_on_rows(const Outline& outline) const;

  PointChoice choice_;
  bool on_rows_;
};

// Adds a peridynamic region with the outline `vertices` to the scene and returns its id; `bulges` make edges curved.
int add_peridynamic_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double spacing,
                           int horizon_ratio, const PointChoice& choice = {}, const std::vector<double>& bulges = {});

}  // namespace bempd::regions
