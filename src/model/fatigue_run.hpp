#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/fatigue.hpp"
#include "model/fatigue_front.hpp"
#include "model/fatigue_overloads.hpp"
#include "model/fatigue_step_length.hpp"

namespace bempd::model {

// Growth of a tip, as a share of the tip's size, below which the tip's crack is not extended: the growth waits until it
// has added up to more.
inline constexpr double tiny_growth = 1e-6;

// Run of a call in which cracks grow by load cycles. A step extends the tips in proportion to their growth rates. The
// leader, the tip that first reaches the largest length that a step may have for it, sets the length of the step. The
// cycles are then counted with the stress intensity factors before and after the step (crack/cycle_step). If lengths or
// directions differ from the assumed values, the step is repeated with the new values, as in Heun's method; a
// difference that remains enters the next step.
class FatigueRun {
 public:
  FatigueRun(Model& model, CrackLengthening& lengthening, const FatigueOptions& options);

  FatigueReport run();
  std::vector<FatigueRecord> take_records() { return std::move(records_); }
  std::vector<RememberedOverload> remembered_overloads() const {
    return overloads_.remembered(front_, waiting_.of(front_));
  }

 private:
  // Trial of a step, which is not accepted yet. Lists have an entry for each tip of the front.
  struct Trial {
    std::vector<double> lengths;  // assumed growth of each tip
    std::vector<double> angles;
    LongerCracks longer;
    Front after;
    std::vector<crack::TipOnStep> on_step;
    crack::CyclesOnStep cycles;
  };
  // Plan of a step: the growth of each tip, and the leader (tip that sets the length of the step).
  struct Plan {
    std::vector<double> lengths;
    std::size_t leader = 0;
  };
  void find_front();
  void find_rates();
  crack::TipOnStep without_growth(std::size_t tip) const;
  std::optional<Plan> plan() const;
  void keep_within_length(Plan& plan) const;
  double length_of_crack(std::size_t tip) const;
  double length_by_cycles(std::size_t tip) const;
  double size_of(std::size_t tip) const;
  double longest(std::size_t tip) const;
  double cycles_left() const { return options_.most_cycles - report_.cycles; }
  bool step();  // returns false if the run is over
  Trial compute_step(const Plan& plan);
  Trial trial(std::vector<double> lengths, std::vector<double> angles, std::size_t leader);
  std::vector<crack::TipOnStep> on_step(const Trial& trial) const;
  double turn(const Trial& trial, std::size_t tip) const;
  double largest_turn(const Trial& trial) const;
  bool is_too_short(const Trial& trial, std::size_t leader) const;
  bool waits(const Trial& trial, std::size_t tip) const;
  std::optional<std::size_t> leader_instead(const Trial& trial) const;
  bool is_line(std::size_t tip) const { return lengthening_.growth_increment(front_[tip].values) > 0; }
  bool differs_from_cycles(const Trial& trial, std::size_t leader, double share) const;
  bool choose_step(const Trial& trial, std::size_t leader, bool must_stand);
  bool accept(Trial trial, std::size_t leader);
  bool pass(const crack::CyclesOnStep& cycles);
  bool pass_without_growth();
  bool is_over(const crack::CyclesOnStep& cycles);
  bool end_by(FatigueEnd end, const crack::TipId& tip = {});
  void record();
  Model& model_;
  CrackLengthening& lengthening_;
  const FatigueOptions& options_;
  LoadLevels levels_;
  crack::CycleProgram program_;
  FrontReader reader_;
  Front front_;
  std::vector<scene::Crack> cracks_;  // cracks with their growth so far
  std::vector<double> rates_;         // growth per cycle of each tip of the front, as the mean over the program
  WaitingGrowth waiting_;
  std::map<crack::TipId, double> grown_;
  std::map<crack::TipId, double> last_growth_;                            // growth of each tip in the previous step [m]
  std::map<crack::TipId, std::vector<crack::LevelFactors>> last_levels_;  // values of each tip before the previous step
  MetOverloads overloads_;
  crack::CycleProgram::Place place_;
  FatigueStepLength step_;
  FatigueReport report_;
  std::vector<FatigueRecord> records_;
};

}  // namespace bempd::model
