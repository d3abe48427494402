#pragma once

#include <memory>
#include <optional>

#include "geometry/outline.hpp"
#include "hash.hpp"
#include "scene/size_estimate.hpp"

namespace bempd::regions {
class Region;
struct Preparation;
}  // namespace bempd::regions

namespace bempd::scene {

// Elements that an edge is to have.
struct EdgeMesh {
  double element_length;
  double grading;
};

// Lattice of places where a region has its nodes: origin + spacing * (i, j) with whole numbers i and j.
struct NodeGrid {
  Point origin;
  double spacing;
};

// Region as the host described it: a material, an outline, and what its kind adds. Edges are numbered from 1 through
// the outer loop and then the holes.
//
// Where the region shares a piece of an edge with another one, it has either nodes at fixed places, which the other one
// must follow (node_grid), or element ends that can be negotiated (edge_mesh).
class Region {
 public:
  Region(int material, Outline outline) : material_(material), outline_(std::move(outline)) {}
  virtual ~Region() = default;

  int material() const { return material_; }  // id
  const Outline& outline() const { return outline_; }
  int edge_count() const;
  Edge edge(int number) const { return outline_.edge(number - 1); }

  // Name of the kind in sentences: "peridynamic".
  virtual const char* adjective() const = 0;

  // Takes over a sound outline. If the kind cannot have it, throws Error (argument) and the region stays as it was.
  virtual void set_outline(Outline outline) { take_outline(std::move(outline)); }

  // Whether edges are divided into elements.
  virtual bool has_elements() const { return false; }
  virtual bool may_be_curved() const { return has_elements(); }
  // Sets the host's choice of the elements of an edge; called where has_elements().
  virtual void set_edge_mesh(int /*edge*/, const EdgeMesh& /*mesh*/) {}
  // Whether the host has chosen this edge's elements: then they need not match the nodes of a neighbour's grid.
  virtual bool has_own_mesh(int /*edge*/) const { return false; }

  virtual std::optional<NodeGrid> node_grid() const { return std::nullopt; }
  // Elements that the region wants on an edge; asked for where it has no grid of nodes.
  virtual EdgeMesh edge_mesh(int /*edge*/) const { return {outline_size(), 1.0}; }

  // Distance between the region's nodes, where the host has not chosen another one for an edge.
  virtual double resolution() const { return node_grid() ? node_grid()->spacing : outline_size(); }

  virtual void add_size(SizeEstimate& /*size*/) const {}

  // Adds the region to the fingerprint of the scene, in the words of the host. Computed values stay out: their last
  // digits depend on the processor.
  virtual void identify(Hash& hash) const;

  // Builds the region of the layer `regions`, which makes operators on nodes of this description; it has none yet.
  virtual std::unique_ptr<regions::Region> build(int id, const regions::Preparation& preparation) const = 0;

 protected:
  void take_outline(Outline outline) { outline_ = std::move(outline); }

 private:
  double outline_size() const { return bounding_box(outline_).diagonal().norm(); }

  int material_;
  Outline outline_;
};

}  // namespace bempd::scene
