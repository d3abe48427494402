#pragma once

#include "regions/places/crack_faces.hpp"

namespace bempd::regions {

// Faces of a crack under a uniform pressure, which pushes the faces apart and also acts on faces that growth of the
// crack adds. The pressure is the x component of a load's value [Pa]. The crack may run in boundary elements and in
// lattices.
class PressedCrack final : public CrackFaces {
 public:
  using CrackFaces::CrackFaces;

  void identify(Hash& hash) const override;
  void add_load(const scene::Scene& scene, const Discretization& discretization, int load,
                DofConditions& conditions) const override;
};

}  // namespace bempd::regions
