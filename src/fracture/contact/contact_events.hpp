#pragma once

#include <optional>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Source of contact events: crack faces that close or open between two breaks. Nothing breaks and no energy is
// released, unless a part comes free, but the stiffness changes. Under loads proportional to the load factor from rest
// there is one such event, at the very beginning.
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
