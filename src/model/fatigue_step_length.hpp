#pragma once

#include <map>

#include "crack/cycle_step.hpp"
#include "model/fatigue.hpp"

namespace bempd::model {

// Length of the steps of growth by cycles, chosen by their error.
//
// The rate varies as a power of the length; a twelfth of the change of that power between steps, times the logarithm of
// the ratio of lengths, is the error of a step.
class FatigueStepLength {
 public:
  explicit FatigueStepLength(const FatigueOptions& options) : options_(options), share_(0.5 * options.largest_step) {}

  double share() const { return share_; }  // of the size of the tip that leads
  void halve() { share_ *= 0.5; }
  // Chooses the length of the next step, from the rates of the leading tip before and after one. Returns false if that
  // step must be repeated, because its error is much more than the tolerance, which is wider for steps with few of the
  // cycles `so_far`. A step that must stand is kept, and its error counts. A tip's first step has no error of its own:
  // the change of the power in the tip's second step counts for both.
  bool choose(const crack::TipOnStep& tip, double before, double after, double cycles, double so_far, bool must_stand);
  // Estimated error of the cycles that have passed, as a share of them; NaN if none is known although steps were made.
  double error(double passed, bool steps_were_made) const;

 private:
  const FatigueOptions& options_;
  std::map<crack::TipId, double> powers_;       // of a tip's rate in its length, in the last step that it led
  std::map<crack::TipId, double> first_steps_;  // cycles of a tip's first step times the logarithm of its lengths
  double share_;
  double error_ = 0;           // [cycles]
  bool has_estimate_ = false;  // whether the error of a step is known
};

}  // namespace bempd::model
