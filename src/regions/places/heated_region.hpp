#pragma once

#include "regions/places/off_edges.hpp"

namespace bempd::regions {

// Whole region that is heated: the x component of a load's value is the change of its temperature [K].
class HeatedRegion final : public OffEdges {
 public:
  explicit HeatedRegion(int region) : region_(region) {}

  void check(const scene::Scene& scene) const override;
  bool needs(int region) const override { return region == region_; }
  bool is_built_in() const override { return true; }
  void identify(Hash& hash) const override {
    hash.add(std::string_view("heated region"));
    hash.add(region_);
  }
  std::vector<PlacedNode> held_nodes(const scene::Scene& scene, const Discretization& discretization,
                                     int support) const override;
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;

 private:
  int region_;
};

}  // namespace bempd::regions
