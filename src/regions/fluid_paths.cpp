#include "regions/fluid_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "regions/node_registry.hpp"

namespace bempd::regions {

namespace {

// Largest relative difference from the spacing at which a bond's length counts as one spacing.
constexpr double same_length = 1e-6;

// Distance in spacings below which two ends of facets count as one place.
constexpr double same_place = 0.1;

// Modulus c11 + c12 [Pa] of the lattice of each energy term (bond or cell square): pressure over strain if the strains
// in both directions are equal; 0 for energy terms that belong to no lattice.
std::vector<double> moduli_of_terms(const Discretization& d, const coupling::Terms& terms) {
  std::vector<double> moduli(terms.size(), 0.0);
  for (const auto& region : d.regions) {
    const auto bonds = region->bonds();
    if (!bonds) continue;
    const double modulus = region->elasticity().c11() + region->elasticity().c12();
    for (const int term : bonds->terms()) moduli[static_cast<std::size_t>(term)] = modulus;
  }
  for (const coupling::Terms::Following& pair : terms.following) moduli[pair.follower] = moduli[pair.leader];
  return moduli;
}

std::vector<double> pushes(const Discretization& d, const coupling::Terms& terms) {
  const std::vector<double> moduli = moduli_of_terms(d, terms);
  std::vector<double> push(terms.size(), 0.0);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (moduli[t] == 0) continue;
    double elongation = 0;  // under unit strains in both directions
    const Point& origin = d.positions[terms.first[t]];
    terms.for_each_entry(
        t, [&](int node, double x, double y) { elongation += Point(x, y).dot(d.positions[node] - origin); });
    push[t] = terms.stiffness[t] * elongation / moduli[t];
  }
  return push;
}

}  // namespace

pd::FluidPaths fluid_paths(const scene::Scene& scene, const Discretization& d, const coupling::Terms& terms,
                           const std::vector<pd::WeakenedTerm>& weakened) {
  pd::FluidPaths ways{{}, pushes(d, terms), weakened};
  for (const pd::WeakenedTerm& weak : weakened) ways.push[static_cast<std::size_t>(weak.term)] /= weak.share;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& region : d.regions)
    if (region->bonds()) least = std::min(least, scene.region(region->id()).resolution());
  NodeRegistry places(scene.bounding_box().min(), same_place * least);
  int asked = 0;  // each place gets a new region number, so that all places are compared
  for (const auto& region : d.regions) {
    const auto bonds = region->bonds();
    if (!bonds) continue;
    const double spacing = scene.region(region->id()).resolution();
    for (std::size_t t = bonds->first_bond(); t < bonds->first_bond() + bonds->list().size(); ++t) {
      if (std::abs(terms.length[t] - spacing) > same_length * spacing) continue;
      const Point middle = 0.5 * (d.positions[terms.first[t]] + d.positions[terms.second[t]]);
      const Point half = 0.5 * spacing * Point(-terms.sine[t], terms.cosine[t]);
      const Point from = middle - half, to = middle + half;
      const int first = places.add_shared(from, asked++), second = places.add_shared(to, asked++);
      ways.facets.push_back({static_cast<int>(t), from, to, {first, second}});
    }
  }
  return ways;
}

}  // namespace bempd::regions
