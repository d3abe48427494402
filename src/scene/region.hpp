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

// Wanted elements of an edge.
struct EdgeMesh {
  double element_length;
  double grading;
};

// Places where a region has nodes and nowhere else: origin + spacing * (i, j) with whole numbers i and j.
struct NodeGrid {
  Point origin;
  double spacing;
};

// A region as the host described it: a material, an outline, and what its kind adds. Edges are numbered from 1 through
// the outer loop and then the holes.
//
// Where it shares a piece of an edge with another region it either has nodes at fixed places that the other one must
// follow (node_grid), or element ends that can be negotiated (edge_mesh).
class Region {
 public:
  Region(int material, Outline outline) : material_(material), outline_(std::move(outline)) {}
  virtual ~Region() = default;

  int material() const { return material_; }  // id
  const Outline& outline() const { return outline_; }
  int edge_count() const;
  Edge edge(int number) const { return outline_.edge(number - 1); }

  // The kind in sentences: "peridynamic".
  virtual const char* adjective() const = 0;

  // Takes over a sound outline. Throws Error (argument) if the kind cannot have it, and stays as it was.
  virtual void set_outline(Outline outline) { take_outline(std::move(outline)); }

  // Whether edges are divided into elements.
  virtual bool has_elements() const { return false; }
  virtual bool may_be_curved() const { return has_elements(); }
  // The host's choice of the elements of an edge; asked for where has_elements().
  virtual void set_edge_mesh(int /*edge*/, const EdgeMesh& /*mesh*/) {}
  // The host has chosen this edge's elements; they need not match the nodes of a neighbour's grid then.
  virtual bool has_own_mesh(int /*edge*/) const { return false; }

  virtual std::optional<NodeGrid> node_grid() const { return std::nullopt; }
  // The elements it wants on an edge; asked for where it has no grid of nodes.
  virtual EdgeMesh edge_mesh(int /*edge*/) const { return {outline_size(), 1.0}; }

  // Length between its nodes, where the host has not chosen another for an edge.
  virtual double resolution() const { return node_grid() ? node_grid()->spacing : outline_size(); }

  virtual void add_size(SizeEstimate& /*size*/) const {}

  // Adds what the host has said of it. What is computed stays out: its last digits depend on the processor.
  virtual void identify(Hash& hash) const;

  // The region as operators on nodes, still without them.
  virtual std::unique_ptr<regions::Region> build(int id, const regions::Preparation& preparation) const = 0;

 protected:
  void take_outline(Outline outline) { outline_ = std::move(outline); }

 private:
  double outline_size() const { return bounding_box(outline_).diagonal().norm(); }

  int material_;
  Outline outline_;
};

}  // namespace bempd::scene
