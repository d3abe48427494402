#pragma once

#include <cstddef>
#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/window/active_window.hpp"
#include "fracture/window/window_place.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

// Lets a window leave behind what lies behind the bonds that are hot: nothing breaks there any more.
class Narrowing {
 public:
  Narrowing(const coupling::EquilibriumSystem& system, const WindowPlace& place, const std::vector<Point>& positions)
      : system_(system),
        place_(place),
        positions_(positions),
        behind_hot_(WindowSettings::behind_hot +
                    (system.terms().followers.empty() ? 0 : WindowSettings::reach_of_followers)) {}

  void restart();  // with a new window
  void stop();     // until then: where displacements are put right, what is left behind stays as rounding has made it

  // From time to time, at the load factor of an event. `dofs` are those kept by the window's condensation.
  void narrow(ActiveWindow& window, const std::vector<int>& dofs, double load_factor);

  // The same behind the tips of lines, which reach so far back from their places.
  struct Reach {
    Point place;
    double back;
  };
  void narrow(ActiveWindow& window, const std::vector<int>& dofs, const std::vector<Reach>& tips);

 private:
  bool is_due(const ActiveWindow& window);
  void leave(ActiveWindow& window, const std::vector<int>& dofs, const std::vector<double>& rear) const;
  // Per zone the place along its axis of the hindmost hot bond; minus infinity where nothing is hot.
  std::vector<double> rears(const ActiveWindow& window, double load_factor) const;
  bool is_needed(int node, const std::vector<double>& rear) const;

  const coupling::EquilibriumSystem& system_;
  const WindowPlace& place_;
  const std::vector<Point>& positions_;
  double behind_hot_;     // in lattice spacings
  std::size_t next_ = 0;  // bonds broken then
};

}  // namespace bempd::fracture
