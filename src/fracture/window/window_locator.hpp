#pragma once

#include <vector>

#include "coupling/equilibrium_system.hpp"
#include "fracture/critical_events.hpp"
#include "fracture/window/window_origin.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Whether events of a system may be computed in windows (regions around crack tips or bonds close to breaking that are
// solved alone): the system is symmetric, no forces act at zero displacements (by rest elongations or closed exact
// constraints), and cell squares (wide terms) break only with the bonds that they follow. Events of other systems are
// computed on the whole body.
bool has_window_form(const coupling::EquilibriumSystem& system);

// Finds the location of a window: zones (rectangles) around the bonds close to breaking, and the nodes in the zones,
// which the system is told to eliminate last.
class WindowLocator {
 public:
  WindowLocator(coupling::EquilibriumSystem& system, const StretchRatios& ratios, const std::vector<Point>& positions);

  // Chooses the location of windows at the ends of the initial cracks, which have broken the bonds `cut`. Called before
  // the first factorization.
  void expect_cracks(const std::vector<int>& cut);
  // Returns to the location that expect_cracks() has chosen, as in a run that has just begun.
  void return_to_expected();

  // Chooses a location around the bonds close to breaking at a load factor; keeps the present location if it contains
  // them. `ahead` is the length of the window in front of a crack tip in spacings; 0: chosen by the size of the system.
  // False if no window would be smaller than the problem.
  bool choose(double load_factor, double tie_band, double ahead);

  // Path of the tip of a crack line (crack that grows in a lattice by steps) over its next steps, and the intact bonds
  // across the path.
  struct PathAhead {
    Point from, direction;
    double horizon;
    std::vector<int> bonds;
  };
  // Chooses a location around the next steps of crack tips; keeps the present location if it contains them. False if no
  // window would be smaller than the problem.
  bool choose(const std::vector<PathAhead>& paths, double ahead);

  WindowLocation memory() const { return {zones_, nodes_, system_.factor().keeps_last(nodes_)}; }
  void go_back_to(WindowLocation memory);
  void keep_location() { mark_rim(); }  // keeps the location, with the rim that the present terms give

  const std::vector<Zone>& zones() const { return zones_; }
  double spacing(int node) const { return spacing_[node]; }  // of the lattice at a node

  // Whether none of the bonds is at the rim of the window; bonds at the rim are left to the next window.
  bool is_far_from_rim(const std::vector<int>& bonds) const;

 private:
  double length_ahead(double wanted) const;
  bool is_too_large(const std::vector<int>& nodes, const ZoneShape& shape) const;
  bool still_holds(const std::vector<int>& hot);
  std::vector<int> hot_bonds(double load_factor, double share) const;
  std::vector<int> nodes_of(const std::vector<Zone>& zones) const;
  std::vector<char> marks_of_nodes() const;
  void keep(std::vector<Zone> zones, std::vector<int> nodes);
  void mark_rim();

  coupling::EquilibriumSystem& system_;
  const StretchRatios& ratios_;
  const std::vector<Point>& positions_;
  std::vector<double> spacing_;
  std::vector<Zone> zones_;
  std::vector<int> nodes_;            // nodes in the zones
  std::vector<Zone> expected_zones_;  // at the ends of initial cracks
  std::vector<int> expected_nodes_;
  std::vector<char> touches_outside_, on_rim_;  // flags of nodes
};

}  // namespace bempd::fracture
