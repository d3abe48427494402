#pragma once

#include "geometry/boundary_mesh.hpp"
#include "scene/options.hpp"

namespace bempd::model {

// How regions become equations. The scheme `symmetric` has no choices; the others belong to the scheme `paper` (Yang
// and Liu, Int. J. Solids Struct. 2021): collocation, uncorrected bonds, coupling by shared nodes.
struct Formulation {
  bool paper = false;
  // Material points are the centres of the cells, and points of their own on interfaces; else the corners of the cells.
  bool cell_centred = false;
  // Interface rows are t = -b dx of every node and its point (Eqs. 26, 27); else the balance of nodal forces.
  bool pointwise_traction = false;
  CornerTractions corner_tractions = CornerTractions::two;
  // Elements become smaller towards places where stress is singular; never in scheme `paper`.
  bool grade_corners = false;
  bool printed_critical_stretch = false;  // Eq. 15 as printed; else the exact constant

  static Formulation from(const Options& options);
};

}  // namespace bempd::model
