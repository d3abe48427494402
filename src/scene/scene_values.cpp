#include "scene/scene_values.hpp"

#include <algorithm>

namespace bempd::scene {

namespace {

// The straight line through two values at two load factors: constant + load factor * proportional.
class Line {
 public:
  Line(double from, double to) : from_(from), to_(to) {}

  BoundaryValue operator()(const BoundaryValue& start, const BoundaryValue& end) const {
    const Point first = start.constant + from_ * start.proportional, last = end.constant + to_ * end.proportional;
    const Point slope = (last - first) / (to_ - from_);
    return {first - from_ * slope, slope};
  }

  SampledValues operator()(const SampledValues& start, const SampledValues& end) const {
    SampledValues line = end;
    for (std::size_t i = 0; i < end.constant.size(); ++i) {
      const auto value = [i](const SampledValues& values) {
        return BoundaryValue{Point::Constant(values.constant[i]), Point::Constant(values.proportional[i])};
      };
      const BoundaryValue between = (*this)(value(start), value(end));
      line.constant[i] = between.constant.x();
      line.proportional[i] = between.proportional.x();
    }
    return line;
  }

  Values operator()(const Values& start, const Values& end) const {
    if (const auto* samples = std::get_if<SampledValues>(&end))
      return (*this)(std::get<SampledValues>(start), *samples);
    return BoundaryFunction(
        [line = *this, first = std::get<BoundaryFunction>(start),
         last = std::get<BoundaryFunction>(end)](const Point& p) { return line(first(p), last(p)); });
  }

  std::vector<Values> operator()(const std::vector<Values>& start, const std::vector<Values>& end) const {
    std::vector<Values> all;
    for (std::size_t i = 0; i < end.size(); ++i) all.push_back((*this)(start[i], end[i]));
    return all;
  }

 private:
  double from_, to_;
};

std::vector<Values> zeros(const std::vector<Values>& like) {
  std::vector<Values> all;
  for (const Values& values : like) {
    if (const auto* samples = std::get_if<SampledValues>(&values)) {
      const std::vector<double> none(samples->constant.size(), 0.0);
      all.push_back(SampledValues{none, none});
    } else {
      all.push_back(BoundaryFunction([](const Point&) { return BoundaryValue{}; }));
    }
  }
  return all;
}

}  // namespace

bool are_alike(const Values& one, const Values& other) {
  const auto* samples = std::get_if<SampledValues>(&one);
  const auto* others = std::get_if<SampledValues>(&other);
  if (samples && others) return samples->constant.size() == others->constant.size();
  const auto* function = std::get_if<BoundaryFunction>(&one);
  return function && *function && !others;
}

SceneValues at_rest(const SceneValues& like) { return {zeros(like.supports), zeros(like.loads)}; }

SceneValues line_between(const SceneValues& start, double from, const SceneValues& end, double to) {
  const Line line(from, to);
  return {line(start.supports, end.supports), line(start.loads, end.loads)};
}

}  // namespace bempd::scene
