#include "scene/scene_values.hpp"

#include <algorithm>
#include <iterator>

namespace bempd::scene {

namespace {

bool is_function(const Values& values) { return std::holds_alternative<BoundaryFunction>(values); }

// Values at places along a boundary part. Samples get equally spaced places; values that already have places are
// returned as they are.
PlacedValues placed(const Values& values) {
  if (const auto* already = std::get_if<PlacedValues>(&values)) return *already;
  const auto& samples = std::get<SampledValues>(values);
  const std::size_t count = samples.constant.size();
  PlacedValues result;
  for (std::size_t i = 0; i < count; ++i) {
    result.fractions.push_back(count == 1 ? 0 : static_cast<double>(i) / static_cast<double>(count - 1));
    result.constant.insert(result.constant.end(), 2, samples.constant[i]);
    result.proportional.insert(result.proportional.end(), 2, samples.proportional[i]);
  }
  return result;
}

BoundaryFunction function_of(const Values& values) {
  if (const auto* function = std::get_if<BoundaryFunction>(&values)) return *function;
  return [known = placed(values)](const Point&, double fraction) { return known.at(fraction); };
}

// Line through values at two load factors: constant part and proportional part of the values that are linear in the
// load factor, equal to `start` at one load factor and to `end` at the other.
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

  PlacedValues operator()(const PlacedValues& start, const PlacedValues& end) const {
    PlacedValues line;
    std::set_union(start.fractions.begin(), start.fractions.end(), end.fractions.begin(), end.fractions.end(),
                   std::back_inserter(line.fractions));
    for (const double fraction : line.fractions) {
      const BoundaryValue between = (*this)(start.at(fraction), end.at(fraction));
      line.constant.insert(line.constant.end(), {between.constant.x(), between.constant.y()});
      line.proportional.insert(line.proportional.end(), {between.proportional.x(), between.proportional.y()});
    }
    return line;
  }

  Values operator()(const Values& start, const Values& end) const {
    const auto* first = std::get_if<SampledValues>(&start);
    const auto* last = std::get_if<SampledValues>(&end);
    if (first && last && first->constant.size() == last->constant.size()) return (*this)(*first, *last);
    if (!is_function(start) && !is_function(end)) return (*this)(placed(start), placed(end));
    return BoundaryFunction([line = *this, from = function_of(start), to = function_of(end)](
                                const Point& p, double fraction) { return line(from(p, fraction), to(p, fraction)); });
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
    } else if (const auto* at_places = std::get_if<PlacedValues>(&values)) {
      const std::vector<double> none(at_places->constant.size(), 0.0);
      all.push_back(PlacedValues{at_places->fractions, none, none});
    } else {
      all.push_back(BoundaryFunction([](const Point&, double) { return BoundaryValue{}; }));
    }
  }
  return all;
}

}  // namespace

bool are_alike(const Values& one, const Values& other) {
  const auto* samples = std::get_if<SampledValues>(&one);
  const auto* others = std::get_if<SampledValues>(&other);
  const auto are_none = [](const SampledValues* s) { return s && s->constant.empty(); };  // a removed condition
  if (are_none(samples) || are_none(others)) return are_none(samples) && are_none(others);
  if (samples && others) return samples->constant.size() == others->constant.size();
  const auto* function = std::get_if<BoundaryFunction>(&one);
  return function ? *function && !others : true;
}

SceneValues at_rest(const SceneValues& like) { return {zeros(like.supports), zeros(like.loads)}; }

SceneValues line_between(const SceneValues& start, double from, const SceneValues& end, double to) {
  const Line line(from, to);
  return {line(start.supports, end.supports), line(start.loads, end.loads)};
}

}  // namespace bempd::scene
