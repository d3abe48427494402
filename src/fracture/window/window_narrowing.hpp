#pragma once

#include <cstddef>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/window/window_locator.hpp"
#include "fracture/window/window_settings.hpp"
#include "fracture/window/window_solver.hpp"

namespace bempd::fracture {

// Narrowing of a window (region around crack tips or bonds close to breaking that is solved alone): the window stops
// following the nodes behind the bonds that are close to breaking, because nothing breaks there any more.
class WindowNarrowing {
 public:
  WindowNarrowing(const coupling::EquilibriumSystem& system, const WindowLocator& locator,
                  const std::vector<Point>& positions)
      : system_(system),
        locator_(locator),
        positions_(positions),
        behind_hot_(WindowSettings::behind_hot +
                    (system.terms().followers.empty() ? 0 : WindowSettings::reach_of_followers)) {}

  void restart();  // begins with a new window
  // Stops narrowing until restart(). Used when displacements have to be corrected, because dropped nodes would keep
  // their rounding errors.
  void stop();

  // Narrows the window to what lies around the bonds close to breaking at a load factor, if enough bonds have broken
  // since the last time. `dofs` are all degrees of freedom of the window's nodes, followed or dropped.
  void narrow(WindowSolver& window, const std::vector<int>& dofs, double load_factor);

  // Region behind the tip of a crack line (crack that grows in a lattice by steps) that the window still needs: up to
  // the distance `back` [m] behind `place`, so that the window is narrowed only farther behind.
  struct Reach {
    Point place;
    double back;
  };
  void narrow(WindowSolver& window, const std::vector<int>& dofs, const std::vector<Reach>& tips);

 private:
  bool is_due(const WindowSolver& window);
  void leave(WindowSolver& window, const std::vector<int>& dofs, const std::vector<double>& rear) const;
  // Coordinate, along the axis of each zone, of the hindmost bond in it that is close to breaking; minus infinity if
  // there is none.
  std::vector<double> rears(const WindowSolver& window, double load_factor) const;
  bool is_needed(int node, const std::vector<double>& rear) const;

  const coupling::EquilibriumSystem& system_;
  const WindowLocator& locator_;
  const std::vector<Point>& positions_;
  double behind_hot_;     // in lattice spacings
  std::size_t next_ = 0;  // number of broken bonds at which the window is narrowed next
};

}  // namespace bempd::fracture
