#include "fracture/return_point.hpp"

#include <utility>

namespace bempd::fracture {

void ReturnPoint::begin_call() {
  call_.emplace();
  if (!window_.is_open()) keep_continuation();
}

void ReturnPoint::keep_continuation() {
  if (call_ && !call_->continuation) call_->continuation = resumption_.present();
}

void ReturnPoint::mark() {
  if (mark_) return;
  keep_continuation();
  mark_ = window_.is_open() ? Mark{{}, window_.place()} : Mark{body_.state(), {}};
}

void ReturnPoint::complete() {
  if (!mark_ || !mark_->place) return;
  mark_->state = window_.state_at(*mark_->place);
  mark_->place.reset();
}

void ReturnPoint::replace_place(const BodyState& state) {
  if (mark_ && mark_->place) mark_ = Mark{state, {}};
}

ReturnPoint::Back ReturnPoint::go_back() noexcept {
  const bool has_state = mark_ && !mark_->place;
  if (has_state) body_.state() = std::move(mark_->state);
  if (mark_ && mark_->place) window_.return_to(*mark_->place);
  Back back{!has_state && window_.is_open(), {}};
  if (!back.is_in_window && call_ && call_->continuation) back.continuation = std::move(*call_->continuation);
  drop();
  return back;
}

}  // namespace bempd::fracture
