#pragma once

#include <map>
#include <vector>

#include "scene/scene.hpp"

namespace bempd::regions {

// Boundary element region as the host described it: elements along its edges, which may be curved.
class BoundaryDescription final : public scene::Region {
 public:
  // Throws Error (argument) for an outline or an element length that cannot be used.
  BoundaryDescription(int material, Outline outline, double element_length);

  const char* adjective() const override { return "BEM"; }
  void set_outline(Outline outline) override;
  bool has_elements() const override { return true; }
  void set_edge_mesh(int edge, const scene::EdgeMesh& mesh) override;
  bool has_own_mesh(int edge) const override { return own_mesh_.count(edge) > 0; }
  scene::EdgeMesh edge_mesh(int edge) const override;
  double resolution() const override { return element_length_; }
  void add_size(scene::SizeEstimate& size) const override;
  void identify(Hash& hash) const override;
  std::unique_ptr<regions::Region> build(int id, const Preparation& preparation) const override;

 private:
  double element_length_;
  std::map<int, scene::EdgeMesh> own_mesh_;  // by edge number
};

// Adds a boundary element region with the outline `vertices` to the scene and returns its id; `bulges` make edges
// curved.
int add_boundary_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double element_length,
                        const std::vector<double>& bulges = {});
int add_boundary_disc(scene::Scene& scene, int material, const Point& centre, double radius, double element_length);

}  // namespace bempd::regions
