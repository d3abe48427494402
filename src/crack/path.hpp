#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "crack/extension.hpp"
#include "geometry/point.hpp"

namespace bempd::crack {

// Vertex of a crack's path. Load factor, stress intensity factors and rates of the growth to it are NaN if the vertex
// was described by the host or is where the crack began.
struct PathVertex {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  Point place{0, 0};
  std::int64_t event = 0;  // event of the growth to here; 0: the vertex was described
  int end = -1;            // that grew; -1: none
  double load_factor = unknown;
  Point factors{unknown, unknown};                             // K_I and K_II of the tip just before [Pa m^(1/2)]
  double energy_release_rate = unknown, resistance = unknown;  // in its direction, and met there [J/m^2]
};

// Path of a crack from its start to its end: the points that the host described (none for a crack that began in the
// run) and the end points of its extensions.
std::vector<PathVertex> path_of(int crack, std::span<const Point> described, std::span<const Extension> extensions);

std::vector<Point> points_of_path(const std::vector<PathVertex>& path);
double length_of(const std::vector<PathVertex>& path);

}  // namespace bempd::crack
