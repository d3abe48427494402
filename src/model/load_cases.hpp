#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <set>
#include <vector>

#include "regions/region.hpp"
#include "results/point_values.hpp"
#include "scene/scene_values.hpp"

namespace bempd::model {

class Model;
struct PreparedScene;

// Load cases: loads and moved supports that act together, and the body under any combination of cases. A combination is
// solved with the factorization of the prepared body, at its present cracks and bonds. Faces close and open as needed,
// and nothing grows or breaks. The state of the run does not change.
class LoadCases {
 public:
  explicit LoadCases(Model& model) : model_(model) {}

  // Adds a case of loads and supports (ids) with their present values at the load factor 1. Returns the id of the case.
  int add(const std::vector<int>& loads, const std::vector<int>& supports);
  int count() const { return static_cast<int>(cases_.size()); }

  // Results of the body in equilibrium under a combination of load cases.
  struct Solved {
    std::vector<regions::TipValues> tips;
    std::vector<Eigen::Vector2d> reactions;  // reaction of each support [N]
    std::int64_t pressed = 0;                // number of places at which crack faces press on each other
  };
  // Results under a combination of load cases. `factors` belong to the first cases, in the order of their ids; the
  // other cases do not act.
  const Solved& under(const std::vector<double>& factors);
  // Calls `read` while the body is in equilibrium under a combination.
  void solve_under(const std::vector<double>& factors, const std::function<void(PreparedScene&)>& read);
  // Calls `read` while the body is in equilibrium under its own loads at a load factor.
  void solve_at(double load_factor, const std::function<void(PreparedScene&)>& read);
  std::vector<regions::PointValue> evaluate(const std::vector<double>& factors, const std::vector<Point>& places,
                                            bool with_stress);

 private:
  struct Case {
    std::set<int> loads, supports;
    scene::SceneValues values;  // values of all loads and supports when the case was added
  };

  scene::SceneValues combined(const std::vector<double>& factors) const;
  void solve_under(const scene::SceneValues& values, const std::function<void(PreparedScene&)>& read);

  Model& model_;
  std::vector<Case> cases_;
  std::vector<double> known_factors_;
  std::int64_t known_generation_ = 0;  // generation of the model that `known_` belongs to; 0: none
  Solved known_;
};

}  // namespace bempd::model
