#pragma once

#include <functional>
#include <vector>

#include "crack/cycle_step.hpp"
#include "model/crack_lengthening.hpp"
#include "model/load_levels.hpp"

namespace bempd::model {

// What is known of each tip of a scene under each load of a spectrum: lists by tip, then by load.
using FactorsOfTips = std::vector<std::vector<crack::LevelFactors>>;

// Finds stress intensity factors of tips under the loads of a spectrum. If the loads are load factors and no faces
// close or open, they are affine functions. Otherwise the scene is moved to these load factors and back to the highest
// one, or solved under a load by itself. Its history does not record that.
class LevelSolver {
 public:
  // `longer`: the scene; null is that of the model.
  LevelSolver(Model& model, CrackLengthening& lengthening, const LoadLevels& levels, LongerCracks* longer)
      : model_(model), lengthening_(lengthening), levels_(levels), longer_(longer) {}

  // Stress intensity factors, and T on request.
  FactorsOfTips factors(const std::vector<regions::TipValues>& tips, bool with_t_stress);
  // Calls `read` while the body is in equilibrium under each load, or each of those that `chosen` marks.
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
