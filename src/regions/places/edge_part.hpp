#pragma once

#include <map>

#include "geometry/edge.hpp"
#include "scene/place.hpp"

namespace bempd::regions {

// Part of an edge between two fractions of its length. The value of a load on the part is a traction [Pa].
class EdgePart : public scene::Place {
 public:
  EdgePart(int region, int edge, double from, double to) : region_(region), edge_(edge), from_(from), to_(to) {}

  void check(const scene::Scene& scene) const override;
  bool needs(int region) const override { return region == region_; }
  std::optional<std::pair<int, int>> edge() const override { return std::make_pair(region_, edge_); }
  void identify(Hash& hash) const override {
    hash.add(std::string_view("edge part"));
    hash.add(region_), hash.add(edge_), hash.add(from_), hash.add(to_);
  }
  std::vector<double> breaks_on(const scene::Scene& scene, int region, int edge, double tolerance) const override;
  // Nodes of the scene on this part of the edge, in order from its start.
  std::vector<PlacedNode> nodes(const scene::Scene& scene, const Discretization& discretization) const;
  // Integral of each node's shape function over this part of the edge, times the thickness [m2], by number of the node.
  std::map<int, double> weights(const scene::Scene& scene, const Discretization& discretization) const;
  bool covers(int region, int edge, double fraction) const override;
  std::vector<PlacedNode> held_nodes(const scene::Scene& scene, const Discretization& discretization,
                                     int support) const override;
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;

 protected:
  // Traction [Pa] at a fraction of the edge for the value of a load; derived classes give the value another meaning.
  virtual Point traction(const Edge& /*edge*/, double /*fraction*/, const Point& value) const { return value; }

  // Throws Error (argument) if this part of the edge touches another region: loads act on free edges only. `load` is
  // the load's index (from 0) for the error message.
  void require_free_edge(const scene::Scene& scene, const Discretization& discretization, int load) const;

 private:
  int region_, edge_;  // ids
  double from_, to_;   // fractions of the edge
};

}  // namespace bempd::regions
