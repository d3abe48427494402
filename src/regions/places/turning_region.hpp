#pragma once

#include "regions/places/whole_region.hpp"

namespace bempd::regions {

// Whole region that rotates about an axis. The x component of a load's value is the centrifugal force per volume and
// per distance from the axis: density times angular velocity squared [N/m^4].
class TurningRegion final : public WholeRegion {
 public:
  TurningRegion(int region, const Point& axis) : WholeRegion(region), axis_(axis) {}

  void check(const scene::Scene& scene) const override;
  void identify(Hash& hash) const override {
    hash.add(std::string_view("turning region"));
    hash.add(axis_.x()), hash.add(axis_.y());
    WholeRegion::identify(hash);
  }

 protected:
  BodyForce force(const Point& value) const override { return {-value.x() * axis_, value.x()}; }

 private:
  Point axis_;
};

}  // namespace bempd::regions
