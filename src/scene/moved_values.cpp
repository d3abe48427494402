#include "scene/moved_values.hpp"

namespace bempd::scene {

namespace {

// Adds the proportional part at a load factor to the constant part, and takes the proportional part away if `fixes`.
struct Move {
  double load_factor;
  bool fixes;

  void operator()(double& constant, double& proportional) const {
    constant += load_factor * proportional;
    if (fixes) proportional = 0;
  }

  template <class Listed>
  Values operator()(Listed values) const {
    for (std::size_t k = 0; k < values.constant.size(); ++k) (*this)(values.constant[k], values.proportional[k]);
    return values;
  }

  Values operator()(const BoundaryFunction& function) const {
    return BoundaryFunction([function, move = *this](const Point& place, double fraction) {
      BoundaryValue value = function(place, fraction);
      for (const int component : {0, 1}) move(value.constant[component], value.proportional[component]);
      return value;
    });
  }

  SceneValues operator()(const SceneValues& values) const {
    SceneValues all = values;
    for (std::vector<Values>* list : {&all.supports, &all.loads})
      for (Values& one : *list) one = std::visit(*this, one);
    return all;
  }
};

}  // namespace

SceneValues moved(const SceneValues& values, double load_factor) { return Move{load_factor, false}(values); }

Values fixed_at(const Values& values, double load_factor) { return std::visit(Move{load_factor, true}, values); }

SceneValues fixed_at(const SceneValues& values, double load_factor) { return Move{load_factor, true}(values); }

}  // namespace bempd::scene
