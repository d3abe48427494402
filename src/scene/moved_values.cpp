#include "scene/moved_values.hpp"

namespace bempd::scene {

namespace {

// Adds the proportional part at a load factor to the constant part.
template <class Listed>
Values moved_by(const Listed& values, double load_factor) {
  Listed moved = values;
  for (std::size_t k = 0; k < moved.constant.size(); ++k) moved.constant[k] += load_factor * moved.proportional[k];
  return moved;
}

Values moved_by(const BoundaryFunction& function, double load_factor) {
  return BoundaryFunction([function, load_factor](const Point& place, double fraction) {
    BoundaryValue value = function(place, fraction);
    value.constant += load_factor * value.proportional;
    return value;
  });
}

}  // namespace

SceneValues moved(const SceneValues& values, double load_factor) {
  const auto move_all = [&](const std::vector<Values>& all) {
    std::vector<Values> moved;
    for (const Values& one : all)
      moved.push_back(std::visit([&](const auto& v) { return moved_by(v, load_factor); }, one));
    return moved;
  };
  return {move_all(values.supports), move_all(values.loads)};
}

}  // namespace bempd::scene
