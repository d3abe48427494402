#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "crack/carrier.hpp"
#include "fracture/event_source.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/line/line_growth.hpp"
#include "fracture/line/line_guard.hpp"
#include "fracture/line/line_path.hpp"
#include "fracture/line/line_step.hpp"
#include "fracture/line/step_loads.hpp"
#include "fracture/line/tip_fields.hpp"
#include "fracture/load_way.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

class LineSteps;
// Step of a tip in a given direction, whatever its load; empty if no bond lies ahead of the tip. `by_load` is the step
// that the tip would take under the present loads, if any.
std::optional<LineStep> step_towards(const Point& direction, const crack::TipId& tip, const LineSteps& steps,
                                     const BodyState& state, const std::optional<LineStep>& by_load);

// Steps of crack lines (cracks that grow in a lattice by steps) for given displacements, which need to be known around
// tips only. The tip that first reaches its toughness grows by a spacing in the direction of maximum hoop stress.
// Critical load factors are corrected by the energy that the last steps released, so that the growth absorbs the
// fracture energy.
class LineSteps {
 public:
  LineSteps(LoadedBody& body, pd::TipLaws laws);
  LineSteps(const LineSteps&) = delete;
  LineSteps& operator=(const LineSteps&) = delete;

  // Sets the tips that the host has frozen.
  void freeze(std::set<crack::TipId> tips) { frozen_ = std::move(tips); }
  const std::set<crack::TipId>& frozen() const { return frozen_; }
  // Whether a tip does not grow at any load: it is frozen, or has stopped at an interface.
  bool does_not_grow(const GrowingTip& tip) const {
    return tip.state == crack::TipState::at_interface || (!tip.has_ended() && frozen_.count(tip.id) > 0);
  }

  // One step for each tip that is loaded and whose path meets bonds. Tips that do not grow at any load are left out,
  // or, with `with_frozen`, included as if they were free. If the fit of stresses does not hold at a tip, a trial step
  // of `body` gives the load factor. Without a body, as in a window (region around crack tips that is solved alone),
  // that of the fit is used.
  std::vector<LineStep> all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                            const LoadWay& way, TrialBody* body = nullptr, bool with_frozen = false) const;
  // Candidates for growth, from which the tip that grows first is chosen: the tips of the steps with their load
  // factors.
  static std::vector<crack::Candidate> candidates(const std::vector<LineStep>& steps, const LoadWay& way);
  // Tip that grows first on a load path (crack/order.hpp), used for the whole body and in windows alike.
  struct Choice {
    std::vector<LineStep> steps;    // steps of all tips that could grow
    std::optional<LineStep> first;  // empty if no tip grows
    double load_factor;             // load factor of the event; if no tip grows, the end of the load path
    int ties = 0;                   // other tips that would have grown at the same load factor
    // Whether the order of the steps is unknown: a trial step has to give the load factor of a step that may be first,
    // but no body for trial steps was given.
    bool needs_trial_step = false;
  };
  Choice choose(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement, const LoadWay& way,
                TrialBody* body = nullptr) const;
  // Event at which a step is taken, without the extra terms of lattice cells (cell squares) that
  // fail together with the bonds that it breaks.
  Event event_of(const LineStep& step, double load_factor) const;
  // Whether more than rounding loads a tip: the critical load factor of its step is at most a million times
  // `load_factor`, the load factor of the next event.
  static bool is_driven(const LineStep& step, const LoadWay& way, double load_factor);
  // Tips near which no bond breaks by itself: tips whose steps the load drives, and tips that do not grow at any load.
  std::vector<GrowingTip> guarded(const std::vector<LineStep>& steps, const std::vector<GrowingTip>& tips,
                                  const LoadWay& way, double load_factor) const;

  const TipFields& fields() const { return fields_; }
  const LinePath& path() const { return path_; }
  const LineGrowth& growth() const { return growth_; }
  const LineGuard& guard() const { return guard_; }

 private:
  std::optional<LineStep> next(const std::vector<GrowingTip>& tips, std::size_t tip,
                               const coupling::Affine& displacement, const LoadWay& way) const;

  const coupling::EquilibriumSystem& system_;
  pd::TipLaws laws_;
  TipFields fields_;
  LinePath path_;
  LineGrowth growth_;
  LineGuard guard_;
  StepLoads loads_;
  std::set<crack::TipId> frozen_;
};

}  // namespace bempd::fracture
