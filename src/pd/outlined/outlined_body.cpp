#include "pd/outlined/outlined_body.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "linalg/disjoint_sets.hpp"
#include "linalg/least_change.hpp"
#include "parallel.hpp"
#include "pd/cell_squares.hpp"
#include "pd/outlined/outlined_bonds.hpp"
#include "pd/outlined/surface_balance.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector4d;

constexpr double smallest_outlined_ratio = 0.02;  // bound on a stiffness over that of the kernel

struct Attempt {
  double gap, free_depth, shift;  // of the lattice along both of its axes
};

// In the order in which they are tried. Short families have their best networks at smaller gaps and need all of the
// layer; with longer ones less of it gives smaller errors in thin bodies.
std::vector<Attempt> attempts_for(int horizon_ratio, bool may_move) {
  const bool is_short = horizon_ratio == 3;
  const double whole = horizon_ratio, less = is_short ? whole : 0.75 * horizon_ratio;
  const std::vector<double> gaps =
      is_short ? std::vector{0.65, 0.75, 0.55, 0.85, 0.95} : std::vector{0.85, 0.75, 0.95, 0.65};
  std::vector<Attempt> attempts;
  if (!is_short) attempts.push_back({gaps.front(), less, 0});
  for (const double shift : {0.0, 0.5}) {
    if (shift > 0 && !may_move) break;
    for (const double gap : gaps) attempts.push_back({gap, whole, shift});
  }
  return attempts;
}

// Free bonds by sets that share no point.
std::vector<std::vector<int>> free_clusters(const OutlinedBonds& bonds, int point_count) {
  linalg::DisjointSets sets(point_count);
  for (const OutlinedBond& b : bonds.bonds)
    if (b.free) sets.join(b.first, b.second);
  std::vector<int> number(static_cast<std::size_t>(point_count), -1);
  std::vector<std::vector<int>> clusters;
  for (std::size_t b = 0; b < bonds.bonds.size(); ++b) {
    if (!bonds.bonds[b].free) continue;
    int& n = number[static_cast<std::size_t>(sets.find(bonds.bonds[b].first))];
    if (n < 0) {
      n = static_cast<int>(clusters.size());
      clusters.emplace_back();
    }
    clusters[static_cast<std::size_t>(n)].push_back(static_cast<int>(b));
  }
  return clusters;
}

linalg::LeastChange outlined_problem(const OutlinedBonds& all, const std::vector<Vector4d>& missing,
                                     const std::vector<int>& cluster) {
  std::vector<int> points;
  for (const int b : cluster) points.insert(points.end(), {all.bonds[b].first, all.bonds[b].second});
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto row = [&](int point) {
    return 4 * static_cast<int>(std::lower_bound(points.begin(), points.end(), point) - points.begin());
  };
  const int count = static_cast<int>(cluster.size());
  linalg::LeastChange problem;
  problem.lower = smallest_outlined_ratio;
  problem.start.resize(count);
  problem.scale.resize(count);
  problem.target.resize(4 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t p = 0; p < points.size(); ++p)
    problem.target.segment<4>(4 * static_cast<Eigen::Index>(p)) = missing[points[p]];
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(8 * cluster.size());
  for (int k = 0; k < count; ++k) {
    const OutlinedBond& b = all.bonds[cluster[k]];
    const BondOffset& offset = all.offsets[b.offset];
    const int first = row(b.first), second = row(b.second);
    problem.start[k] = b.stiffness;
    problem.scale[k] = offset.bulk_stiffness;
    for (int c = 0; c < 4; ++c) {
      entries.emplace_back(first + c, k, offset.moment[c]);
      entries.emplace_back(second + c, k, -offset.moment[c]);
      problem.target[first + c] += offset.moment[c] * b.stiffness;
      problem.target[second + c] -= offset.moment[c] * b.stiffness;
    }
  }
  problem.constraints.resize(problem.target.size(), count);
  problem.constraints.setFromTriplets(entries.begin(), entries.end());
  return problem;
}

void balance_outlined(const std::vector<Point>& surface, int threads, OutlinedBonds& bonds) {
  const std::vector<Vector4d> missing = missing_moments(surface, bonds);
  const std::vector<std::vector<int>> clusters = free_clusters(bonds, static_cast<int>(surface.size()));
  std::vector<linalg::LeastChangeResult> results(clusters.size());
  parallel_for(clusters.size(), threads, [&](std::size_t c) {
    results[c] = solve_long_least_change(outlined_problem(bonds, missing, clusters[c]));
  });
  for (std::size_t c = 0; c < clusters.size(); ++c)
    for (std::size_t k = 0; k < clusters[c].size(); ++k)
      bonds.bonds[clusters[c][k]].stiffness = results[c].values[static_cast<Eigen::Index>(k)];
}

Network finish_outlined(const std::vector<Point>& surface, OutlinedBonds bonds, const PlaneElasticity& elasticity) {
  Network network;
  for (const Vector4d& r : missing_moments(surface, bonds))
    network.max_residual = std::max(network.max_residual, r.lpNorm<Eigen::Infinity>());
  const double unit = elasticity.thickness * bond_c1111(elasticity);
  network.min_weight_ratio = HUGE_VAL;
  for (const OutlinedBond& b : bonds.bonds) {
    network.bonds.push_back({b.first, b.second, unit * b.stiffness});
    network.offset_of.push_back(static_cast<std::uint32_t>(b.offset));
    network.min_weight_ratio = std::min(network.min_weight_ratio, b.stiffness / bonds.offsets[b.offset].bulk_stiffness);
  }
  network.offsets = std::move(bonds.offsets);
  return network;
}

OutlinedBody try_out(const Attempt& attempt, const Chords& chords, LatticePlace place, int horizon_ratio,
                     const PlaneElasticity& elasticity, int threads, const BondKernel& kernel) {
  place.origin += Eigen::Rotation2Dd(place.angle) * Point::Constant(attempt.shift);
  const OutlinedPoints points(chords, place, attempt.gap, horizon_ratio);
  OutlinedBody body{chords, points.points(), fill_with_cells(chords, points), {}, balancing_factors(chords), {}, {}};
  body.place = place;
  body.areas = areas_of_points(body.points, body.cells);
  std::vector<Point> surface(body.points.size(), Point::Zero());
  for (int i = 0; i < chords.count(); ++i) surface[i] = body.factors[i] * chords.surface_vector(i);
  OutlinedBonds bonds = draft_outlined_bonds(chords, points, horizon_ratio, attempt.free_depth, kernel);
  share_by_area(body.areas, bonds);
  balance_outlined(surface, threads, bonds);
  body.network = finish_outlined(surface, std::move(bonds), elasticity);
  return body;
}

}  // namespace

OutlinedBody build_outlined_body(const Chords& chords, const LatticePlace& place, int horizon_ratio,
                                 const PlaneElasticity& elasticity, int threads, const BondKernel& kernel) {
  assert(horizon_ratio >= 3 && horizon_ratio <= 8);
  std::optional<OutlinedBody> best;
  for (const Attempt& attempt : attempts_for(horizon_ratio, !place.fixed)) {
    OutlinedBody body = try_out(attempt, chords, place, horizon_ratio, elasticity, threads, kernel);
    if (body.is_exact()) return body;
    if (!best || body.network.max_residual < best->network.max_residual) best = std::move(body);
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
