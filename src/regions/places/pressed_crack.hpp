#pragma once

#include "regions/places/crack_faces.hpp"

namespace bempd::regions {

// Two faces of a crack and of all its growth, in either kind of region, pushed apart by a uniform pressure (component
// x of a condition) [Pa].
class PressedCrack final : public CrackFaces {
 public:
  using CrackFaces::CrackFaces;

  void identify(Hash& hash) const override;
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;
};

}  // namespace bempd::regions
