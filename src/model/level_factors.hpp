#pragma once

#include <functional>
#include <vector>

#include "crack/cycle_step.hpp"
#include "model/crack_lengthening.hpp"
#include "model/load_levels.hpp"

namespace bempd::model {

// Values of each tip under each load of a program of cycles: lists by tip, then by load.
using FactorsOfTips = std::vector<std::vector<crack::LevelFactors>>;

// Finds the stress intensity factors of tips under the loads of a program of cycles. As long as no faces close or open,
// the factors are affine functions of the load factor. Otherwise the scene is moved to each load factor and back to the
// highest one, or solved under each load separately. The history of the run does not record this.
class LevelSolver {
 public:
  // `longer`: trial whose scene is used; null: the model's scene.
  LevelSolver(Model& model, CrackLengthening& lengthening, const LoadLevels& levels, LongerCracks* longer)
      : model_(model), lengthening_(lengthening), levels_(levels), longer_(longer) {}

  // Stress intensity factors of each tip under each load; with T-stress if asked for.
  FactorsOfTips factors(const std::vector<regions::TipValues>& tips, bool with_t_stress);
  // Calls `read` while the body is in equilibrium under each load; if `chosen` is not empty, only under the loads that
  // it marks.
  void under_each(const std::function<void(std::size_t level)>& read, const std::vector<char>& chosen = {});

 private:
  PreparedScene& scene() { return longer_ ? lengthening_.scene_of(*longer_) : lengthening_.scene(); }
  bool changes_faces(std::size_t level);
  void take_solved(const std::vector<regions::TipValues>& tips, const std::vector<char>& with_factors,
                   bool with_t_stress, FactorsOfTips& found);

  Model& model_;
  CrackLengthening& lengthening_;
  const LoadLevels& levels_;
  LongerCracks* longer_;
};

}  // namespace bempd::model
