#pragma once

#include <optional>
#include <span>
#include <vector>

#include "crack/extension.hpp"
#include "regions/patches_back.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

struct PreparedScene;

// Layout of lattice patches (lattices inside a body, made of square blocks) in which blocks behind a crack line are
// boundary elements again. These elements carry the crack there, so that the crack of the scene then reaches to the
// present tips of the line.
struct ShorterPatches {
  regions::GivenBack layout;
  std::vector<scene::Crack> cracks;  // cracks of the scene, with the longer crack
  int crack;                         // id of the longer crack
  std::vector<Point> path;           // whole path of the longer crack, of which the scene needs fewer points
};

// Layout in which patches give blocks back behind the crack line that has grown last; empty if there is none.
// `extensions` are all extensions so far; `patches` need not be in the scene yet.
std::optional<ShorterPatches> shorter_patches(const scene::Scene& scene, const std::vector<regions::Patch>& patches,
                                              std::span<const crack::Extension> extensions);

// Whether the crack faces are separated in the blocks that are to be given back: no intact bond joins the faces, no
// other bond in these blocks is broken or damaged, and no node in them is held or freed from its loads.
bool has_separated_faces(const PreparedScene& prepared, const ShorterPatches& back);

}  // namespace bempd::model
