#pragma once

#include <memory>
#include <vector>

#include "pd/deformation.hpp"
#include "pd/network.hpp"
#include "regions/fields.hpp"

namespace bempd::regions {

// Bonds at the points of a region, including bonds to other regions of its body, and their numbers in the scene. The
// region's own bonds are consecutive in the scene: `listed` bonds from the number `first` on. These are the bonds
// between two points of the region, except bonds of which an earlier region of the same body also has both ends.
struct SceneBonds {
  std::shared_ptr<const pd::Network> network;  // shared by regions that are alike
  std::size_t first = 0, listed = 0;           // first own bond, and number of own bonds
  std::vector<int> of_scene;                   // number of each bond in the scene; empty if all bonds are own ones
  // Points of other regions at which bonds of this region end; they are numbered after the region's own points.
  std::vector<int> far_nodes;     // numbers in the scene
  std::vector<Point> far_points;  // places in grid coordinates
  // Number in the scene of the first cell square (energy term) of each cell, by the grid point at the cell's lower left
  // corner; -1 for other points. In a region with points on its outline the numbers are listed by patch (group of
  // cells). The list is empty if the material has no cell squares.
  std::vector<int> squares;

  const std::vector<pd::Bond>& all() const { return network->bonds; }
  // Number of a bond in the scene.
  std::size_t number(std::size_t bond) const {
    return of_scene.empty() ? first + bond : static_cast<std::size_t>(of_scene[bond]);
  }
  // Flags of all bonds: nonzero if the bond is broken or cut. `intact` is the scene's.
  std::vector<std::uint8_t> broken(const std::vector<char>& intact) const;
  pd::BondStates states(const Solution& solution) const;
  // Damage of the first `points` points: 1 - n / n0 with the numbers n of a point's intact bonds and n0 of its bonds
  // without any crack.
  std::vector<double> damage(const std::vector<char>& intact, std::size_t points) const;
  // Stretch of the region's own bonds.
  std::vector<double> stretch(const Solution& solution) const;
};

}  // namespace bempd::regions
