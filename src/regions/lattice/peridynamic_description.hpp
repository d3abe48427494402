#pragma once

#include <optional>
#include <vector>

#include "geometry/rectilinear.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Choices of the host for the material points of a region.
struct PointChoice {
  bool on_outline = false;  // whether points lie on the outline even if the outline follows lattice rows
  double angle = 0;         // angle of the lattice's rows [rad]

  bool is_default() const { return !on_outline && angle == 0; }
};

// Peridynamic region as the host described it: an outline of any shape, the spacing of material points, and a horizon.
// If all edges are parallel to the axes and the host has chosen nothing else, points are the corners of lattice cells;
// otherwise points lie on the outline too.
class PeridynamicDescription : public scene::Region {
 public:
  // Checks the description. Throws Error (argument) for an outline along the axes that is not a multiple of the
  // spacing, and for a horizon or Poisson's ratio out of range. `material_id` names the material in sentences.
  PeridynamicDescription(int material_id, const scene::Material& material, Outline outline, double spacing,
                         int horizon_ratio, const PointChoice& choice = {});

  double spacing() const { return spacing_; }
  int horizon_ratio() const { return horizon_ratio_; }
  const PointChoice& choice() const { return choice_; }
  // Outline in whole cells of the lattice; empty if points lie on the outline.
  const std::optional<LatticeOutline>& lattice() const { return lattice_; }
  // Whether spacing, horizon and angle of two regions are equal.
  bool has_lattice_of(const PeridynamicDescription& other) const;

  const char* adjective() const override { return "peridynamic"; }
  void set_outline(Outline outline) override;
  bool may_be_curved() const override { return true; }
  std::optional<scene::NodeGrid> node_grid() const override;
  double resolution() const override { return spacing_; }
  void add_size(scene::SizeEstimate& size) const override;
  void identify(Hash& hash) const override;
  std::unique_ptr<regions::Region> build(int id, const Preparation& preparation) const override;

 private:
  std::optional<LatticeOutline> lattice_along(const Outline& outline) const;

  double spacing_;
  int horizon_ratio_;
  PointChoice choice_;
  double squares_per_cell_;
  std::optional<LatticeOutline> lattice_;
};

// Adds the size of a lattice of so many cells to an estimate.
void add_size_of_cells(const scene::Material& material, double cells, int horizon_ratio, scene::SizeEstimate& size);

// Adds a peridynamic region with the outline `vertices` to the scene and returns its id; `bulges` make edges curved.
int add_peridynamic_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double spacing,
                           int horizon_ratio, const PointChoice& choice = {}, const std::vector<double>& bulges = {});

}  // namespace bempd::regions
