#pragma once

#include "geometry/point.hpp"
#include "scene/place.hpp"

namespace bempd::regions {

// Single node or material point. The value of a load at the point is a force [N].
class SinglePoint final : public scene::Place {
 public:
  explicit SinglePoint(const Point& where) : where_(where) {}

  void check(const scene::Scene& scene) const override;
  std::optional<Point> point() const override { return where_; }
  void identify(Hash& hash) const override {
    hash.add(std::string_view("single point"));
    hash.add(where_.x()), hash.add(where_.y());
  }
  std::vector<double> breaks_on(const scene::Scene& scene, int region, int edge, double tolerance) const override;
  bool covers(int, int, double) const override { return false; }
  std::vector<PlacedNode> held_nodes(const scene::Scene& scene, const Discretization& discretization,
                                     int support) const override;
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;

 private:
  int node_in(const Discretization& discretization) const;

  Point where_;
};

}  // namespace bempd::regions
