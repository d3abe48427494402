#pragma once

#include <vector>

#include "regions/discretization.hpp"

namespace bempd::results {

using FieldsOfScene = std::function<const regions::FieldValues&(int region, regions::Field)>;

struct PointValues {
  std::vector<regions::PointValue> values;
  std::int64_t kernel_evaluations = 0;
};

// Side from which a place is seen: the region (id; 0: any) that the place belongs to, and the face if the place lies on
// a crack.
struct Side {
  int region = 0;
  bool from_right = false;
};

// Computes displacement and, if asked for, stress at places in the body. Throws Error (argument) for a place outside
// the body.
PointValues evaluate(const scene::Scene& scene, const regions::Discretization& discretization,
                     const regions::Solution& solution, const FieldsOfScene& fields, const std::vector<Point>& places,
                     bool with_stress, const Side& side);

}  // namespace bempd::results
