#pragma once

#include <map>
#include <vector>

#include "model/fatigue_front.hpp"

namespace bempd::model {

// Overload in the list `known` that a tip has met, if the tip is at the place where the overload was recorded; else
// null.
const RememberedOverload* remembered_at(const FrontTip& tip, const std::vector<RememberedOverload>& known,
                                        const std::vector<scene::Crack>& cracks);

// Waiting growth of tips [m]: growth by cycles that is too small to extend the crack yet.
class WaitingGrowth {
 public:
  double& operator[](const crack::TipId& tip) { return of_tips_[tip]; }
  double of(const crack::TipId& tip) const {
    const auto found = of_tips_.find(tip);
    return found == of_tips_.end() ? 0 : found->second;
  }
  std::vector<double> of(const Front& front) const;
  // Takes over the waiting growth of tips at the end of the previous call.
  void take_up(const std::vector<RememberedOverload>& known, const Front& front,
               const std::vector<scene::Crack>& cracks);

 private:
  std::map<crack::TipId, double> of_tips_;
};

// Overloads that tips have met in a call of growth by cycles. Distances in them are measured from the tips' present
// places.
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
  // Overloads and waiting growth of each tip, in the form that a later call or a saved state takes over.
  std::vector<RememberedOverload> remembered(const Front& front, const std::vector<double>& waiting) const;

 private:
  std::map<crack::TipId, crack::Overload> met_;
};

}  // namespace bempd::model
