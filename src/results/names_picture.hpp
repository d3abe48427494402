#pragma once

#include <vector>

#include "results/pictures.hpp"
#include "scene/names.hpp"

namespace bempd::results {

// Adds the host's names to a snapshot. Every part gets, as field data, the number of each named region, support and
// load under its name. A further part "edges" has a line for each edge and described crack and a point for each held or
// loaded point. Their names and those of the supports and loads there are texts, which some readers of VTK files do not
// know. Without names nothing is added.
void add_names(std::vector<PicturePart>& parts, const scene::Scene& scene, const scene::Names& names);

}  // namespace bempd::results
