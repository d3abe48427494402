#pragma once

#include <optional>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Source of events at which terms (bonds and cell squares) of the body break. Events are performed on the whole body
// (WholeBody). The displacements of the state have to be up to date.
class WholeBodyEvents final : public EventSource {
 public:
  explicit WholeBodyEvents(LoadedBody& body) : body_(body), system_(body.system()) {}

  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;
  Outcome perform(Event event);  // performs an event that another source has found

 private:
  std::optional<double> next_load_factor(double target, const SteppingOptions& options);
  // End of the first increment at which a term exceeds its critical value; empty if there is none up to the target.
  std::optional<double> next_increment(double target, double increment) const;
  void choose_terms(const SteppingOptions& options);

  LoadedBody& body_;
  coupling::EquilibriumSystem& system_;
  Event event_;
};

}  // namespace bempd::fracture
