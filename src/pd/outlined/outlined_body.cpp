#include "pd/outlined/outlined_body.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "pd/layer_balance.hpp"
#include "pd/outlined/outlined_bonds.hpp"
#include "pd/outlined/surface_balance.hpp"

namespace bempd::pd {

namespace {

constexpr double smallest_outlined_ratio = 0.02;  // bound on a stiffness over that of the kernel

struct Attempt {
  double gap;                         // between the outline and the points inside
  double free_depth;                  // of the layer whose stiffnesses may change
  double shift;                       // of the lattice along both of its axes
  bool is_balanced_by_piece = false;  // whether surface vectors are balanced piece by piece
};

// Attempts to build a network, in the order in which they are made. At a horizon ratio of 3 the best networks have
// small gaps between outline and lattice, and stiffnesses must be allowed to change in a layer as deep as the horizon.
// At larger ratios a layer of 3/4 of that depth comes first, because its errors in thin bodies are smaller.
std::vector<Attempt> attempts_for(int horizon_ratio, bool may_move, bool is_balanced_by_piece) {
  const bool is_short = horizon_ratio == 3;
  const double whole = horizon_ratio, less = is_short ? whole : 0.75 * horizon_ratio;
  const std::vector<double> gaps =
      is_short ? std::vector{0.65, 0.75, 0.55, 0.85, 0.95} : std::vector{0.85, 0.75, 0.95, 0.65};
  std::vector<Attempt> attempts;
  if (!is_short) attempts.push_back({gaps.front(), less, 0, is_balanced_by_piece});
  for (const double shift : {0.0, 0.5}) {
    if (shift > 0 && !may_move) break;
    for (const double gap : gaps) attempts.push_back({gap, whole, shift, is_balanced_by_piece});
  }
  return attempts;
}

// Length, in spacings, of the longest bond in a lattice with this horizon.
double longest_bond(int horizon_ratio) {
  int longest = 0;
  for (int x = 0; x < horizon_ratio; ++x)
    for (int y = 0; y < horizon_ratio; ++y)
      if (x * x + y * y < horizon_ratio * horizon_ratio) longest = std::max(longest, x * x + y * y);
  return std::sqrt(longest);
}

// Depth of the layer of points that lack bonds. At a horizon ratio of 3 a deeper layer gives a more exact stress at an
// edge.
double layer_depth(const Attempt& attempt, int horizon_ratio) {
  return longest_bond(horizon_ratio) + attempt.gap + (horizon_ratio == 3 ? 0.75 : 0);
}

// Layers of bonds whose stiffnesses may change, tried one after the other. Short bonds suffice almost everywhere; their
// equations are few, and join points close to each other. The second layer also has longer bonds.
std::vector<Layer> layers_for(const Attempt& attempt, int horizon_ratio) {
  const double reach = horizon_ratio == 3 ? HUGE_VAL : 0.8 * horizon_ratio;
  return {{attempt.free_depth, layer_depth(attempt, horizon_ratio), reach}, {attempt.free_depth, HUGE_VAL, HUGE_VAL}};
}

OutlinedBody try_out(const Attempt& attempt, const Chords& chords, LatticePlace place, int horizon_ratio,
                     const PlaneElasticity& elasticity, int threads, const BondKernel& kernel) {
  place.origin += Eigen::Rotation2Dd(place.angle) * Point::Constant(attempt.shift);
  const OutlinedPoints points(chords, place, attempt.gap, 1 + layer_depth(attempt, horizon_ratio));
  OutlinedBody body{chords,
                    points.points(),
                    fill_with_cells(chords, points),
                    {},
                    balancing_factors(chords, attempt.is_balanced_by_piece),
                    {},
                    {}};
  body.place = place;
  body.is_balanced_by_piece = attempt.is_balanced_by_piece;
  body.areas = areas_of_points(body.points, body.cells);
  std::vector<Point> surface(body.points.size(), Point::Zero());
  for (int i = 0; i < chords.count(); ++i) surface[i] = body.factors[i] * chords.surface_vector(i);
  DraftBonds bonds = draft_outlined_bonds(chords, points, horizon_ratio, kernel);
  const std::vector<Point> places = attempt.is_balanced_by_piece ? body.points : std::vector<Point>();
  for (const Layer& layer : layers_for(attempt, horizon_ratio)) {
    mark_layer(points, layer, bonds);
    share_by_area(body.areas, bonds);
    if (balance_layer(surface, smallest_outlined_ratio, threads, bonds, places)) break;
  }
  body.network = finish_network(surface, std::move(bonds), elasticity);
  return body;
}

}  // namespace

OutlinedBody build_outlined_body(const Chords& chords, const LatticePlace& place, int horizon_ratio,
                                 const PlaneElasticity& elasticity, int threads, const BondKernel& kernel) {
  assert(horizon_ratio >= 3 && horizon_ratio <= 8);
  std::optional<OutlinedBody> best;
  // Attempts that are balanced piece by piece (balancing_factors()) come second. Only long outlines with chords of
  // different lengths need them.
  for (const bool is_balanced_by_piece : {false, true}) {
    if (is_balanced_by_piece && balancing_factors(chords, true) == balancing_factors(chords)) break;
    for (const Attempt& attempt : attempts_for(horizon_ratio, !place.fixed, is_balanced_by_piece)) {
      OutlinedBody body = try_out(attempt, chords, place, horizon_ratio, elasticity, threads, kernel);
      if (body.is_exact()) return body;
      if (!best || body.network.max_residual < best->network.max_residual) best = std::move(body);
    }
  }
  return std::move(*best);
}

std::optional<ImpossibleCorner> find_impossible_corner(const Chords& chords) {
  constexpr double reach = std::numbers::pi / 6, slack = 1e-9;
  for (int i = 0; i < chords.count(); ++i) {
    const double alpha = chords.angle(i);
    if (alpha > std::numbers::pi) continue;
    const int before = chords.chord_before(i);
    const Point inward = -chords.surface_vector(i), along = chords.along(i);
    const double direction = std::atan2(cross(along, inward), along.dot(inward));
    if (direction < reach - slack || direction > alpha - reach + slack)
      return ImpossibleCorner{i, alpha, chords.length(before), chords.length(i)};
  }
  return std::nullopt;
}

}  // namespace bempd::pd
