#pragma once

#include <optional>
#include <vector>

#include "fracture/contact/face_forecast.hpp"
#include "fracture/event_body.hpp"
#include "fracture/window/window_functions.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Window (region around crack tips or bonds close to breaking that is solved alone) as a body that events change while
// they are computed ahead. An event changes the flexibility of the window, and the damage stages of terms in the
// system. An event that frees a part of the body or removes the last resistance to a motion cannot be performed.
class WindowBody final : public EventBody {
 public:
  // Window that performs the event leading to state number `state` (after as many events); `face_forecast` knows the
  // contact constraints in all states. `displacement` is any displacement of the body, used to ask which parts an event
  // frees.
  WindowBody(LoadedBody& body, WindowSolver& window, const WindowFunctions& functions, FaceForecast& face_forecast,
             int state, const Eigen::VectorXd& displacement)
      : body_(body),
        system_(body.system()),
        window_(window),
        functions_(functions),
        face_forecast_(face_forecast),
        state_(state),
        displacement_(displacement) {}

  double stored_energy(double load_factor) const override { return energy().at(load_factor); }
  double unit_energy() const override { return energy().unit(); }
  std::vector<double> reactions(double load_factor) const override {
    return functions_.reactions(window_.rows().functions(), load_factor);
  }
  Elongation elongation(int term, double load_factor) const override;
  std::optional<BodyChange> change(const Event& event, std::span<const ChangingTerm> terms, Outcome& outcome) override;

  // Stored energy as a function of the load factor.
  EnergyForm energy() const { return WindowFunctions::energy(window_.rows().functions()); }
  // Contact state after an event at which faces have closed or opened; empty if none has.
  const std::optional<FaceState>& switched_faces() const { return switched_faces_; }

 private:
  bool change_terms(const Event& event);
  bool settle_constraints(const Event& event, Outcome& outcome);
  bool presses_on_held_parts() const;
  std::vector<std::size_t> wrong_constraints(double load_factor) const;
  double released_by_constraints(const coupling::Affine& kept_before, double load_factor) const;

  LoadedBody& body_;
  coupling::EquilibriumSystem& system_;
  WindowSolver& window_;
  const WindowFunctions& functions_;
  FaceForecast& face_forecast_;
  int state_;
  const Eigen::VectorXd& displacement_;
  std::vector<std::size_t> watched_before_;  // constraints in the forecast, before the event switches any
  std::optional<FaceState> switched_faces_;
};

}  // namespace bempd::fracture
