#pragma once

#include <map>

#include "crack/cycle_step.hpp"
#include "model/fatigue.hpp"

namespace bempd::model {

// Length of the steps of growth by cycles, chosen by the error that a step makes in the number of cycles.
//
// The growth rate varies as a power of the crack's length, with an exponent that changes slowly. The relative error of
// a step is a twelfth of the change of this exponent from the previous step, times the logarithm of the ratio of the
// crack's length after the step to that before.
class FatigueStepLength {
 public:
  explicit FatigueStepLength(const FatigueOptions& options) : options_(options), share_(0.5 * options.largest_step) {}

  double share() const { return share_; }  // step length as a share of the leading tip's size
  void halve() { share_ *= 0.5; }
  // Chooses the length of the next step from the growth rates of the leading tip before and after a step. Returns false
  // if that step must be repeated because its error is much larger than the tolerance, which is wider for steps that
  // have few of the cycles `so_far`. A step that `must_stand` is kept, and its error counts. A tip's first step has no
  // error of its own: the change of the exponent in the tip's second step gives the error of both steps.
  bool choose(const crack::TipOnStep& tip, double before, double after, double cycles, double so_far, bool must_stand);
  // Estimated relative error of the number of cycles `passed`; NaN if steps were made and no error is known.
  double error(double passed, bool steps_were_made) const;

 private:
  const FatigueOptions& options_;
  // Exponent of the growth rate of each tip as a power of its length, from the last step that the tip led.
  std::map<crack::TipId, double> powers_;
  // Cycles of each tip's first step, times the logarithm of the ratio of the tip's length after the step to that
  // before.
  std::map<crack::TipId, double> first_steps_;
  double share_;
  double error_ = 0;           // sum of the errors of steps [cycles]
  bool has_estimate_ = false;  // whether the error of a step is known
};

}  // namespace bempd::model
