#pragma once

#include <optional>
#include <span>
#include <vector>

#include "crack/extension.hpp"
#include "regions/patches_back.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

struct PreparedScene;

// Layout of patches in which blocks behind a crack line are elements again. These carry the crack there, so its path
// in the scene goes on to its tips.
struct ShorterPatches {
  regions::GivenBack layout;
  std::vector<scene::Crack> cracks;  // of the scene, with the longer one
  int crack;                         // id of that one
  std::vector<Point> path;           // its whole one, of which the scene needs fewer points
};

// What a patch can give back behind the line that has grown last, by the scene's cracks, all extensions so far, and
// patches that may not be in the scene yet. Empty if that is nothing.
std::optional<ShorterPatches> shorter_patches(const scene::Scene& scene, const std::vector<regions::Patch>& patches,
                                              std::span<const crack::Extension> extensions);

// Whether no intact bond joins the two faces of the crack in the blocks that are to be given back, and nothing else is
// broken, held or without its loads there.
bool has_separated_faces(const PreparedScene& prepared, const ShorterPatches& back);

}  // namespace bempd::model
