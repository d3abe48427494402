#include "fracture/line/line_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fracture/line/on_limits.hpp"

namespace bempd::fracture {

namespace {

// Largest length of a step in spacings: a tip with no bonds ahead within this length has arrived at an edge or a crack.
constexpr int most_empty_steps = 2;

// Largest length of a ligament (sound material) between a tip and a free edge that breaks in one step, in horizons; one
// spacing is added. Ahead of such a tip no stress point is left that gives its load, and the ligament would carry twice
// the correct load (docs/directions.md).
constexpr double shortest_ligament = 1;
// Distance from a place on an edge, in spacings. If boundary elements or supports lie within this distance, the edge
// does not count as free.
constexpr double around_edge = 1.5;

// Number of places, within one spacing of the path ahead of a tip, at which a crack face is searched.
constexpr int samples = 10;
// Limits for the bonds by which a crack face ahead is found: largest distance from the tip's path in spacings, and
// least cosine of the angle to the path.
constexpr double beside = 1, least_cosine = 0.8;
// Least number of bonds along the path near a place. If all of them are broken, a crack face lies there.
constexpr int enough_bonds = 2;

}  // namespace

LinePath::LinePath(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions,
                   const TipStress& stress)
    : system_(system),
      positions_(positions),
      stress_(stress),
      terms_from_(linalg::make_adjacency(positions.size(), [&](const auto& add) {
        const std::vector<int>& first = system.terms().first;
        for (std::size_t t = 0; t < first.size(); ++t) add(first[t], static_cast<int>(t));
      })) {}

// Distance from a tip along its path to the face of another crack, where all bonds along the path are broken; empty if
// there is no such face within a spacing.
std::optional<double> LinePath::face_ahead(const Point& tip, const Point& direction, const pd::TipLaw& law) const {
  const coupling::Terms& terms = system_.terms();
  std::array<int, samples> present{}, left{};
  const auto count = [&](std::size_t t, const Point& from) {
    const Point bond = terms.length[t] * Point(terms.cosine[t], terms.sine[t]);
    if (std::abs(bond.dot(direction)) < (least_cosine - rounding_of_places) * terms.length[t]) return;
    for (int k = 0; k < samples; ++k) {
      const double at = (k + 1) * law.spacing / samples, part = (at - from.dot(direction)) / bond.dot(direction);
      if (part <= rounding_of_places || part >= 1 - rounding_of_places) continue;
      if (std::abs(cross(direction, from + part * bond)) > (beside + rounding_of_places) * law.spacing) continue;
      ++present[static_cast<std::size_t>(k)];
      left[static_cast<std::size_t>(k)] += system_.stages().intact()[t] != 0 ? 1 : 0;
    }
  };
  for (const int node : stress_.near().about(tip, law.horizon + law.spacing)) {
    const Point from = positions_[static_cast<std::size_t>(node)] - tip;
    if (from.norm() > law.horizon + law.spacing) continue;
    for (const int term : terms_from_.of(node))
      if (!terms.is_wide(static_cast<std::size_t>(term))) count(static_cast<std::size_t>(term), from);
  }
  for (std::size_t k = 0; k < samples; ++k)
    if (present[k] >= enough_bonds && left[k] == 0) return static_cast<double>(k + 1) * law.spacing / samples;
  return std::nullopt;
}

// Whether the edge at a place is free: no boundary element and no support lies within `reach`.
bool LinePath::is_free(const Point& edge, double reach) const {
  for (const int node : stress_.near().about(edge, reach)) {
    if ((positions_[static_cast<std::size_t>(node)] - edge).norm() > reach) continue;
    if (system_.dense_bodies().contain(node) || system_.unknowns().is_prescribed(2 * node) ||
        system_.unknowns().is_prescribed(2 * node + 1))
      return false;
  }
  return true;
}

// Distance from a tip to the place where its path leaves the body through a free edge; empty if the path meets no free
// edge within a horizon and a spacing.
std::optional<double> LinePath::edge_ahead(const Point& tip, const Point& direction, const pd::TipLaw& law) const {
  const int farthest = static_cast<int>(std::lround(shortest_ligament * law.horizon / law.spacing)) + 1;
  const double around = around_edge * law.spacing, reach = farthest * law.spacing + around;
  if (stress_.nearest_outline(tip, reach) >= reach) return std::nullopt;
  for (int k = 0; k <= farthest; ++k) {
    const Point here = tip + k * law.spacing * direction;
    if (!across(here, here + law.spacing * direction, law.horizon).empty()) continue;
    return k > 0 && is_free(here, around) ? std::optional(k * law.spacing) : std::nullopt;
  }
  return std::nullopt;
}

std::vector<int> LinePath::across(const Point& from, const Point& to, double horizon, PointsOnPath side) const {
  const std::vector<Point>& positions = positions_;
  const coupling::Terms& terms = system_.terms();
  const double reach = horizon + (to - from).norm();
  std::vector<int> found;
  const auto is_on_left = [&](const Point& point) {
    return side == PointsOnPath::right ? is_left(from, to, point) : !is_left(to, from, point);
  };
  for (const int node : stress_.near().about(from, reach)) {
    const Point& p = positions[static_cast<std::size_t>(node)];
    if ((p - from).norm() > reach) continue;
    for (const int bond : terms_from_.of(node)) {
      const auto b = static_cast<std::size_t>(bond);
      if (terms.is_wide(b) || !system_.stages().intact()[b]) continue;
      const Point& q = positions[static_cast<std::size_t>(terms.second[b])];
      if (is_on_left(p) != is_on_left(q) && is_left(p, q, from) != is_left(p, q, to)) found.push_back(bond);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

int LinePath::clear_spacings(const Point& place, const Point& direction, const pd::TipLaw& law, int most) const {
  for (int k = 0; k < most; ++k) {
    const Point here = place + k * law.spacing * direction;
    if (across(here, here + law.spacing * direction, law.horizon).empty() || face_ahead(here, direction, law)) return k;
  }
  return most;
}

bool LinePath::leaves_body(const Point& place, const Point& direction, const pd::TipLaw& law) const {
  const Point end = place + most_empty_steps * law.spacing * direction;
  return across(place, end, law.horizon).empty() && is_free(place, around_edge * law.spacing);
}

LinePath::Step LinePath::next(const Point& place, const Point& direction, const pd::TipLaw& law) const {
  using crack::TipState;
  const auto step_of = [&](double length, TipState ends_as) {
    return Step{length, across(place, place + length * direction, law.horizon), ends_as};
  };
  // The step reaches half a spacing beyond the face, because the bonds to the first row of points behind the face have
  // to be cut too.
  if (const std::optional<double> face = face_ahead(place, direction, law))
    return step_of(*face + law.spacing / 2, TipState::at_crack);
  if (const std::optional<double> edge = edge_ahead(place, direction, law)) return step_of(*edge, TipState::at_edge);
  Step step;
  for (int k = 1; k <= most_empty_steps && step.bonds.empty(); ++k) step = step_of(k * law.spacing, TipState::grows);
  return step;
}

}  // namespace bempd::fracture
