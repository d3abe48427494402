#pragma once

#include "scene/place.hpp"

namespace bempd::regions {

// All of a region; loads on it are forces per volume [N/m^3], the same everywhere.
class WholeRegion final : public scene::Place {
 public:
  explicit WholeRegion(int region) : region_(region) {}

  void check(const scene::Scene& scene) const override;
  bool needs(int region) const override { return region == region_; }
  void identify(Hash& hash) const override {
    hash.add(std::string_view("whole region"));
    hash.add(region_);
  }
  std::vector<double> breaks_on(const scene::Scene&, int, int, double) const override { return {}; }
  bool covers(int, int, double) const override { return false; }
  std::vector<PlacedNode> held_nodes(const scene::Scene& scene, const Discretization& discretization,
                                     int support) const override;
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;

 private:
  int region_;
};

}  // namespace bempd::regions
