#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/line/line_steps.hpp"

namespace bempd::fracture {

// The proof that no bond away from all tips would have broken by itself before the steps of lines that a window has
// computed, or the first step before which one would. All displacements are proportional to the load factor.
class LineCertificate {
 public:
  // The system is given in the present stages, with all that breaks from here on.
  LineCertificate(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                  const StretchRatios& ratios, const LineSteps& steps);

  // What happens to a state of kept displacements.
  struct Step {
    double load_factor;
    std::vector<GrowingTip> growing;                    // tips beside which nothing breaks by itself
    const std::vector<coupling::StageChange>* changes;  // at its end
  };
  // The first of the states, one for each step, in which a bond breaks before; their number if none does.
  int first_break(const std::vector<coupling::Affine>& states, const std::vector<Step>& steps) const;

 private:
  int first_break(const Eigen::MatrixXd& stretched, int begin, const std::vector<Step>& steps,
                  const std::vector<int>& broken_at) const;
  bool is_spared(std::size_t bond, const Step& step) const;

  const coupling::Condensation& condensation_;
  const LineSteps& steps_;
  std::vector<int> bonds_, first_, second_;  // that can break; degrees of freedom of their ends
  std::vector<double> cosine_, sine_;        // scaled so that ratios come out
};

}  // namespace bempd::fracture
