#pragma once

#include <optional>
#include <vector>

#include "fracture/line/line_steps.hpp"
#include "fracture/whole_body_events.hpp"

namespace bempd::fracture {

// Source of the steps of cracks that grow as lines in lattices. The tip that first reaches its toughness grows by a
// spacing in the direction of maximum hoop stress, and all bonds across this step break at one event, whatever the
// lattice. The load factor is corrected by the energy that the last steps released, so that the growth absorbs the
// fracture energy. Away from tips, a crack begins where a bond reaches its critical stretch: a line of one spacing
// through its middle, across the largest principal stress, with a tip at both ends.
class LineEvents final : public EventSource {
 public:
  LineEvents(LoadedBody& body, WholeBodyEvents& whole_body, pd::TipLaws laws, FactorsAround factors);

  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;
  // Event by which this tip takes its next step now, at the present load factor, even if its load of growth is another.
  // The step has the given direction, or that of the criterion. Null if no bond lies ahead of the tip. The next
  // perform() performs this event.
  const Event* step_of(const crack::TipId& tip, const std::optional<Point>& direction);

  const LineSteps& steps() const { return steps_; }
  // Called before tips or candidates are asked for. If an open window (`in_window`) has changed the terms, or the
  // system has no current factor, trial steps use a factor of their own.
  void prepare_trials(bool in_window) {
    trials_.use_separate_factor(in_window || !body_.system().factor().is_current());
  }
  void freeze(const std::set<crack::TipId>& tips) { steps_.freeze(tips); }
  // Tips of the lines, and candidates for growth, for LineCarrier (line_carrier.hpp). If tips are asked for without
  // their loads of growth, no trial step is made.
  std::vector<crack::Tip> tips(bool with_loads = true);
  std::vector<crack::Candidate> candidates(const crack::LoadWay& way);
  bool is_step_of_tip() const { return step_.has_value(); }  // and no crack begins

 private:
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
  std::optional<LineStep> step_;  // the step of a tip, if event_ is one
  std::optional<Birth> birth_;    // the crack that begins, if event_ is one
  Event event_;
  int ties_ = 0;  // others that would have grown as soon
};

}  // namespace bempd::fracture
