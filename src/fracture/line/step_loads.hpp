#pragma once

#include <vector>

#include "fracture/line/line_growth.hpp"
#include "fracture/line/line_path.hpp"
#include "fracture/line/line_step.hpp"
#include "fracture/line/tip_fields.hpp"
#include "fracture/line/trial_steps.hpp"
#include "fracture/load_way.hpp"

namespace bempd::fracture {

// Stress intensity factors as functions of the load factor times the sign of the load path.
AffineIntensity along_load_path(AffineIntensity intensity, const LoadWay& way);

// Whether one of the steps whose fits do not hold may be the first, where `steps` have the loads of their fits. Its
// load then has to come from the energy of a trial step, which a TrialBody is needed for.
bool needs_trial_step(const std::vector<LineStep>& steps, const LoadWay& way);

// Methods that give a tip's critical load: the fit of stresses or, where that fit does not hold, sums around the tip or
// the energy of a trial step.
class StepLoads {
 public:
  StepLoads(LoadedBody& body, const TipFields& fields, const LinePath& path)
      : body_(body), fields_(fields), path_(path), trials_(body.system(), fields.laws(), path) {}

  // Says whether the fit that gave a step its load holds, and which method serves if it does not.
  void judge_fit(const std::vector<GrowingTip>& tips, const WilliamsFit& fit, LineStep& step) const;
  // Replaces the load of the fit by that of sums around the tip, or of a trial step's energy; keeps it if the step
  // would close, or if the body has no answer.
  void replace(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way, TrialBody& body,
               LineStep& step) const;

 private:
  // Takes factors, load and direction of a step from path-independent sums around its tip, in place of those of the
  // fit; false if these sums find too little room around the tip, or if it cannot grow by them.
  bool take_factors(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way, TrialBody& body,
                    LineStep& step) const;

  LoadedBody& body_;
  const TipFields& fields_;
  const LinePath& path_;
  TrialSteps trials_;
};

}  // namespace bempd::fracture
