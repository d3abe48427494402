#pragma once

#include <map>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace bempd::regions {

// Numbers of times that boundary elements are halved; a negative number says how often they are merged in pairs
// instead. Elements of bodies are halved of_bodies + of_all times, elements of other regions of_all times.
struct Refinement {
  int of_bodies = 0, of_all = 0;
};

// Boundary element region as the host described it: elements along the edges of an outline, which may be curved.
class BoundaryDescription final : public scene::Region {
 public:
  // Throws Error (argument) for an outline or an element length that cannot be used.
  BoundaryDescription(int material, Outline outline, double element_length);
  // Describes a body: the library chooses the lengths of its elements.
  BoundaryDescription(int material, Outline outline);

  const char* adjective() const override { return "BEM"; }
  void set_outline(Outline outline) override;
  bool has_elements() const override { return true; }
  // Whether the region is a body, whose elements the library chooses.
  bool is_body() const { return is_body_; }
  const Refinement& refinement() const { return refinement_; }
  void refine(const Refinement& refinement) { refinement_ = refinement; }
  // Number of times that the region's elements are halved; a negative number says how often they are merged in pairs.
  int halvings() const { return refinement_.of_all + (is_body_ ? refinement_.of_bodies : 0); }
  // Cuts lattice patches out of a body. The patches' loops, counter-clockwise, become the last holes of the body.
  // Elements on these holes have the given length, which is never halved.
  void cut_out(const std::vector<std::vector<Point>>& loops, double element_length);
  // Fills the holes that cut_out() has made.
  void fill_cut_outs();
  // Exchanges the holes that cut_out() has made, and the elements on them, with another description of the same body.
  void exchange_cut_outs(BoundaryDescription& other) noexcept;
  const Outline& whole_outline() const { return whole_ ? *whole_ : outline(); }
  bool borders_patch(int edge) const { return whole_ && edge > whole_edges_; }
  void set_edge_mesh(int edge, const scene::EdgeMesh& mesh) override;
  bool has_own_mesh(int edge) const override { return own_mesh_.count(edge) > 0; }
  scene::EdgeMesh edge_mesh(int edge) const override;
  // Distance between nodes, with which the widths of gaps between this region and others are compared. A body has a
  // much smaller one, because elements become short beside narrow gaps, so that narrow gaps may be intended.
  double resolution() const override { return is_body_ ? 1e-3 * element_length_ : element_length_; }
  void add_size(scene::SizeEstimate& size) const override;
  void identify(Hash& hash) const override;
  std::unique_ptr<regions::Region> build(int id, const Preparation& preparation) const override;

 private:
  double element_length_;  // length before the elements of a body are halved
  bool is_body_ = false;
  Refinement refinement_;
  std::map<int, scene::EdgeMesh> own_mesh_;  // elements that the host has chosen, by edge number
  std::optional<Outline> whole_;             // outline before patches were cut out; empty if none are
  int whole_edges_ = 0;
};

// Description of a boundary element region, which the caller may change because the scene is the caller's own; null for
// other regions.
BoundaryDescription* boundary_in(scene::Scene& scene, int region);
bool is_body(const scene::Region& region);
bool has_bodies(const scene::Scene& scene);
int halvings_of(const scene::Region& region);
// Sets the refinement of all boundary element regions, and returns the refinement that they had before.
Refinement refine(scene::Scene& scene, const Refinement& refinement) noexcept;

// Adds a boundary element region with the outline `vertices` to the scene and returns its id; `bulges` make edges
// curved.
int add_boundary_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double element_length,
                        const std::vector<double>& bulges = {});
// Adds a body (region whose elements the library chooses) with the outline `vertices` to the scene and returns its id;
// `bulges` make edges curved.
int add_body(scene::Scene& scene, int material, const std::vector<Point>& vertices,
             const std::vector<double>& bulges = {});
int add_boundary_disc(scene::Scene& scene, int material, const Point& centre, double radius, double element_length);

}  // namespace bempd::regions
