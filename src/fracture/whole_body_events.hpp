#pragma once

#include <optional>
#include <vector>

#include "fracture/event_source.hpp"
#include "fracture/loaded_body.hpp"

namespace bempd::fracture {

// Events looked for among all terms of the body and performed by a low-rank change and a solution of the whole system.
// What comes free is held. Where the body's displacements are those of its state this source can always go on.
class WholeBodyEvents final : public EventSource {
 public:
  explicit WholeBodyEvents(LoadedBody& body) : body_(body), system_(body.system()) {}

  const Event* next(double target, const SteppingOptions& options) override;
  Outcome perform() override;
  Outcome perform(Event event);  // one that another source has told

 private:
  std::optional<double> next_load_factor(double target, const SteppingOptions& options);
  // End of the first increment, not beyond the target, at which a term exceeds its critical value.
  std::optional<double> next_increment(double target, double increment) const;
  void choose_terms(const SteppingOptions& options);

  bool runs_away();
  void remember_faces();
  void add_energies(const Eigen::VectorXd& before, const Eigen::VectorXd& flow, bool loads_lost,
                    Outcome& outcome) const;
  void tell_of_body(Outcome& outcome);
  double released_energy() const;
  double released_by_contacts(const Eigen::VectorXd& before) const;
  double released_by_faces() const;

  // A term of the event as it was just before.
  struct Changing {
    double stiffness_lost, force_lost;  // force: the constant one
    double elongation, elastic;         // elastic: beyond the rest elongation
  };
  Changing changing(const coupling::StageChange& change) const;

  LoadedBody& body_;
  coupling::EquilibriumSystem& system_;
  Event event_;
  std::vector<Changing> changing_;   // in the order of the event
  std::vector<char> closed_before_;  // of the places where faces meet
  // Of those inside operators; without any, none.
  Eigen::VectorXd forces_before_, gaps_before_;
};

}  // namespace bempd::fracture
