#pragma once

#include <map>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace bempd::regions {

// Number of times that boundary elements are halved: those of bodies in addition to those of all regions. Negative:
// merged in pairs as often.
struct Refinement {
  int of_bodies = 0, of_all = 0;
};

// Boundary element region as the host described it: elements along its edges, which may be curved.
class BoundaryDescription final : public scene::Region {
 public:
  // Throws Error (argument) for an outline or an element length that cannot be used.
  BoundaryDescription(int material, Outline outline, double element_length);
  // Describes a body: the library chooses the lengths of its elements.
  BoundaryDescription(int material, Outline outline);

  const char* adjective() const override { return "BEM"; }
  void set_outline(Outline outline) override;
  bool has_elements() const override { return true; }
  // Whether it is a body: the library chooses its elements.
  bool is_body() const { return is_body_; }
  const Refinement& refinement() const { return refinement_; }
  void refine(const Refinement& refinement) { refinement_ = refinement; }
  // Number of times that the region's elements are halved; if negative, elements are merged in pairs as often.
  int halvings() const { return refinement_.of_all + (is_body_ ? refinement_.of_bodies : 0); }
  // Cuts lattice patches out of a body: their loops, counter-clockwise, become its last holes, with elements of a
  // length that is never halved. fill_cut_outs() fills them again.
  void cut_out(const std::vector<std::vector<Point>>& loops, double element_length);
  void fill_cut_outs();
  const Outline& whole_outline() const { return whole_ ? *whole_ : outline(); }
  bool borders_patch(int edge) const { return whole_ && edge > whole_edges_; }
  void set_edge_mesh(int edge, const scene::EdgeMesh& mesh) override;
  bool has_own_mesh(int edge) const override { return own_mesh_.count(edge) > 0; }
  scene::EdgeMesh edge_mesh(int edge) const override;
  // Distance of nodes by which gaps and overlaps are judged. Elements of a body become short where that is needed, so
  // that narrow gaps beside it may be meant.
  double resolution() const override { return is_body_ ? 1e-3 * element_length_ : element_length_; }
  void add_size(scene::SizeEstimate& size) const override;
  void identify(Hash& hash) const override;
  std::unique_ptr<regions::Region> build(int id, const Preparation& preparation) const override;

 private:
  double element_length_;  // of a body: before halving
  bool is_body_ = false;
  Refinement refinement_;
  std::map<int, scene::EdgeMesh> own_mesh_;  // by edge number
  std::optional<Outline> whole_;             // before patches were cut out
  int whole_edges_ = 0;
};

// Description of a region with boundary elements, which the caller may change, as the scene is the caller's own; null
// for a region without them.
BoundaryDescription* boundary_in(scene::Scene& scene, int region);
bool is_body(const scene::Region& region);
bool has_bodies(const scene::Scene& scene);
int halvings_of(const scene::Region& region);
// Sets the refinement of all boundary element regions, and returns what it was.
Refinement refine(scene::Scene& scene, const Refinement& refinement);

// Adds a boundary element region with the outline `vertices` to the scene and returns its id; `bulges` make edges
// curved.
int add_boundary_region(scene::Scene& scene, int material, const std::vector<Point>& vertices, double element_length,
                        const std::vector<double>& bulges = {});
// Adds a body with such an outline: the library chooses its elements.
int add_body(scene::Scene& scene, int material, const std::vector<Point>& vertices,
             const std::vector<double>& bulges = {});
int add_boundary_disc(scene::Scene& scene, int material, const Point& centre, double radius, double element_length);

}  // namespace bempd::regions
