#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/condensation.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/line/line_steps.hpp"

namespace bempd::fracture {

// Proof that away from crack tips no bond would have broken by itself before the steps of crack lines (cracks that grow
// in a lattice by steps) that a window (region around crack tips or bonds close to breaking that is solved alone) has
// computed. If some bond would have broken, the result is the first step before which it would. Displacements are
// proportional to the load factor.
class LineCertificate {
 public:
  // Collects the bonds that are intact in `system`, for which first_break() will prove that they do not break by
  // themselves. To be created before the window computes its steps.
  LineCertificate(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                  const StretchRatios& ratios, const LineSteps& steps);

  // Step of a crack line that the window has computed.
  struct Step {
    double load_factor;
    std::vector<GrowingTip> growing;                    // tips near which no bond breaks by itself
    const std::vector<coupling::StageChange>* changes;  // changes of stages at the step
  };
  // Number of the first step before which a bond breaks by itself; the number of steps if there is none. `states` are
  // the displacements of the window's nodes before each step.
  int first_break(const std::vector<coupling::Affine>& states, const std::vector<Step>& steps) const;

 private:
  int first_break(const Eigen::MatrixXd& stretched, int begin, const std::vector<Step>& steps,
                  const std::vector<int>& broken_at) const;
  bool is_guarded(std::size_t bond, const Step& step) const;

  const coupling::Condensation& condensation_;
  const LineSteps& steps_;
  std::vector<int> bonds_, first_, second_;  // bonds that can break; first degree of freedom of each end
  std::vector<double> cosine_, sine_;        // scaled so that elongations are stretch ratios
};

}  // namespace bempd::fracture
