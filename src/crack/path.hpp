#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "crack/extension.hpp"
#include "geometry/point.hpp"

namespace bempd::crack {

// Vertex of a crack's path, with values of the growth that led to it. The values are NaN if the host described the
// vertex or the crack began there.
struct PathVertex {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  Point place{0, 0};
  std::int64_t event = 0;  // event in which the crack grew to this vertex; 0: described by the host
  int end = -1;            // end of the crack that grew; -1: none
  double load_factor = unknown;
  Point factors{unknown, unknown};  // K_I and K_II of the tip before this growth [Pa m^(1/2)]
  double energy_release_rate = unknown, resistance = unknown;  // of this growth, and met by it [J/m^2]
};

// Path of a crack from its start to its end: the points that the host described and the end points of the extensions.
// `described` is empty for a crack that began in the run.
std::vector<PathVertex> path_of(int crack, std::span<const Point> described, std::span<const Extension> extensions);

std::vector<Point> points_of_path(const std::vector<PathVertex>& path);
double length_of(const std::vector<PathVertex>& path);

}  // namespace bempd::crack
