#pragma once

#include <vector>

#include "results/pictures.hpp"
#include "scene/names.hpp"

namespace bempd::results {

// Adds the host's names to a snapshot. Every part gets, as field data, the number of each named region, support and
// load under its name. A further part "edges" has a line for each edge and described crack, and a point for each held
// or loaded point; the names of edges and their regions, and of the supports and loads there, are texts, which some
// readers of VTK files do not know. If the host gave no names, nothing is added.
void add_names(std::vector<PicturePart>& parts, const scene::Scene& scene, const scene::Names& names);

}  // namespace bempd::results
