#pragma once

#include <vector>

#include "fracture/critical_events.hpp"
#include "fracture/window/window_settings.hpp"
#include "geometry/point.hpp"

namespace bempd::fracture {

// Zone of a window (region that is solved alone): rectangle around bonds about to break, longer in the direction in
// which the next breaks are expected. `low` and `high` are coordinates along `axis` (first) and across it (second) from
// `centre`, in the model's unit of length.
struct Zone {
  Point centre, axis;
  Point low, high;
  Point inner_low, inner_high;  // bonds beyond these limits are too near to the rim to break in the window

  Point coordinates(const Point& p) const {
    const Point r = p - centre;
    return {axis.dot(r), cross(axis, r)};
  }
  bool contains(const Point& p) const;
  bool is_inner(const Point& p) const;
};

// Size of a zone around some bonds in lattice spacings: length ahead of the bonds, length behind them, and half of the
// zone's width.
struct ZoneShape {
  double ahead;
  double back = WindowSettings::back;
  double half_width = WindowSettings::half_width;
};

// Zones around the bonds `hot` (close to breaking) at a load factor, one for each crowd (group of hot bonds). `spacing`
// is the lattice spacing at each node.
std::vector<Zone> zones_of(const std::vector<int>& hot, const StretchRatios& ratios, double load_factor,
                           const std::vector<char>& intact, const std::vector<Point>& positions,
                           const std::vector<double>& spacing, const ZoneShape& shape);

// Zone of a window in front of a crack tip.
Zone zone_ahead(const Point& tip, const Point& direction, double spacing, const ZoneShape& shape);

// Zones in front of both ends of each initial crack; the initial cracks have broken the bonds `cut`.
std::vector<Zone> zones_at_ends(const std::vector<int>& cut, const coupling::Terms& bonds,
                                const std::vector<Point>& positions, const std::vector<double>& spacing,
                                const ZoneShape& shape);

}  // namespace bempd::fracture
