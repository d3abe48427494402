#pragma once

#include <optional>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Source of contact events: crack faces that close or open between two breaks. Nothing breaks at such an event, but the
// stiffness changes; energy is released only if a part comes free. Under loads proportional to the load factor from
// rest there is one contact event only, at the very beginning.
class ContactEvents final : public EventSource {
 public:
  explicit ContactEvents(LoadedBody& body) : body_(body) {}

  // Contact event before `event`, or before `target` if `event` is null; null if there is none.
  const Event* before(const Event* event, double target);
  // Whether a contact event comes before a load factor.
  bool is_before(double load_factor);

  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;

 private:
  std::optional<double> switch_before(double load_factor);

  LoadedBody& body_;
  Event event_;
  double direction_ = 0;
};

}  // namespace bempd::fracture
