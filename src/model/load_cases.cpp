#include "model/load_cases.hpp"

#include <algorithm>

#include "error.hpp"
#include "model/element_growth.hpp"
#include "model/model.hpp"
#include "scene/moved_values.hpp"

namespace bempd::model {

namespace {

// Adds values at the load factor 1, times a factor, to the constant part of a sum with the same samples or places.
template <class Kind>
void add(Kind& sum, const Kind& values, double factor) {
  for (std::size_t k = 0; k < sum.constant.size(); ++k)
    sum.constant[k] += factor * values.constant[k] + factor * values.proportional[k];
}

// Sum of values of one support or load, each times a factor. If all values are of the same kind as `zero` (samples or
// places), so is the sum; else the sum is a function.
class Sum {
 public:
  explicit Sum(scene::Values zero) : sum_(std::move(zero)) {}

  void add(const scene::Values& values, double factor) {
    const auto* function = std::get_if<scene::BoundaryFunction>(&values);
    if (sum_.index() != values.index() || function) {
      terms_.emplace_back(as_function(values), factor);
      return;
    }
    std::visit(
        [&](auto& sum) {
          using Kind = std::decay_t<decltype(sum)>;
          if constexpr (!std::is_same_v<Kind, scene::BoundaryFunction>) model::add(sum, std::get<Kind>(values), factor);
        },
        sum_);
  }

  scene::Values result() const {
    if (terms_.empty()) return sum_;
    return scene::BoundaryFunction([terms = terms_, rest = as_function(sum_)](const Point& place, double fraction) {
      scene::BoundaryValue value{rest(place, fraction).constant, Point::Zero()};
      for (const auto& [function, factor] : terms) {
        const scene::BoundaryValue own = function(place, fraction);
        value.constant += factor * own.constant + factor * own.proportional;
      }
      return value;
    });
  }

 private:
  static scene::BoundaryFunction as_function(const scene::Values& values) {
    if (const auto* function = std::get_if<scene::BoundaryFunction>(&values)) return *function;
    scene::Condition condition;
    condition.values = values;
    return [condition](const Point& place, double fraction) { return condition.value(place, fraction); };
  }

  scene::Values sum_;
  std::vector<std::pair<scene::BoundaryFunction, double>> terms_;
};

// Values of all supports, or of all loads, under a combination of cases. `part` gives the values of a support or load
// in a case, and the factor of the case.
template <class Part>
std::vector<scene::Values> combined_of(const std::vector<scene::Values>& zeros, std::size_t cases, const Part& part) {
  std::vector<scene::Values> all;
  for (std::size_t k = 0; k < zeros.size(); ++k) {
    Sum sum(zeros[k]);
    for (std::size_t c = 0; c < cases; ++c) {
      const auto [values, factor] = part(c, k);
      if (values && factor != 0) sum.add(*values, factor);
    }
    all.push_back(sum.result());
  }
  return all;
}

// Tip under a combination, with load factors of growth as if the combination acted in proportion to a load factor that
// is 1 now.
regions::TipValues in_proportion(regions::TipValues tip, const scene::Options& options) {
  tip.constant_factors = Point::Zero(), tip.proportional_factors = tip.factors;
  complete(tip, options);
  return tip;
}

}  // namespace

int LoadCases::add(const std::vector<int>& loads, const std::vector<int>& supports) {
  const scene::Scene& scene = model_.scene();
  require(!loads.empty() || !supports.empty(), "the case has neither loads nor supports; give at least one");
  Case added;
  for (const int id : loads) {
    scene.load(id);  // throws without it
    require(added.loads.insert(id).second, "load ", id, " is in the case twice; give each once");
  }
  for (const int id : supports) {
    scene.support(id);
    require(added.supports.insert(id).second, "support ", id, " is in the case twice; give each once");
  }
  added.values = scene.values();
  cases_.push_back(std::move(added));
  return count();
}

scene::SceneValues LoadCases::combined(const std::vector<double>& factors) const {
  const scene::SceneValues zeros = scene::at_rest(model_.scene().values());
  using Part = std::pair<const scene::Values*, double>;
  const auto value = [](const std::vector<scene::Values>& of, const std::set<int>& in, std::size_t number) {
    return number < of.size() && in.contains(static_cast<int>(number) + 1) ? &of[number] : nullptr;
  };
  scene::SceneValues sum;
  sum.loads = combined_of(zeros.loads, factors.size(), [&](std::size_t c, std::size_t k) {
    return Part(value(cases_[c].values.loads, cases_[c].loads, k), factors[c]);
  });
  sum.supports = combined_of(zeros.supports, factors.size(), [&](std::size_t c, std::size_t k) {
    return Part(value(cases_[c].values.supports, cases_[c].supports, k), factors[c]);
  });
  return sum;
}

void LoadCases::solve_under(const std::vector<double>& factors, const std::function<void(PreparedScene&)>& read) {
  require(!factors.empty() && factors.size() <= cases_.size(), "there are ", factors.size(), " factors and ",
          cases_.size(), " load cases; give a factor for each case, in the order of their ids");
  for (std::size_t c = 0; c < factors.size(); ++c)
    require(std::isfinite(factors[c]), "the factor of load case ", c + 1, " is ", factors[c],
            "; it must be a finite number");
  solve_under(combined(factors), read);
}

void LoadCases::solve_at(double load_factor, const std::function<void(PreparedScene&)>& read) {
  solve_under(scene::fixed_at(model_.scene().values(), load_factor), read);
}

void LoadCases::solve_under(const scene::SceneValues& values, const std::function<void(PreparedScene&)>& read) {
  model_.prepare();
  model_.loads().under(values, read);
}

const LoadCases::Solved& LoadCases::under(const std::vector<double>& factors) {
  if (known_generation_ == model_.generation() && known_factors_ == factors) return known_;
  Solved solved;
  solve_under(factors, [&](PreparedScene& scene) {
    for (const regions::TipValues& tip : model_.cracks().present_tips())
      solved.tips.push_back(in_proportion(tip, model_.options()));
    for (std::size_t s = 0; s < model_.scene().supports().size(); ++s)
      solved.reactions.push_back(model_.scene().supports()[s].removed()
                                     ? Eigen::Vector2d::Zero()
                                     : scene.evolution->body().supports().reaction(s));
    const std::vector<char>& closed = scene.system->constraints().closed();
    solved.pressed = std::count(closed.begin(), closed.end(), 1);
  });
  known_ = std::move(solved), known_factors_ = factors, known_generation_ = model_.generation();
  return known_;
}

std::vector<regions::PointValue> LoadCases::evaluate(const std::vector<double>& factors,
                                                     const std::vector<Point>& places, bool with_stress) {
  std::vector<regions::PointValue> found;
  solve_under(factors, [&](PreparedScene&) { found = model_.results().evaluate(places, with_stress); });
  return found;
}

}  // namespace bempd::model
