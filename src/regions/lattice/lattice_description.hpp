#pragma once

#include <vector>

#include "geometry/rectilinear.hpp"
#include "scene/scene.hpp"

namespace bempd::regions {

// Peridynamic region as the host described it: a rectilinear outline on a square lattice, and a horizon.
class LatticeDescription : public scene::Region {
 public:
  // Checks the description. Throws Error (argument) for an outline that is not a multiple of the spacing, and for a
  // horizon or Poisson's ratio out of range. `material_id` names the material in sentences.
  LatticeDescription(int material_id, const scene::Material& material, Outline outline, double spacing,
                     int horizon_ratio);

  const LatticeOutline& lattice() const { return lattice_; }
  int horizon_ratio() const { return horizon_ratio_; }

  const char* adjective() const override { return "peridynamic"; }
  void set_outline(Outline outline) override;
  std::optional<scene::NodeGrid> node_grid() const override {
    return scene::NodeGrid{lattice_.origin, lattice_.spacing};
  }
  void add_size(scene::SizeEstimate& size) const override;
  void identify(Hash& hash) const override;
  std::unique_ptr<regions::Region> build(int id, const Preparation& preparation) const override;

 protected:
  // Constructor for derived classes. Without `on_rows` any outline is accepted, and only the lattice's spacing is set.
  LatticeDescription(int material_id, const scene::Material& material, Outline outline, double spacing,
                     int horizon_ratio, bool on_rows);

 private:
  int horizon_ratio_;
  double squares_per_cell_;
  LatticeOutline lattice_;
};

// Adds a lattice region with the outline `vertices` to the scene and returns its id.
int add_lattice_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double spacing,
                       int horizon_ratio);

}  // namespace bempd::regions
