#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "crack/cycle_program.hpp"
#include "crack/laws/rate_law.hpp"

namespace bempd::crack {

// Factors of a tip at one load of a program.
struct LevelFactors {
  Point factors{0, 0};     // K_I and K_II [Pa m^(1/2)]
  double equivalent = 0;   // factor of mode I in the direction in which the tip grows
  double net_section = 0;  // share of what the net section of the tip bears; 0 if that is not watched
  double t_stress = 0;     // T, if the law asks for it [Pa]
  double turn = 0;         // by which a line turns under this load, by the stress ahead of it [rad]
  double felt_ahead = 0;   // where a line acts under this load, from its place; NaN: not known [m]
};

// A tip on a step of its crack: factors are known before and after it, at each load of the program. Between the two
// the logarithm of the equivalent factor is that of a power of the crack's length, bent as through the step before
// where that is known, and the shares of the modes change evenly.
struct TipOnStep {
  TipId tip;
  const RateLaw* law = nullptr;
  double length = 0;        // of the crack before the step [m]
  double growth = 0;        // of this tip in the step [m]
  double crack_growth = 0;  // of its crack, with that of the other end [m]
  Point from{0, 0}, to{0, 0};
  std::vector<LevelFactors> before, after;  // `after` is empty where nothing is known of it: as before

  // Factors at which the tip breaks, at even shares of the step from its beginning to its end; infinite: not known.
  std::vector<double> critical{std::numeric_limits<double>::infinity()};

  // Growth of the tip in the step before [m], and its factors before that step; 0 and empty if nothing is known of it.
  double past_growth = 0;
  std::vector<LevelFactors> past;

  Overload overload;  // that the tip has met before the step

  LevelFactors at(double grown, std::size_t level) const;
  TipCycle cycle(double grown, const Block& block) const;
  double critical_at(double grown) const;
  double bend(std::size_t level) const;  // second divided difference of logarithms over those of lengths
  // Length of the tip's own part of the crack. The factors are a power law of this length, from its other end on.
  double own_length() const { return crack_growth > 0 ? length * growth / crack_growth : length; }
};

// Reason for which a way through a program of cycles ends.
enum class CyclesEnd { growth, cycles, critical, net_section, none_grows };

// Result of a way through a program, by CycleIntegration::run().
struct CyclesOnStep {
  CyclesEnd end = CyclesEnd::growth;
  std::size_t tip = 0;              // that breaks, where one does
  double cycles = 0;                // that have passed
  std::vector<double> growth;       // of each tip [m]
  std::vector<Overload> overloads;  // of each tip, by then
  CycleProgram::Place place;        // where the program has come to
  bool in_cycle = false;            // less than a cycle has passed in the last part
};

// Goes through a program while the tips grow by their laws, until one of them has grown by a length, a number of cycles
// has passed, or a tip reaches its critical factor. Blocks are passed one by one; where a whole program makes the tip
// grow by much less than the step, several of them are passed at once, at their mean rate.
class CycleIntegration {
 public:
  CycleIntegration(const CycleProgram& program, const std::vector<TipOnStep>& tips) : program_(program), tips_(tips) {}

  // `grown`: by how much each tip is ahead of the step's beginning at first.
  CyclesOnStep run(const CycleProgram::Place& from, std::vector<double> grown, std::size_t goal, double growth,
                   double most_cycles) const;

 private:
  using Growth = std::vector<double>;

  using Overloads = std::vector<Overload>;

  // Rates of all tips; none where a tip is critical.
  std::optional<Growth> rates(const Growth& grown, std::size_t block, const Overloads& overloads) const;
  // Growth of all tips in one pass of the program, whose overloads are those of an earlier pass at about these lengths;
  // none where a tip is critical.
  std::optional<Growth> program_growth(const Growth& grown, const Overloads& overloads) const;
  // Replaces the overloads of the tips by those after a cycle of a block, at the cycle's highest load.
  void update_overloads(Overloads& overloads, const Growth& grown, std::size_t block) const;
  // Growth of a tip to the end of its overload's zone; infinite without retardation, or if the zone is behind it.
  double growth_to_zone_end(std::size_t tip, double grown, const Overload& overload) const;
  template <class Rates>
  std::optional<Growth> advanced(const Growth& grown, double by, const Rates& rates) const;
  std::size_t critical_tip(const Growth& grown, std::size_t block) const;
  std::size_t most_loaded(const Growth& grown, std::size_t block) const;
  // Ends the way through the program at a tip that breaks, or nearly so, under the highest load of the present block.
  void end_at(CyclesOnStep& now, std::size_t tip) const;
  bool pass_programs(CyclesOnStep& now, std::size_t goal, double growth, double most_cycles) const;
  bool pass_block(CyclesOnStep& now, const Growth& rates, std::size_t goal, double growth, double most_cycles) const;

  const CycleProgram& program_;
  const std::vector<TipOnStep>& tips_;
};

// Growth of a tip in a cycle: the mean over the program. Blocks that break the tip are left out.
double mean_rate(const TipOnStep& tip, double grown, const CycleProgram& program);

}  // namespace bempd::crack
