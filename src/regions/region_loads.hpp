#pragma once

#include <array>
#include <functional>
#include <vector>

#include "elasticity/linear_body_force.hpp"
#include "geometry/edge.hpp"
#include "regions/fields.hpp"

namespace bempd::regions {

// Part of an edge of a region, between the fractions `from` and `to` of its length.
struct EdgeSpan {
  int edge;  // number in its region
  Edge geometry;
  double from, to;
};

// Node of the scene on a part of an edge, with its place as a fraction of the part.
struct PlacedNode {
  int node;
  double fraction;
};

// Nodes of a region at which supports and loads act, and the nodal forces of loads.
class RegionLoads {
 public:
  virtual ~RegionLoads() = default;

  // Nodes on a part of an edge, including its ends.
  virtual std::vector<PlacedNode> nodes_on(const EdgeSpan& span, double tolerance) const = 0;
  // Adds nodal forces [N] of a traction [Pa] on a part of a free edge to entries 2 * scene node + component.
  virtual void add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                            Eigen::Ref<Eigen::VectorXd> force) const = 0;
  // Force [N] that the tractions on an edge make at each of some nodes. Edges that meet at a node share the node's
  // reaction in the ratio of these forces.
  virtual std::vector<Point> forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                            const FieldsOfRegion& fields) const = 0;
  // Adds nodal forces [N] of a body force to `force`.
  virtual void add_body_force(const BodyForce& body_force, Eigen::Ref<Eigen::VectorXd> force) const = 0;
  // Work [J] of loads inside the region (body forces, tractions on cracks) that nodal forces do not include. Entry (i,
  // j) is the work of part i of the loads on part j of the displacements; part 0 is constant, part 1 proportional.
  virtual Eigen::Matrix2d work_within(const std::array<BodyForce, 2>& /*body_force*/,
                                      const std::vector<CrackLoad>& /*crack_loads*/) const {
    return Eigen::Matrix2d::Zero();
  }
};

}  // namespace bempd::regions
