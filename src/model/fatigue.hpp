#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "crack/laws/rate_parameters.hpp"
#include "crack/tip.hpp"
#include "geometry/point.hpp"
#include "model/answers.hpp"
#include "model/load_levels.hpp"
#include "model/remembered_overload.hpp"

namespace bempd::model {

class Model;

// Options of the host for growth by load cycles (fatigue).
struct FatigueOptions {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::vector<LoadBlock> blocks;
  double first_cycle = 0;          // cycles that have passed before this call
  double most_cycles = unlimited;  // cycles at which growth ends, including first_cycle
  double most_length = unlimited;  // largest length of a crack [m]
  std::int64_t most_steps = 1000;
  double tolerance = 1e-3;     // error of the number of cycles, as a share
  double largest_step = 0.25;  // longest step, as a share of the crack's length
};

enum class FatigueEnd {
  cycles = 1,
  critical = 2,     // a tip has reached its critical factor
  length = 3,       // a crack has come to the length that the host stated
  none_grows = 4,   // all tips are below their thresholds, or their faces are closed
  tip_ended = 5,    // a tip has reached an edge, a hole or another crack
  tip_stopped = 6,  // a tip cannot grow on from its place
  steps = 7,
  requested = 8,
  net_section = 9  // the net section of a tip bears no more
};

struct FatigueReport {
  FatigueEnd end = FatigueEnd::cycles;
  crack::TipId tip{};  // tip that ended the growth; crack 0: none
  std::int64_t steps = 0;
  double cycles = 0;  // number of cycles, including first_cycle
  double growth = 0;  // sum over all tips [m]
  double error = 0;   // estimated relative error of the cycles of this call
};

// Record of a tip after a step of growth by cycles; step 0 is the initial state. `high` and `low` belong to the highest
// and the lowest load of the program; with load cases, to the combinations under which the equivalent stress intensity
// factor of this tip is largest and smallest.
struct FatigueRecord {
  std::int64_t step = 0, event = 0;
  crack::TipId tip{};
  double cycles = 0;
  double length = 0;  // length of the crack [m]
  double growth = 0;  // growth of the tip since the first record [m]
  Point place{0, 0};
  Point high{0, 0}, low{0, 0};
  double highest = 0, lowest = 0;  // equivalent factors under these loads [Pa m^(1/2)]
  double rate = 0;                 // growth per cycle, as the mean over the program [m]
};

// Fatigue: growth of cracks by cycles of the loads.
class Fatigue {
 public:
  explicit Fatigue(Model& model) : model_(model) {}

  // Sets the law by which cracks in a material (id) grow under load cycles.
  void set_rate(int material, crack::RateParameters parameters);
  const crack::RateParameters* rate_of(int material) const;

  // Grows cracks by load cycles. If it throws Error, the model is as it was before the call.
  FatigueReport grow(const FatigueOptions& options);
  // Records of the tips after each step of the last call of grow().
  const std::vector<FatigueRecord>& records() const { return records_; }
  // Overloads that tips have met by the end of the last call of grow(). A call that continues from that state uses
  // them.
  const std::vector<RememberedOverload>& overloads() const { return overloads_; }
  // Sets the overloads that a saved state contains.
  void set_overloads(std::vector<RememberedOverload> overloads) { overloads_ = std::move(overloads); }

  // Extends tips by the given lengths at the present load factor, as one event.
  GrowthResult extend(const std::vector<std::pair<crack::TipId, double>>& lengths);

 private:
  Model& model_;
  std::map<int, crack::RateParameters> rates_;
  std::vector<FatigueRecord> records_;
  std::vector<RememberedOverload> overloads_;
};

}  // namespace bempd::model
