#pragma once

#include <optional>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Faces of cracks that close or open between two breaks, where the displacements are those of the body's state: nothing
// breaks and no energy is lost, unless a part comes free, but from there on the body follows the load factor in another
// way. Under loads that grow in proportion from rest there is one such event, at the very beginning.
class ContactEvents final : public EventSource {
 public:
  explicit ContactEvents(LoadedBody& body) : body_(body) {}

  // The event of faces on the way to a target, or to an event that comes before the target; null if there is none.
  const Event* before(const Event* event, double target);
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
