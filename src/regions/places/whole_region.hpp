#pragma once

#include "elasticity/linear_body_force.hpp"
#include "regions/places/off_edges.hpp"

namespace bempd::regions {

// Whole region. The value of a load on the region is a uniform force per volume [N/m^3].
class WholeRegion : public OffEdges {
 public:
  explicit WholeRegion(int region) : region_(region) {}

  void check(const scene::Scene& scene) const override;
  bool needs(int region) const override { return region == region_; }
  void identify(Hash& hash) const override {
    hash.add(std::string_view("whole region"));
    hash.add(region_);
  }
  std::vector<PlacedNode> held_nodes(const scene::Scene& scene, const Discretization& discretization,
                                     int support) const override;
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;

 protected:
  // Body force for the value of a load; derived classes give the value another meaning.
  virtual BodyForce force(const Point& value) const { return value; }

 private:
  int region_;
};

}  // namespace bempd::regions
