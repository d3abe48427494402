#include "model/element_tips.hpp"

#include <algorithm>
#include <cmath>

#include "model/element_growth.hpp"

namespace bempd::model {

void ElementTips::update() {
  const fracture::EvolutionState& state = evolution_->progress();
  if (is_known_ && state.events == events_ && state.contact_switches == switches_) return;
  tips_ = find_();
  ranges_.clear();
  for (const regions::TipValues& tip : tips_)
    ranges_.push_back(crack::growth_range(factors_of(tip), tip.toughness, criterion_of(options_)));
  events_ = state.events;
  switches_ = state.contact_switches;
  is_known_ = true;
}

bool ElementTips::rest_somewhere() {
  update();
  crack::GrowthRange common;
  for (const crack::GrowthRange& range : ranges_) {
    common.lowest = std::max(common.lowest, range.lowest);
    common.highest = std::min(common.highest, range.highest);
  }
  return !common.is_empty();
}

const fracture::Event* ElementTips::next(double target, const fracture::SteppingOptions& options) {
  update();
  const bool path = options.control == fracture::Control::path;
  if (path && !rest_somewhere()) return nullptr;
  const double present = evolution_->progress().load_factor;
  const bool upwards = target >= present;
  std::vector<crack::Candidate> candidates;
  std::vector<std::size_t> numbers;
  for (std::size_t t = 0; t < tips_.size(); ++t) {
    const crack::GrowthRange& range = ranges_[t];
    crack::Candidate candidate{{tips_[t].crack, tips_[t].end}, upwards ? range.highest : range.lowest, 1, false};
    if (!path && !range.holds(present)) {
      candidate.load_factor = present;
      candidate.ratio = crack::growth_ratio(factors_of(tips_[t]), present, tips_[t].toughness, criterion_of(options_));
      candidate.overloaded = true;
    }
    if (!std::isfinite(candidate.load_factor)) continue;
    candidates.push_back(candidate);
    numbers.push_back(t);
  }
  const std::optional<crack::FirstToGrow> first = crack::first_to_grow(candidates, upwards);
  if (!first) return nullptr;
  first_ = numbers[first->index];
  ties_ = first->ties;
  const crack::Candidate& chosen = candidates[first->index];
  event_ = {};
  event_.load_factor = event_.critical_load_factor = chosen.load_factor;
  event_.ratio = chosen.ratio;
  event_.is_growth = true;
  return &event_;
}

}  // namespace bempd::model
