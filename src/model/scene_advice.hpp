#pragma once

#include <string>
#include <vector>

#include "regions/discretization.hpp"
#include "scene/scene.hpp"

namespace bempd::model {

// Advice on a scene that is valid but may give results that the host does not expect.
struct Advice {
  std::vector<std::string> warnings;  // scenes that are too coarse, tips right before an edge, numbers of mixed units
  // Facts about each material that breaks: toughness, internal length, strain at first growth.
  std::vector<std::string> facts;
};

Advice advice_on(const scene::Scene& scene, const regions::Discretization& d);

}  // namespace bempd::model
