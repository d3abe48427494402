#pragma once

#include <optional>
#include <vector>

#include "fracture/line/tip_stress.hpp"
#include "fracture/whole_body_events.hpp"

namespace bempd::fracture {

// Cracks that grow as lines: the tip that reaches its toughness first goes on by a spacing towards the largest hoop
// stress, and all bonds across this step break at one event, whatever the lattice. The load factor is corrected by what
// the last steps released, so that a length of crack takes the fracture energy. Away from tips a crack begins where a
// bond reaches its critical stretch: a line of a spacing through its middle, across the largest principal stress, with
// a tip at either end.
class LineEvents final : public EventSource {
 public:
  LineEvents(LoadedBody& body, WholeBodyEvents& whole_body, pd::TipLaws laws);

  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;

 private:
  struct Step {
    std::size_t tip;
    Point direction;
    double length;
    double load_factor;        // critical
    double constant, growing;  // hoop intensity there, over the toughness, corrected
    std::vector<int> bonds;
  };

  struct Birth {
    Point middle, direction;
    int law;
  };

  const pd::TipLaw& law_of(const GrowingTip& tip) const { return laws_.laws[static_cast<std::size_t>(tip.law)]; }
  std::optional<Step> step_of(std::size_t tip) const;
  bool is_short(const GrowingTip& tip) const;
  double hoop_ratio(const GrowingTip& tip) const;  // at the present load: largest hoop intensity over the toughness
  std::vector<int> across(const Point& from, const Point& to, double horizon) const;
  std::vector<char> intact_away_from_tips(const std::vector<char>& growing) const;
  std::optional<Birth> birth_at(int bond, double load_factor) const;
  const Event* tell_birth(int bond, const Birth& birth, double load_factor);
  const Event* tell_bonds(const std::vector<char>& intact, double load_factor, const SteppingOptions& options);

  LoadedBody& body_;
  WholeBodyEvents& whole_body_;
  TipStress stress_;
  pd::TipLaws laws_;
  std::optional<Step> step_;    // that the event told is
  std::optional<Birth> birth_;  // likewise
  Event event_;
};

}  // namespace bempd::fracture
