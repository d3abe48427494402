#pragma once

#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "crack/path.hpp"
#include "model/prepared_scene.hpp"
#include "regions/tips/tip_rings.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

// Crack lines (cracks that grow in lattices by steps) of a prepared scene: the bonds around them, their paths, and
// their stress intensity factors.
namespace bempd::model {

// Lattices of a prepared scene with the bonds that are intact at present, in the form that functions for cracks in
// bonds read.
regions::BondedBody bonded_body(const scene::Scene& scene, const PreparedScene& prepared);

// Path of a crack that cuts bonds. At an end that has grown, the described end point is replaced by the place where the
// first extension begins. An end in a lattice that has not grown lies at its effective tip.
std::vector<crack::PathVertex> path_in(const scene::Scene& scene, const PreparedScene& prepared, int crack);

// Stress intensity factors of a crack line's tip from contours (rings) around it; empty if no contour fits or the faces
// are closed.
std::optional<fracture::TipFactors> factors_around(const scene::Scene& scene, const scene::Options& options,
                                                   const PreparedScene& prepared, const fracture::GrowingTip& tip,
                                                   const coupling::Affine& displacement);

}  // namespace bempd::model
