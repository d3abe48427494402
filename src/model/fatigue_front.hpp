#pragma once

#include <map>
#include <memory>
#include <vector>

#include "crack/cycle_step.hpp"
#include "model/crack_lengthening.hpp"
#include "model/load_levels.hpp"

namespace bempd::model {

// Tip with its stress intensity factors under each load of the spectrum.
struct FrontTip {
  regions::TipValues values;
  double angle = 0;                         // by which it turns as it grows [rad]
  std::vector<crack::LevelFactors> levels;  // by load
  std::size_t high = 0, low = 0;            // loads that its records tell of
  const crack::RateLaw* law = nullptr;      // null: it does not grow by cycles
  int region = 0;
  double effective_tip_ahead = 0;  // of its place [m]
  double critical = 0;             // factor at which it breaks here; infinite: not known [Pa m^(1/2)]

  crack::TipId id() const { return {values.crack, values.end}; }
};

using Front = std::vector<FrontTip>;

// Reads fronts of scenes: tips with their factors under each load, and the laws by which they grow.
class FrontReader {
 public:
  FrontReader(Model& model, CrackLengthening& lengthening, const LoadLevels& levels)
      : model_(model), lengthening_(lengthening), levels_(levels) {}

  // Front of a scene with longer cracks; null: of the model's.
  Front front(const std::vector<regions::TipValues>& tips, LongerCracks* longer);
  // Whether a tip turns spacing by spacing, by the stress ahead of it: the tip of a line around which no contour gives
  // factors. Not if load cases are combined.
  bool turns_by_itself(const FrontTip& tip) const {
    return tip.values.method == regions::TipMethod::stress_ahead && !levels_.combine_cases();
  }
  // Stress intensity factors at which a tip breaks, at even shares of a step from its beginning to its end. `after` is
  // the tip behind the step; null if it has ended.
  std::vector<double> critical_along(const FrontTip& before, const FrontTip* after, const Point& to) const;

 private:
  const crack::RateParameters* parameters_of(int region) const;
  const crack::RateLaw* law_in(int region);
  void set_direction(FrontTip& tip) const;
  void add_net_sections(Front& front, LongerCracks* longer);

  Model& model_;
  CrackLengthening& lengthening_;
  const LoadLevels& levels_;
  std::map<int, std::unique_ptr<crack::RateLaw>> laws_;  // by material
};

const FrontTip* tip_in(const Front& front, const crack::TipId& tip);

// Warns of cracks in lattices that are so short that the stress around their tips is not that of a tip.
void warn_of_short_lines(const Front& front, const std::vector<scene::Crack>& cracks,
                         const CrackLengthening& lengthening);

}  // namespace bempd::model
