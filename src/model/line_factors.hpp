#pragma once

#include <optional>
#include <vector>

#include "coupling/affine.hpp"
#include "crack/path.hpp"
#include "model/prepared_scene.hpp"
#include "regions/tips/tip_rings.hpp"
#include "regions/tips/tip_search.hpp"
#include "scene/options.hpp"
#include "scene/scene.hpp"

// Crack lines of a prepared scene: the bonds around them, their paths, and their factors.
namespace bempd::model {

// Lattices of the scene in their present state, as functions about cracks in bonds read it.
regions::BondedBody bonded_body(const scene::Scene& scene, const PreparedScene& prepared);

// Path of a crack that cuts bonds. An end that has grown lies where its cut ended; an end that has not grown lies at
// its effective tip.
std::vector<crack::PathVertex> path_in(const scene::Scene& scene, const PreparedScene& prepared, int crack);

// Stress intensity factors of a tip by sums around it, for the run itself; empty if no sum has room.
std::optional<fracture::TipFactors> factors_around(const scene::Scene& scene, const scene::Options& options,
                                                   const PreparedScene& prepared, const fracture::GrowingTip& tip,
                                                   const coupling::Affine& displacement);

}  // namespace bempd::model
