#include "model/element_tips.hpp"

#include <algorithm>
#include <cmath>

#include "model/element_growth.hpp"

namespace bempd::model {

void ElementTips::update() {
  const fracture::EvolutionState& state = evolution_->progress();
  if (is_known_ && state.events == events_ && state.contact_switches == switches_) return;
  values_ = find_();
  tips_.clear();
  for (const regions::TipValues& tip : values_) tips_.push_back(carried(tip, options_));
  events_ = state.events;
  switches_ = state.contact_switches;
  is_known_ = true;
}

std::vector<crack::Tip> ElementTips::tips() {
  update();
  return tips_;
}

std::vector<crack::Candidate> ElementTips::candidates(const crack::LoadWay& way) {
  update();
  const bool path = way.control == crack::Control::path;
  if (path && crack::common_range(tips_).is_empty()) return {};
  std::vector<crack::Candidate> candidates;
  for (const crack::Tip& tip : tips_) {
    const bool is_due = !path && !tip.range.holds(way.present);
    const double critical = is_due ? way.present : way.upwards ? tip.range.highest : tip.range.lowest;
    const double ratio = is_due ? tip.law.ratio(tip.factors, way.present) : 1;
    if (std::isfinite(critical)) candidates.push_back(crack::candidate(tip.id, critical, ratio, way));
  }
  return candidates;
}

std::size_t ElementTips::number_of(const crack::TipId& tip) const {
  const auto found = std::find_if(tips_.begin(), tips_.end(), [&](const crack::Tip& one) { return one.id == tip; });
  return static_cast<std::size_t>(found - tips_.begin());
}

}  // namespace bempd::model
