#pragma once

#include <map>
#include <vector>

#include "model/fatigue_front.hpp"

namespace bempd::model {

// Overload that is remembered of a tip at its present place; null if there is none.
const RememberedOverload* remembered_at(const FrontTip& tip, const std::vector<RememberedOverload>& known,
                                        const std::vector<scene::Crack>& cracks);

// Waiting growth: growth of tips by cycles by which their cracks have not been extended yet [m].
class WaitingGrowth {
 public:
  double& operator[](const crack::TipId& tip) { return of_tips_[tip]; }
  double of(const crack::TipId& tip) const {
    const auto found = of_tips_.find(tip);
    return found == of_tips_.end() ? 0 : found->second;
  }
  std::vector<double> of(const Front& front) const;
  // Takes over the growth that was waiting at the end of the previous call.
  void take_up(const std::vector<RememberedOverload>& known, const Front& front,
               const std::vector<scene::Crack>& cracks);

 private:
  std::map<crack::TipId, double> of_tips_;
};

// Overloads that tips have met in a call of growth by cycles, measured from the tips' present places.
class MetOverloads {
 public:
  // Takes over the overloads that the tips had met at the end of the earlier call which this call continues. Throws
  // Error (argument) if these overloads are unknown.
  void take_up(const std::vector<RememberedOverload>& known, const Front& front,
               const std::vector<scene::Crack>& cracks, double first_cycle);
  void set(const crack::TipId& tip, const crack::Overload& overload) { met_[tip] = overload; }
  // Sets the overload of a tip after a step in which the tip has grown.
  void set_after_step(const crack::TipOnStep& tip, crack::Overload overload);
  crack::Overload of(const crack::TipId& tip) const;
  // Overloads to be remembered, with the waiting growth of each tip.
  std::vector<RememberedOverload> remembered(const Front& front, const std::vector<double>& waiting) const;

 private:
  std::map<crack::TipId, crack::Overload> met_;
};

}  // namespace bempd::model
