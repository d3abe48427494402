#pragma once

#include <optional>
#include <vector>

#include "fracture/line/line_steps.hpp"
#include "fracture/whole_body_events.hpp"

namespace bempd::fracture {

// Source of the steps of crack lines (cracks that grow in lattices by steps of a spacing). The tip that first reaches
// its toughness grows by a spacing in the direction of maximum hoop stress, and all bonds across this step break at one
// event. Critical load factors are corrected by the energy that the last steps released, so that the growth absorbs the
// fracture energy. Away from tips, a new crack begins where a bond reaches its critical stretch: a crack of one spacing
// through the middle of the bond, perpendicular to the largest principal stress, with a tip at both ends.
class LineEvents final : public EventSource {
 public:
  LineEvents(LoadedBody& body, WholeBodyEvents& whole_body, pd::TipLaws laws, FactorsAround factors);

  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;
  // Event at which a tip takes its next step at the present load factor, whatever the tip's critical load factor. The
  // step has the given direction, or that of the criterion. Null if no bond lies ahead of the tip. The next perform()
  // performs this event.
  const Event* step_of(const crack::TipId& tip, const std::optional<Point>& direction);

  const LineSteps& steps() const { return steps_; }
  // Prepares trial steps (evaluated but not taken), before tips or candidates are asked for. Trial steps use a separate
  // factor of the matrix if an open window (`in_window`) has changed the terms, or if the system has no current factor.
  void prepare_trials(bool in_window) {
    trials_.use_separate_factor(in_window || !body_.system().factor().is_current());
  }
  void freeze(const std::set<crack::TipId>& tips) { steps_.freeze(tips); }
  // Tips of the crack lines, for LineCarrier (line_carrier.hpp). Without `with_loads` their critical load factors are
  // left out, and no trial step is evaluated.
  std::vector<crack::Tip> tips(bool with_loads = true);
  // Tips that grow on a load path, with the load factors at which they grow.
  std::vector<crack::Candidate> candidates(const crack::LoadWay& way);
  bool is_step_of_tip() const { return step_.has_value(); }  // the next event is not the beginning of a crack

 private:
  // New crack of one spacing: its middle, its direction, and the number of its tip law.
  struct Birth {
    Point middle, direction;
    int law;
  };

  const pd::TipLaws& laws() const { return steps_.fields().laws(); }
  std::vector<crack::Tip> fitted_tips() const;
  std::optional<Birth> birth_at(int bond, double load_factor) const;
  std::vector<int> cut_by(const Birth& birth, double load_factor, bool& is_tie) const;
  Point middle_of(int bond) const;
  bool is_elsewhere(int bond, const Birth& birth) const;
  const Event* prepare_birth(const std::vector<int>& most, double load_factor);
  const Event* prepare_birth(int bond, const std::vector<int>& most, const Birth& birth, double load_factor);
  std::vector<char> free_to_break(const LineSteps::Choice& choice, const LoadWay& way) const;
  void exempt_unloading(const LoadWay& way, std::vector<char>& intact) const;
  void begin_crack(Outcome& outcome);
  const Event* prepare_breaks(const std::vector<char>& intact, double load_factor, const SteppingOptions& options);

  LoadedBody& body_;
  WholeBodyEvents& whole_body_;
  LineSteps steps_;
  WholeBodyTrials trials_;
  std::optional<LineStep> step_;  // step of a tip, if the next event is one
  std::optional<Birth> birth_;    // beginning of a crack, if the next event is one
  Event event_;
  int ties_ = 0;  // other tips or places that would have grown at the same load factor
};

}  // namespace bempd::fracture
