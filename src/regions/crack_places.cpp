#include "regions/crack_places.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "geometry/segment.hpp"

namespace bempd::regions {

namespace {

// Fraction of the straight line from a place on a crack to a material point that is left out at the start, so that the
// line does not touch the crack at the place itself.
constexpr double off_the_crack = 1e-3;

bool cross_each_other(const Point& a, const Point& b, const Point& c, const Point& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

bool is_crossed(const std::vector<scene::Crack>& cracks, const Point& from, const Point& to) {
  return std::any_of(cracks.begin(), cracks.end(), [&](const scene::Crack& crack) {
    for (std::size_t k = 0; k + 1 < crack.points.size(); ++k)
      if (cross_each_other(from, to, crack.points[k], crack.points[k + 1])) return true;
    return false;
  });
}

double modulus_of_one_stress(const PlaneElasticity& e) {
  return e.state == PlaneState::stress ? e.young_modulus : e.young_modulus / (1 - e.poisson_ratio * e.poisson_ratio);
}

}  // namespace

pd::FacePlaces face_lattices(const Discretization& d) {
  std::vector<pd::FacePlaces::Body> bodies;
  for (const auto& region : d.regions) {
    if (!region->bonds()) continue;
    const std::optional<pd::FaceLattice> lattice = region->bonds()->face_lattice();
    if (!lattice) continue;
    const PlaneElasticity& e = region->elasticity();
    bodies.push_back({*lattice, e.thickness * modulus_of_one_stress(e), region->nodes()});
  }
  return {d.positions, bodies};
}

std::vector<pd::FacePlace> places_on_cracks(const std::vector<scene::Crack>& cracks, const Discretization& d,
                                            const pd::FacePlaces& lattices) {
  std::vector<pd::FacePlace> found;
  const auto reaches = [&](int node, const Point& place) {
    const Point& to = d.positions[static_cast<std::size_t>(node)];
    return !is_crossed(cracks, place + off_the_crack * (to - place), to);
  };
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const std::vector<Point>& points = cracks[c].points;
    if (!d.cracks[c].cuts_bonds()) continue;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      check_cancelled();
      const Point along = (points[k + 1] - points[k]).normalized(), normal(-along.y(), along.x());
      for (int lattice = 0; lattice < static_cast<int>(lattices.lattice_count()); ++lattice) {
        for (const auto& [place, length] : lattices.crossings(lattice, points[k], points[k + 1])) {
          auto one = lattices.at(lattice, place, normal, length, reaches);
          if (one) found.push_back(std::move(*one));
        }
      }
    }
  }
  return found;
}

}  // namespace bempd::regions
