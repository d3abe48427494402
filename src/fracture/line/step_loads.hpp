#pragma once

#include <vector>

#include "fracture/line/line_path.hpp"
#include "fracture/line/line_step.hpp"
#include "fracture/line/tip_fields.hpp"
#include "fracture/line/trial_steps.hpp"
#include "fracture/load_way.hpp"

namespace bempd::fracture {

// Stress intensity factors as functions of the load factor times the sign of the load path (1 upwards, -1 downwards).
AffineIntensity along_load_path(AffineIntensity intensity, const LoadWay& way);

// Whether a step whose fit does not hold may come first on the load path. If so, sums around its tip or a trial step
// have to give its load factor, for which a TrialBody is needed. `steps` have the load factors by their fits.
bool needs_trial_step(const std::vector<LineStep>& steps, const LoadWay& way);

// Methods that give the critical load factor of a tip: the fit of Williams' series to stresses or, where that fit does
// not hold, path-independent sums around the tip or the energy of a trial step (evaluated but not taken).
class StepLoads {
 public:
  StepLoads(LoadedBody& body, const TipFields& fields, const LinePath& path)
      : body_(body), fields_(fields), path_(path), trials_(body.system(), fields.laws(), path) {}

  // Decides whether the fit that gave a step its load factor holds and, if not, by which other method the load factor
  // is found; sets the flags of `step` accordingly.
  void judge_fit(const std::vector<GrowingTip>& tips, const WilliamsFit& fit, LineStep& step) const;
  // Replaces the load factor of the fit by that of sums around the tip, or of a trial step's energy. The load factor of
  // the fit stays if the step would not open the crack, or if `body` cannot evaluate the sums or the trial step.
  void replace(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way, TrialBody& body,
               LineStep& step) const;

 private:
  // Takes stress intensity factors, load factor and direction of a step from path-independent sums around its tip, in
  // place of those of the fit. False if there is too little room for the sums around the tip, or if the tip cannot grow
  // by these factors.
  bool take_factors(const GrowingTip& tip, const coupling::Affine& displacement, const LoadWay& way, TrialBody& body,
                    LineStep& step) const;

  LoadedBody& body_;
  const TipFields& fields_;
  const LinePath& path_;
  TrialSteps trials_;
};

}  // namespace bempd::fracture
