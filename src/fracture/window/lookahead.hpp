#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "fracture/window/active_window.hpp"
#include "fracture/evolution_state.hpp"
#include "fracture/freed_parts.hpp"
#include "fracture/window/window_certificate.hpp"
#include "fracture/window/window_zones.hpp"

namespace bempd::fracture {

// Energy of the displacement u0 + f u1 at the load factor f.
struct EnergyForm {
  double constant = 0, mixed = 0, proportional = 0;
  double at(double f) const { return 0.5 * (constant + 2 * f * mixed + f * f * proportional); }
};

// What an event will do once it happens.
struct ForeseenEvent {
  double load_factor;
  double ratio;            // largest stretch over the critical one
  std::vector<int> bonds;  // that break, ascending
  EnergyForm before, after;
  double work = 0, released = 0;  // of the break itself
  std::vector<double> reactions;  // after it
};

// Computes events ahead of time: a window around the hot bonds runs through them on condensed equations, and only those
// of which it is proven that the whole body would break in the same way are kept. It gives up before an event that it
// cannot perform: one near its rim or outside, one that frees a part of the body or takes away the last resistance to a
// motion.
class Lookahead {
 public:
  struct Options {
    double tie_band;
    int max_breaks_per_solve;
    double ahead;             // of a crack tip, in lattice spacings; 0: chosen by the size of the system
    double separated_energy;  // of the proportional load alone, below which the body is in pieces
    bool operator==(const Options&) const = default;
  };

  Lookahead(coupling::EquilibriumSystem& system, const FreedPartFinder& freed_parts, const StretchRatios& ratios,
            const std::vector<Point>& positions, const std::vector<std::vector<int>>& reaction_dofs);

  // Before the first factorization: windows are expected at the ends of initial cracks, given by the bonds they cut.
  void expect_cracks(const std::vector<int>& cut);

  // Around the bonds that are hot at the load factor of the next event. False if there is no window that would be
  // smaller than the problem.
  bool open(const EvolutionState& state, double load_factor, const Options& options);
  bool is_open() const { return window_ != nullptr; }
  void close();
  void forget();  // and where the window was: a new one is what it would be in a fresh run

  const Options& options() const { return options_; }

  // The next event on the way up from a load factor; null if the window has come to its end. Computes more events where
  // none is left; `before_computing` is called first, while the present states can still be asked for.
  const ForeseenEvent* next(double load_factor, const std::function<void()>& before_computing);
  // True if the window has come to its end before an event that no window can perform.
  bool needs_whole_body() const { return needs_whole_body_; }
  void take();  // the system's bonds break

  // States since the events were computed last, 0 first; only these can be asked for and returned to.
  int position() const { return position_; }
  void return_to(int position);
  coupling::Affine displacement(int position) const;
  // Of the whole body after the last of the events computed together; it stands for all of them.
  double residual() const { return residual_; }

 private:
  void compute(double load_factor);
  bool foresee(double load_factor);
  void leave_behind(double load_factor);
  void certify();
  void keep_first(int count);  // of the events computed
  double length_ahead() const;
  bool is_too_large(const std::vector<int>& nodes, const ZoneShape& shape) const;
  bool choose_nodes(const EvolutionState& state, double load_factor);
  std::vector<int> nodes_of(const std::vector<Zone>& zones) const;
  bool is_far_from_rim(const std::vector<int>& bonds) const;
  void keep(std::vector<Zone> zones, std::vector<int> nodes);
  void mark_rim();
  std::vector<ActiveWindow::Function> functions() const;
  EnergyForm energy(const Eigen::Matrix<double, Eigen::Dynamic, 2>& values) const;

  coupling::EquilibriumSystem& system_;
  const FreedPartFinder& freed_parts_;
  const StretchRatios& whole_ratios_;
  const std::vector<Point>& positions_;
  const std::vector<std::vector<int>>& reaction_dofs_;
  std::vector<double> spacing_;  // of the lattice at a node
  Options options_{};

  std::vector<Zone> zones_;
  std::vector<int> nodes_;            // in the zones
  std::vector<Zone> expected_zones_;  // of initial cracks
  std::vector<int> expected_nodes_;
  std::vector<char> touches_outside_, on_rim_;  // per node
  std::unique_ptr<coupling::Condensation> condensation_;
  std::unique_ptr<ActiveWindow> window_;
  std::unique_ptr<WindowCertificate> certificate_;
  Eigen::VectorXd any_displacement_;
  coupling::Affine whole_;  // displacements of the whole body in the last state
  bool proportional_ = false;
  bool has_ended_ = false;
  bool needs_whole_body_ = false;
  int most_events_ = 16;  // to compute at once

  std::vector<ForeseenEvent> events_;
  std::vector<coupling::Affine> states_;
  std::vector<LeftBehind::State> foreseen_;  // the states, while events are computed
  std::vector<OutsideCheck> checks_;
  std::size_t next_narrowing_ = 0;  // bonds broken then
  int position_ = 0;
  bool system_has_changed_ = false;
  double residual_ = 0, largest_force_ = 0;
};

}  // namespace bempd::fracture
