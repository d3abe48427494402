#include "even_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace directions {
namespace {

constexpr double pi = std::numbers::pi;

// A bond's direction without its sign, in millionths of a degree.
long direction_of(const Bond& bond) {
  const double degrees = std::atan2(bond.direction.y(), bond.direction.x()) * 180 / pi;
  return std::lround(std::fmod(degrees + 360, 180) * 1e6) % 180000000;
}

// Energy of the bonds of each direction, for a cut straight across it: one bond of each length a point.
std::map<long, double> energies(const Body& lattice, const std::vector<double>& factors) {
  std::map<std::pair<long, long>, double> members;
  for (std::size_t k = 0; k < lattice.bonds.size(); ++k) {
    const Bond& bond = lattice.bonds[k];
    const double stretch = factors[k] * lattice.critical_stretch;
    members[{direction_of(bond), std::lround(bond.length * 1e6)}] =
        bond.stiffness * stretch * stretch * std::pow(bond.length, 3) / 2;
  }
  std::map<long, double> found;
  for (const auto& [member, energy] : members) found[member.first] += energy;
  return found;
}

}  // namespace

Cuts cost_of_cuts(const Body& lattice, const std::vector<double>& factors) {
  const std::map<long, double> along = energies(lattice, factors);
  Cuts cuts{1e300, 0};
  double sum = 0;
  constexpr int steps = 18000;
  for (int k = 0; k < steps; ++k) {
    double cost = 0;
    for (const auto& [direction, energy] : along)
      cost += energy * std::abs(std::sin(k * pi / steps - static_cast<double>(direction) * 1e-6 * pi / 180));
    cuts.least = std::min(cuts.least, cost);
    cuts.largest = std::max(cuts.largest, cost);
    sum += cost;
  }
  return {cuts.least / sum * steps, cuts.largest / sum * steps};
}

std::vector<double> even_stretches(const Body& lattice) {
  const std::map<long, double> now = energies(lattice, std::vector<double>(lattice.bonds.size(), 1));
  std::vector<double> directions;
  for (const auto& [direction, energy] : now) directions.push_back(static_cast<double>(direction) * 1e-6 * pi / 180);
  // The slope of the cost jumps by twice the energy at each direction: edges of a polygon about a circle.
  const std::size_t n = directions.size();
  std::vector<double> wanted(n);
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double before = directions[k] - (k > 0 ? directions[k - 1] : directions[n - 1] - pi);
    const double after = (k + 1 < n ? directions[k + 1] : directions[0] + pi) - directions[k];
    sum += wanted[k] = std::tan(before / 2) + std::tan(after / 2);
  }
  std::map<long, double> factor;
  std::size_t k = 0;
  for (const auto& [direction, energy] : now) factor[direction] = std::sqrt(wanted[k++] / sum * pi / 2 / energy);
  std::vector<double> factors;
  for (const Bond& bond : lattice.bonds) factors.push_back(factor[direction_of(bond)]);
  return factors;
}

}  // namespace directions
