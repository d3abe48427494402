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
// Step of a tip in a direction, whatever its load. `by_load` is the one that the present loads let it take, if any.
// Empty if no bond lies ahead.
std::optional<LineStep> step_towards(const Point& direction, const crack::TipId& tip, const LineSteps& steps,
                                     const BodyState& state, const std::optional<LineStep>& by_load);

// Steps of crack lines for given displacements, which need to be known around tips only. The tip that first reaches its
// toughness grows by a spacing in the direction of maximum hoop stress. The load factor is corrected by the energy that
// the last steps released, so that the growth absorbs the fracture energy.
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

  // One step for each tip that is loaded and whose path meets bonds; frozen tips are included on request, as if they
  // were free. If a fit does not hold, a trial step of `body` gives the load; without a body, as in a window, the fit
  // is used all the same.
  std::vector<LineStep> all(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement,
                            const LoadWay& way, TrialBody* body = nullptr, bool with_frozen = false) const;
  // Candidates for the order of growth: the load factors of the steps.
  static std::vector<crack::Candidate> candidates(const std::vector<LineStep>& steps, const LoadWay& way);
  // Tip that grows first on a path (crack/order.hpp), used for the whole body and in windows alike.
  struct Choice {
    std::vector<LineStep> steps;    // of all tips that could grow
    std::optional<LineStep> first;  // null if no tip grows
    double load_factor;             // of its event; without one the end of the way
    int ties = 0;                   // other tips that would have grown as soon
    bool needs_trial_step = false;  // without one: an energy has to tell the load of a step that may matter
  };
  Choice choose(const std::vector<GrowingTip>& tips, const coupling::Affine& displacement, const LoadWay& way,
                TrialBody* body = nullptr) const;
  // Event at which a step is taken, without the followers of the bonds that it breaks.
  Event event_of(const LineStep& step, double load_factor) const;
  // Whether a tip is loaded by more than rounding: its step's load factor must not be far above `load_factor`, at which
  // something else happens.
  static bool is_driven(const LineStep& step, const LoadWay& way, double load_factor);
  // Tips that guard the bonds near them, none of which breaks by itself: those whose steps are driven, and those that
  // do not grow.
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
