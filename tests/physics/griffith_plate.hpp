// A crack of 2a = 80 spacings between two rows of a lattice, in a plate of boundary elements that carries the stresses
// of the infinite plane on its edges.
#pragma once

#include "westergaard.hpp"

namespace host {

inline constexpr int cells_in_half_crack = 40;
inline constexpr double half_crack = 1, dx = half_crack / cells_in_half_crack, toughness = 1;

// The tips lie midway between two columns of points and `shift` spacings ahead of there.
inline int32_t build_griffith_plate(Model& model, int horizon_ratio, double shift = 0) {
  const double outer = 4 * half_crack, x = half_crack + 14.5 * dx, y = 8.5 * dx;
  const CrackedPlane plane{half_crack};
  bempd_material solid = material(CrackedPlane::young, CrackedPlane::poisson);
  solid.fracture_energy = toughness;
  const int32_t id = model.add(solid);
  const int32_t plate = model.bem(id, rectangle(-outer, -outer, outer, outer), half_crack / 2);
  const int32_t first_edge = model.hole(plate, rectangular_hole(-x, -y, x, y));
  const int32_t lattice = model.pd(id, rectangle(-x, -y, x, y), dx, horizon_ratio);
  for (int32_t edge = 0; edge < 4; ++edge) model.mesh(plate, first_edge + edge, 2 * dx, 1);
  const double tip = half_crack + shift * dx;
  model.crack({{-tip, 0}, {tip, 0}});
  const Vector normals[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int32_t edge = 1; edge <= 4; ++edge)
    model.traction(plate, edge, [plane, n = normals[edge - 1]](double at_x, double at_y) {
      const auto s = plane.stress(at_x, at_y);
      return Vector{s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]};
    });
  model.fix_point({-outer, 0}, BEMPD_BOTH);
  model.fix_point({outer, 0}, BEMPD_Y);
  return lattice;
}

}  // namespace host
