#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::results {

using FieldsOfScene = std::function<const regions::FieldValues&(int region, regions::Field)>;

struct PointValues {
  std::vector<regions::PointValue> values;
  std::int64_t kernel_evaluations = 0;
};

// Values at places in the body; stress only if asked for. Throws Error (argument) for a place outside.
PointValues evaluate(const scene::Scene& scene, const regions::Discretization& discretization,
                     const regions::Solution& solution, const FieldsOfScene& fields, const std::vector<Point>& places,
                     bool with_stress);

}  // namespace bempd::results
