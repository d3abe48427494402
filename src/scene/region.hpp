#pragma once

#include <memory>
#include <optional>

#include "geometry/outline.hpp"
#include "geometry/scattered_field.hpp"
#include "hash.hpp"
#include "scene/size_estimate.hpp"

namespace bempd::regions {
class Region;
struct Preparation;
}  // namespace bempd::regions

namespace bempd::scene {

// Elements requested for an edge: their length, and the factor by which the length grows from element to element away
// from the edge's ends.
struct EdgeMesh {
  double element_length;
  double grading;
};

// Grid of places at which a region has its nodes: origin + spacing * (i, j) with integers i and j.
struct NodeGrid {
  Point origin;
  double spacing;
};

// Region as the host described it: a material, an outline, and what the kind of region adds. Edges are numbered from 1,
// through the outer loop and then the holes.
// Where two regions share a piece of an edge, a region has either nodes at fixed places, which the other region must
// follow (node_grid), or element ends that can be negotiated (edge_mesh).
class Region {
 public:
  Region(int material, Outline outline) : material_(material), outline_(std::move(outline)) {}
  virtual ~Region() = default;

  int material() const { return material_; }  // id
  // Id of the region of which this region is a part, so that loads on the whole also act here; 0: it is no part.
  int part_of() const { return part_of_; }
  void make_part_of(int region) { part_of_ = region; }
  const Outline& outline() const { return outline_; }
  int edge_count() const;
  Edge edge(int number) const { return outline_.edge(number - 1); }

  // Name of the kind of region for messages, such as "peridynamic".
  virtual const char* adjective() const = 0;

  // Replaces the outline by a sound one. Throws Error (argument) and leaves the region as it was if a region of this
  // kind cannot have the outline.
  virtual void set_outline(Outline outline) { take_outline(std::move(outline)); }

  // Whether the region's edges are divided into elements.
  virtual bool has_elements() const { return false; }
  virtual bool may_be_curved() const { return has_elements(); }
  // Sets the elements of an edge as the host has chosen them; only for regions that have elements.
  virtual void set_edge_mesh(int /*edge*/, const EdgeMesh& /*mesh*/) {}
  // Whether the host has chosen the elements of this edge, which then need not match the grid nodes of a neighbour.
  virtual bool has_own_mesh(int /*edge*/) const { return false; }

  virtual std::optional<NodeGrid> node_grid() const { return std::nullopt; }
  // Elements that the region requests on an edge; only for regions without a grid of nodes.
  virtual EdgeMesh edge_mesh(int /*edge*/) const { return {outline_size(), 1.0}; }

  // Distance between the region's nodes, unless the host has chosen another one for an edge.
  virtual double resolution() const { return node_grid() ? node_grid()->spacing : outline_size(); }

  // Fracture energy by place [J/m^2], in place of the material's; null: the fracture energy of the material holds
  // everywhere.
  const std::shared_ptr<const ScatteredField>& fracture_energies() const { return fracture_energies_; }
  void set_fracture_energies(std::shared_ptr<const ScatteredField> energies) {
    fracture_energies_ = std::move(energies);
  }

  virtual void add_size(SizeEstimate& /*size*/) const {}

  // Adds the region, as the host described it, to the fingerprint of the scene. Computed values stay out or are
  // rounded, because their last digits depend on the processor.
  virtual void identify(Hash& hash) const;

  // Builds the region of the layer src/regions from this description, without nodes and operators, which are made
  // later.
  virtual std::unique_ptr<regions::Region> build(int id, const regions::Preparation& preparation) const = 0;

 protected:
  void take_outline(Outline outline) { outline_ = std::move(outline); }
  void exchange_outlines(Region& other) noexcept { std::swap(outline_, other.outline_); }

 private:
  double outline_size() const { return bounding_box(outline_).diagonal().norm(); }

  int material_;
  int part_of_ = 0;
  Outline outline_;
  std::shared_ptr<const ScatteredField> fracture_energies_;
};

// Throws Error (argument) if the region number `id` does not have the edge.
void require_edge(const Region& region, int id, int edge);

}  // namespace bempd::scene
