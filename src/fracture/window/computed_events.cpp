#include "fracture/window/computed_events.hpp"

namespace bempd::fracture {

void ComputedEvents::take_back(int count) {
  for (auto e = this->count(); e-- > count;) system_.stages().enter(list_[e].back);
}

void ComputedEvents::keep_first(int count) {
  take_back(count);
  list_.resize(count);
}

void ComputedEvents::take() {
  system_.stages().enter(list_[position_].event.changes);
  have_changed_terms_ = true;
  ++position_;
}

void ComputedEvents::return_to(int position) noexcept {
  while (position_ > position) system_.stages().enter(list_[--position_].back);
}

std::vector<std::uint8_t> ComputedEvents::stages(int position) const {
  std::vector<std::uint8_t> result = system_.stages().numbers();
  for (int e = position_; e-- > position;) {
    for (const coupling::StageChange& c : list_[e].back) result[c.term] = static_cast<std::uint8_t>(c.stage);
  }
  return result;
}

}  // namespace bempd::fracture
