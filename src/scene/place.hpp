#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "geometry/point.hpp"
#include "hash.hpp"

namespace bempd::regions {
struct Discretization;
struct DofConditions;
struct PlacedNode;
}  // namespace bempd::regions

namespace bempd::scene {

class Scene;

// Place at which a support or a load acts. Each kind of place tells where elements have to end, which nodes a support
// holds, and which forces a load puts on nodes.
class Place {
 public:
  virtual ~Place() = default;

  // Throws Error (argument) if the scene does not contain the place.
  virtual void check(const Scene& scene) const = 0;

  // Whether the place depends on this region, so that the region cannot be removed alone.
  virtual bool needs(int /*region*/) const { return false; }

  // The point that this place is; empty if the place is not a point.
  virtual std::optional<Point> point() const { return std::nullopt; }
  // Edge (id of its region, number) that this place is, or is a part of; else empty.
  virtual std::optional<std::pair<int, int>> edge() const { return std::nullopt; }

  // Whether values may vary along the place, by fractions of its length.
  virtual bool lies_along_a_line() const { return edge().has_value(); }

  // Whether the place depends on this crack, because it lies on the crack.
  virtual bool needs_crack(int /*crack*/) const { return false; }

  // Whether loads at this place become a part of operators, so that their values cannot change once operators are
  // built.
  virtual bool is_built_in() const { return false; }

  // Adds the place, as the host described it, to the fingerprint of the scene.
  virtual void identify(Hash& hash) const = 0;

  // Fractions of an edge at which elements have to end, because the place begins, ends or acts there.
  virtual std::vector<double> breaks_on(const Scene& scene, int region, int edge, double tolerance) const = 0;

  // Whether the boundary around this fraction of an edge belongs to the place.
  virtual bool covers(int region, int edge, double fraction) const = 0;

  // Nodes at this place that the scene's support number `support` (from 0) holds. Throws Error (argument) if there are
  // no such nodes.
  virtual std::vector<regions::PlacedNode> held_nodes(const Scene& scene, const regions::Discretization& discretization,
                                                      int support) const = 0;

  // Adds the forces that the scene's load number `load` (from 0) has at this place to `conditions`.
  virtual void add_load(const Scene& scene, const regions::Discretization& discretization, int load,
                        regions::DofConditions& conditions) const = 0;
};

}  // namespace bempd::scene
