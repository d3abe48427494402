#pragma once

#include <map>
#include <memory>
#include <vector>

#include "crack/cycle_step.hpp"
#include "model/crack_lengthening.hpp"
#include "model/load_levels.hpp"

namespace bempd::model {

// Tip with its stress intensity factors under each load of a program of cycles.
struct FrontTip {
  regions::TipValues values;
  double angle = 0;                         // angle by which the tip turns as it grows [rad]
  std::vector<crack::LevelFactors> levels;  // values under each load
  std::size_t high = 0, low = 0;            // indices of the loads that the tip's record shows
  const crack::RateLaw* law = nullptr;      // law of growth by cycles; null: the tip does not grow
  int region = 0;
  double effective_tip_ahead = 0;  // distance of the effective tip ahead of the tip's place [m]
  double critical = 0;             // factor at which the tip breaks at its place; infinite: unknown [Pa m^(1/2)]

  crack::TipId id() const { return values.id(); }
};

using Front = std::vector<FrontTip>;

// Computes fronts of scenes. A front consists of the tips with their stress intensity factors under each load, and the
// laws by which they grow.
class FrontReader {
 public:
  FrontReader(Model& model, CrackLengthening& lengthening, const LoadLevels& levels)
      : model_(model), lengthening_(lengthening), levels_(levels) {}

  // Front (tips with their stress intensity factors under each load) in the scene of the trial `longer`, or in the
  // model's scene if `longer` is null.
  Front front(const std::vector<regions::TipValues>& tips, LongerCracks* longer);
  // Whether a tip chooses its direction anew at each spacing, from the stress ahead of it: the tip of a crack line
  // around which no contour (ring) fits, unless load cases are combined.
  bool turns_by_itself(const FrontTip& tip) const {
    return tip.values.method == regions::TipMethod::stress_ahead && !levels_.combine_cases();
  }
  // Stress intensity factors at which a tip breaks, at equally spaced places of a step from its beginning to its end
  // `to`. `after` is the tip after the step; null if the tip has ended.
  std::vector<double> critical_along(const FrontTip& before, const FrontTip* after, const Point& to) const;

 private:
  const crack::RateParameters* parameters_of(int region) const;
  const crack::RateLaw* law_in(int region);
  void set_direction(FrontTip& tip) const;
  void add_net_sections(Front& front, LongerCracks* longer);

  Model& model_;
  CrackLengthening& lengthening_;
  const LoadLevels& levels_;
  std::map<int, std::unique_ptr<crack::RateLaw>> laws_;  // growth laws by id of the material
};

// Warns of cracks in lattices that are too short for the stress around their tips to be that of a crack tip.
void warn_of_short_lines(const Front& front, const std::vector<scene::Crack>& cracks,
                         const CrackLengthening& lengthening);

}  // namespace bempd::model
