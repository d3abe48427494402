#pragma once

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "crack/cycle_step.hpp"
#include "model/crack_lengthening.hpp"

namespace bempd::model {

// Tip with its stress intensity factors at each load factor of the program.
struct FrontTip {
  regions::TipValues values;
  double angle = 0;                         // by which it turns as it grows [rad]
  std::vector<crack::LevelFactors> levels;  // by load factor of the program
  const crack::RateLaw* law = nullptr;      // null: it does not grow by cycles

  crack::TipId id() const { return {values.crack, values.end}; }
};

using Front = std::vector<FrontTip>;

// Laws of growth by cycles of a model's materials, each created when it is first needed.
class RateLaws {
 public:
  explicit RateLaws(Model& model) : model_(model) {}
  // `toughness`: K_I at which the tip breaks in the direction of its growth; 0 or infinite if nothing is known of it.
  const crack::RateLaw* of(int region, double toughness);

 private:
  Model& model_;
  // Laws by material and toughness, which varies from place to place.
  std::map<std::pair<int, double>, std::unique_ptr<crack::RateLaw>> laws_;
};

// Tips of a scene with their factors at each load factor of a program. If faces close or open between two load factors,
// the scene is moved to these load factors and back to the highest one; its history does not record that.
Front front_of(PreparedScene& scene, const std::vector<regions::TipValues>& tips, const crack::CycleProgram& program,
               const CrackLengthening& lengthening, Model& model, RateLaws& laws);

const FrontTip* tip_in(const Front& front, const crack::TipId& tip);

}  // namespace bempd::model
