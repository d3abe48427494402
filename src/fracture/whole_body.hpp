#pragma once

#include <vector>

#include "fracture/event_body.hpp"

namespace bempd::fracture {

// Whole body, in which an event is performed by a low-rank change of the system and a new solution. Parts that come
// free are held, so that every event can be performed. The state has to be at the event's load factor.
class WholeBody final : public EventBody {
 public:
  explicit WholeBody(LoadedBody& body) : body_(body), system_(body.system()) {}

  double stored_energy(double load_factor) const override { return body_.response().stored_energy_at(load_factor); }
  double unit_energy() const override { return body_.response().unit_energy(); }
  std::vector<double> reactions(double) const override { return body_.supports().reactions(); }
  Elongation elongation(int term, double load_factor) const override;
  std::optional<BodyChange> change(const Event& event, std::span<const ChangingTerm> terms, Outcome& outcome) override;

 private:
  void remember_constraints();
  bool loses_resistance(std::span<const ChangingTerm> terms) const;
  std::vector<double> released_by_constraints(const Eigen::VectorXd& before) const;

  LoadedBody& body_;
  coupling::EquilibriumSystem& system_;
  std::vector<char> closed_before_;     // before the event: flags of closed constraints
  Eigen::VectorXd multipliers_before_;  // before the event: multipliers of exact constraints
};

}  // namespace bempd::fracture
