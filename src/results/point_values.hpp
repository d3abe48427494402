#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::results {

using FieldsOfScene = std::function<const regions::FieldValues&(int region, regions::Field)>;

struct PointValues {
  std::vector<regions::PointValue> values;
  std::int64_t kernel_evaluations = 0;
};

// Side from which a place is seen: as a part of the region with this id (0: any), and on a crack from which face.
struct Side {
  int region = 0;
  bool from_right = false;
};

// Computes displacement and, if asked for, stress at places in the body. Throws Error (argument) for a place outside.
PointValues evaluate(const scene::Scene& scene, const regions::Discretization& discretization,
                     const regions::Solution& solution, const FieldsOfScene& fields, const std::vector<Point>& places,
                     bool with_stress, const Side& side);

}  // namespace bempd::results
