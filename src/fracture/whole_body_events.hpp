#pragma once

#include <optional>
#include <vector>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Events looked for among all bonds of the body and performed by a low-rank change and a solution of the whole system.
// What comes free is held. Where the body's displacements are those of its state this source can always go on.
class WholeBodyEvents final : public EventSource {
 public:
  explicit WholeBodyEvents(LoadedBody& body) : body_(body), system_(body.system()) {}

  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;

 private:
  std::optional<double> next_load_factor(double target, const SteppingOptions& options);
  // End of the first increment, not beyond the target, at which a bond exceeds its critical stretch.
  std::optional<double> next_increment(double target, double increment) const;
  void choose_bonds(const SteppingOptions& options);

  bool runs_away(const std::vector<double>& elongation);
  double released_energy(const std::vector<double>& elongation) const;

  LoadedBody& body_;
  coupling::EquilibriumSystem& system_;
  Event event_;
};

}  // namespace bempd::fracture
