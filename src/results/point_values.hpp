#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::results {

using FieldsOfScene = std::function<const regions::FieldValues&(int region, regions::Field)>;

struct PointValues {
  std::vector<regions::PointValue> values;
  std::int64_t kernel_evaluations = 0;
};

// Side from which a place is looked at: as part of one region, 0 for any; on a crack from its right face.
struct Side {
  int region = 0;
  bool from_right = false;
};

// Values at places in the body; stress only if asked for. Throws Error (argument) for a place outside.
PointValues evaluate(const scene::Scene& scene, const regions::Discretization& discretization,
                     const regions::Solution& solution, const FieldsOfScene& fields, const std::vector<Point>& places,
                     bool with_stress, const Side& side);

}  // namespace bempd::results
