#pragma once

#include <vector>

#include "results/pictures.hpp"
#include "scene/names.hpp"

namespace bempd::results {

// Adds what a snapshot shows of names: to the field data of every part the number of each named region, support and
// load under its name, and a part "edges" behind the others. That part has a line for each edge and described crack and
// a point for each held or loaded point, with their names and those of the supports and loads there as text, which some
// readers of such files do not know. Without names nothing is added.
void add_names(std::vector<PicturePart>& parts, const scene::Scene& scene, const scene::Names& names);

}  // namespace bempd::results
