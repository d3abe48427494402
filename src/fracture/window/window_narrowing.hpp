#pragma once

#include <cstddef>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/window/window_locator.hpp"
#include "fracture/window/window_settings.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Narrows a window: it stops following the nodes behind the bonds that are close to breaking, where nothing breaks any
// more.
class WindowNarrowing {
 public:
  WindowNarrowing(const coupling::EquilibriumSystem& system, const WindowLocator& locator,
                  const std::vector<Point>& positions)
      : system_(system),
        locator_(locator),
        positions_(positions),
        behind_hot_(WindowSettings::behind_hot +
                    (system.terms().followers.empty() ? 0 : WindowSettings::reach_of_followers)) {}

  void restart();  // with a new window
  void stop();     // until then: where displacements are put right, what is left behind stays as rounding has made it

  // Narrows the window at intervals, at the load factor of an event. `dofs` are the degrees of freedom that the
  // window's condensation keeps.
  void narrow(WindowSolver& window, const std::vector<int>& dofs, double load_factor);

  // Reach of a line's tip: bonds up to the distance `back` behind its place are still needed, so the window is narrowed
  // only behind that.
  struct Reach {
    Point place;
    double back;
  };
  void narrow(WindowSolver& window, const std::vector<int>& dofs, const std::vector<Reach>& tips);

 private:
  bool is_due(const WindowSolver& window);
  void leave(WindowSolver& window, const std::vector<int>& dofs, const std::vector<double>& rear) const;
  // Coordinate along each zone's axis of the hindmost bond that is close to breaking; minus infinity if there is none.
  std::vector<double> rears(const WindowSolver& window, double load_factor) const;
  bool is_needed(int node, const std::vector<double>& rear) const;

  const coupling::EquilibriumSystem& system_;
  const WindowLocator& locator_;
  const std::vector<Point>& positions_;
  double behind_hot_;     // in lattice spacings
  std::size_t next_ = 0;  // bonds broken then
};

}  // namespace bempd::fracture
