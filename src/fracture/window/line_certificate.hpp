#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/line/line_steps.hpp"

namespace bempd::fracture {

// Proof that no bond away from the crack tips would have broken by itself before the steps of lines that a window has
// computed, or the first step before which one would. Displacements are proportional to the load factor.
class LineCertificate {
 public:
  // Creates the proof. The terms that break from here on still have their present stages in `system`.
  LineCertificate(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                  const StretchRatios& ratios, const LineSteps& steps);

  // Step of a crack line, which takes the window from one state (of displacements) to the next.
  struct Step {
    double load_factor;
    std::vector<GrowingTip> growing;                    // tips beside which nothing breaks by itself
    const std::vector<coupling::StageChange>* changes;  // at its end
  };
  // Index of the first state in which a bond breaks by itself before the state's step is due; the number of states if
  // none does. There is one state for each step, which ends it.
  int first_break(const std::vector<coupling::Affine>& states, const std::vector<Step>& steps) const;

 private:
  int first_break(const Eigen::MatrixXd& stretched, int begin, const std::vector<Step>& steps,
                  const std::vector<int>& broken_at) const;
  bool is_guarded(std::size_t bond, const Step& step) const;

  const coupling::Condensation& condensation_;
  const LineSteps& steps_;
  std::vector<int> bonds_, first_, second_;  // that can break; degrees of freedom of their ends
  std::vector<double> cosine_, sine_;        // scaled so that ratios come out
};

}  // namespace bempd::fracture
