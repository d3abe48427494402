#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "crack/cycle_program.hpp"
#include "crack/laws/rate_law.hpp"

namespace bempd::crack {

// Values at a tip under one of the loads between which the cycles of a program alternate.
struct LevelFactors {
  Point factors{0, 0};     // K_I and K_II [Pa m^(1/2)]
  double equivalent = 0;   // equivalent factor: mode I in the direction of growth [Pa m^(1/2)]
  double net_section = 0;  // load on the tip's net section over its limit load [-]; 0: not computed
  double t_stress = 0;     // T-stress, if the growth law needs it [Pa]
  double turn = 0;         // turn of a crack line under this load, by the stress ahead of its tip [rad]
  double felt_ahead = 0;   // distance of the effective tip ahead of a crack line's tip [m]; NaN: unknown
};

// Tip in a step of growth by load cycles. Its stress intensity factors are known before and after the step, at each
// load of the program. During the step, the logarithm of the equivalent factor is a quadratic function of the logarithm
// of the tip's own part of the crack (own_length() plus growth), with the curvature bend(). The ratios of K_I and K_II
// to the equivalent factor change linearly.
struct TipOnStep {
  TipId tip;
  const RateLaw* law = nullptr;
  double length = 0;        // length of the crack before the step [m]
  double growth = 0;        // growth of this tip in the step [m]
  double crack_growth = 0;  // growth of the crack at both ends in the step [m]
  Point from{0, 0}, to{0, 0};
  std::vector<LevelFactors> before, after;  // factors by load; empty `after`: unknown, taken as `before`

  // Equivalent factors at which the tip breaks, at equally spaced places from the beginning of the step to its end [Pa
  // m^(1/2)]; infinite: unknown.
  std::vector<double> critical{std::numeric_limits<double>::infinity()};

  // Growth of the tip in the previous step [m], and its values by load before that step (`past`); 0 and empty if
  // unknown.
  double past_growth = 0;
  std::vector<LevelFactors> past;

  Overload overload;  // overload that the tip has met before the step

  LevelFactors at(double grown, std::size_t level) const;
  TipCycle cycle(double grown, const Block& block) const;
  double critical_at(double grown) const;
  // Curvature of the equivalent factor over the tip's own part of the crack, both as logarithms: their second divided
  // difference over the present and the previous step.
  double bend(std::size_t level) const;
  // Length of the tip's own part of the crack before the step: the crack's length times the tip's share of the growth
  // at both ends [m]. Equivalent factors are interpolated over this length.
  double own_length() const { return crack_growth > 0 ? length * growth / crack_growth : length; }
};

// Reason for which the integration over a program of cycles ends.
enum class CyclesEnd { growth, cycles, critical, net_section, none_grows };

// Result of CycleIntegration::run().
struct CyclesOnStep {
  CyclesEnd end = CyclesEnd::growth;
  std::size_t tip = 0;              // tip that breaks, if `end` is critical or net_section
  double cycles = 0;                // number of cycles that have passed
  std::vector<double> growth;       // growth of each tip [m]
  std::vector<Overload> overloads;  // overload of each tip at the end
  CycleProgram::Place place;        // place in the program that was reached
  bool in_cycle = false;            // whether the last part was less than a whole cycle
};

// Integration of the growth laws of all tips over a program of load cycles, until one tip has grown by a given length,
// a number of cycles has passed, or a tip breaks. Blocks are passed one by one. If a whole program makes the tip grow
// by much less than the step, several programs are passed at once, at their mean rate.
class CycleIntegration {
 public:
  CycleIntegration(const CycleProgram& program, const std::vector<TipOnStep>& tips) : program_(program), tips_(tips) {}

  // `grown`: growth of each tip since the beginning of the step [m]. The run ends when tip number `goal` has grown by
  // `growth` [m].
  CyclesOnStep run(const CycleProgram::Place& from, std::vector<double> grown, std::size_t goal, double growth,
                   double most_cycles) const;

 private:
  using Growth = std::vector<double>;

  using Overloads = std::vector<Overload>;

  // Growth per cycle of all tips under a block of cycles; empty if the block breaks a tip.
  std::optional<Growth> rates(const Growth& grown, std::size_t block, const Overloads& overloads) const;
  // Growth of all tips in one pass through the program; empty if a block breaks a tip. Retardation is that by the
  // overloads which an earlier pass at about these crack lengths has left.
  std::optional<Growth> program_growth(const Growth& grown, const Overloads& overloads) const;
  // Updates the overload of each tip by a cycle of a block, at the cycle's highest load.
  void update_overloads(Overloads& overloads, const Growth& grown, std::size_t block) const;
  // Growth of a tip until it reaches the end of its overload's plastic zone; infinite without retardation, or if the
  // tip has passed the zone.
  double growth_to_zone_end(std::size_t tip, double grown, const Overload& overload) const;
  template <class Rates>
  std::optional<Growth> advanced(const Growth& grown, double by, const Rates& rates) const;
  std::size_t critical_tip(const Growth& grown, std::size_t block) const;
  std::size_t most_loaded(const Growth& grown, std::size_t block) const;
  // Ends the integration at a tip that breaks under the present block. The reason is the net section if it is loaded
  // closer to its limit than the equivalent factor to the critical one, else the equivalent factor.
  void end_at(CyclesOnStep& now, std::size_t tip) const;
  bool pass_programs(CyclesOnStep& now, std::size_t goal, double growth, double most_cycles) const;
  bool pass_block(CyclesOnStep& now, const Growth& rates, std::size_t goal, double growth, double most_cycles) const;

  const CycleProgram& program_;
  const std::vector<TipOnStep>& tips_;
};

// Growth of a tip per cycle, as the mean over the program of cycles. Blocks that break the tip are left out.
double mean_rate(const TipOnStep& tip, double grown, const CycleProgram& program);

}  // namespace bempd::crack
