#pragma once

#include <optional>
#include <vector>

#include "fracture/line/tip_stress.hpp"
#include "fracture/whole_body_events.hpp"

namespace bempd::fracture {

// Cracks that grow as lines: the tip that reaches its toughness first goes on by a spacing towards the largest hoop
// stress, and all bonds across this step break at one event, whatever the lattice. The load factor is corrected by what
// the last steps released, so that a length of crack takes the fracture energy. Away from tips bonds break by their own
// stretch, as without lines.
class LineEvents final : public EventSource {
 public:
  LineEvents(LoadedBody& body, WholeBodyEvents& whole_body, std::vector<pd::TipLaw> laws);

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

  std::optional<Step> step_of(std::size_t tip) const;
  std::vector<int> across(const Point& from, const Point& to, double horizon) const;
  std::vector<char> intact_away_from_tips(const std::vector<char>& growing) const;
  const Event* tell_bonds(const std::vector<char>& intact, double load_factor, const SteppingOptions& options);

  LoadedBody& body_;
  WholeBodyEvents& whole_body_;
  TipStress stress_;
  std::vector<pd::TipLaw> laws_;
  std::optional<Step> step_;  // that the event told is
  Event event_;
};

}  // namespace bempd::fracture
