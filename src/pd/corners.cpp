#include "pd/corners.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/disjoint_sets.hpp"
#include "linalg/least_change.hpp"
#include "parallel.hpp"
#include "pd/congruent_clusters.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector2i;
using Eigen::Vector4d;

constexpr double least_corner_ratio = 0.02;  // bound on a stiffness over its bulk value
constexpr double rounding = 1e-13;

// Marks the points closer to `center` than `radius`.
void mark_around(const CellLattice& lattice, const Vector2i& center, int radius, std::vector<std::uint8_t>& mark) {
  for (int dy = -radius + 1; dy < radius; ++dy) {
    for (int dx = -radius + 1; dx < radius; ++dx) {
      if (dx * dx + dy * dy >= radius * radius) continue;
      const int i = lattice.find_point(center + Vector2i(dx, dy));
      if (i >= 0) mark[i] = 1;
    }
  }
}

bool is_corner(const CellGrid& cells, const Vector2i& p) {
  const auto [ll, lr, ul, ur] = cells.around(p);
  const int count = ll + lr + ul + ur;
  return count == 1 || count == 3 || (count == 2 && ll == ur);
}

// Points whose bonds may change: those around corners, and those around other points with missing third moments
// (missing_moments()).
std::vector<std::uint8_t> adjustable_points(const CellLattice& lattice, const CellGrid& cells, int m,
                                            const std::vector<Vector4d>& missing) {
  const int radius = 2 * m + 1;
  std::vector<std::uint8_t> near(lattice.point_count(), 0), core(lattice.point_count(), 0);
  for (int i = 0; i < lattice.point_count(); ++i) {
    if (!is_corner(cells, lattice.point(i))) continue;
    mark_around(lattice, lattice.point(i), radius, near);
    mark_around(lattice, lattice.point(i), radius - 2, core);
  }
  for (int i = 0; i < lattice.point_count(); ++i) {
    if (!core[i] && missing[i].lpNorm<Eigen::Infinity>() > rounding)
      mark_around(lattice, lattice.point(i), m + 1, near);
  }
  return near;
}

// Clusters of the bonds `free`: bonds of different clusters share no point, so that clusters can be solved separately.
std::vector<std::vector<int>> clusters_of(const DraftBonds& bonds, const std::vector<int>& free, int points) {
  linalg::DisjointSets sets(points);
  for (const int b : free) sets.join(bonds.first[b], bonds.second[b]);
  std::vector<int> number(points, -1);
  std::vector<std::vector<int>> clusters;
  for (const int b : free) {
    int& n = number[sets.find(bonds.first[b])];
    if (n < 0) {
      n = static_cast<int>(clusters.size());
      clusters.emplace_back();
    }
    clusters[n].push_back(b);
  }
  return clusters;
}

// Least-change problem of a cluster of bonds. Changes of stiffness are in units of the bulk value, so that the columns
// are of similar size.
linalg::LeastChange cluster_problem(const std::vector<BondOffset>& family, const std::vector<Vector4d>& missing,
                                    const DraftBonds& bonds, const std::vector<int>& cluster) {
  std::vector<int> points;
  for (const int b : cluster) points.insert(points.end(), {bonds.first[b], bonds.second[b]});
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto row = [&](int point) {
    return 4 * static_cast<int>(std::lower_bound(points.begin(), points.end(), point) - points.begin());
  };
  const int count = static_cast<int>(cluster.size());
  linalg::LeastChange problem;
  problem.lower = least_corner_ratio;
  problem.start.resize(count);
  problem.scale.resize(count);
  problem.target.resize(4 * points.size());
  for (std::size_t p = 0; p < points.size(); ++p) problem.target.segment<4>(4 * p) = missing[points[p]];
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(8 * cluster.size());
  for (int k = 0; k < count; ++k) {
    const int b = cluster[k], first = row(bonds.first[b]), second = row(bonds.second[b]);
    const BondOffset& offset = family[bonds.offset[b]];
    problem.start[k] = bonds.stiffness[b];
    problem.scale[k] = offset.bulk_stiffness;
    for (int c = 0; c < 4; ++c) {
      if (offset.moment[c] == 0) continue;
      entries.emplace_back(first + c, k, offset.moment[c]);
      entries.emplace_back(second + c, k, -offset.moment[c]);
      problem.target[first + c] += offset.moment[c] * bonds.stiffness[b];
      problem.target[second + c] -= offset.moment[c] * bonds.stiffness[b];
    }
  }
  problem.constraints.resize(problem.target.size(), count);
  problem.constraints.setFromTriplets(entries.begin(), entries.end());
  return problem;
}

// Whether the lattice is symmetric under `map`, which maps points to points.
template <class Map>
bool symmetric_under(const CellLattice& lattice, const CellGrid& cells, const Map& map) {
  for (int i = 0; i < lattice.point_count(); ++i) {
    const Vector2i& p = lattice.point(i);
    if (lattice.find_point(map(p)) < 0) return false;
    // The image of a cell has its lower left corner at the smaller coordinates of the images of two opposite corners.
    const Vector2i a = map(p), b = map(p + Vector2i(1, 1));
    if (cells.has(p) && !cells.has(a.cwiseMin(b))) return false;
  }
  return true;
}

// Replaces the stiffnesses of each bond and its mirror image by their mean. The moment equations still hold, and the
// stiffnesses become symmetric to the last bit.
template <class Map>
void average(const CellLattice& lattice, const std::vector<int>& free, const Map& map, DraftBonds& bonds) {
  const std::vector<double> before = bonds.stiffness;
  for (const int b : free) {
    const int image = find_bond(bonds, lattice.find_point(map(lattice.point(bonds.first[b]))),
                                lattice.find_point(map(lattice.point(bonds.second[b]))));
    if (image >= 0) bonds.stiffness[b] = 0.5 * (before[b] + before[image]);
  }
}

// Makes stiffnesses symmetric where the lattice is: a symmetric body must break symmetrically, which rounding errors of
// the solver would prevent.
void symmetrise(const CellLattice& lattice, const CellGrid& cells, const std::vector<int>& free, DraftBonds& bonds) {
  const Vector2i sum = lattice.lower() + lattice.upper(), size = lattice.upper() - lattice.lower();
  const Vector2i low = lattice.lower();
  const auto attempt = [&](const auto& map) {
    if (!symmetric_under(lattice, cells, map)) return false;
    average(lattice, free, map, bonds);
    return true;
  };
  const bool x = attempt([&](const Vector2i& p) { return Vector2i(sum.x() - p.x(), p.y()); });
  const bool y = attempt([&](const Vector2i& p) { return Vector2i(p.x(), sum.y() - p.y()); });
  if (!x && !y) attempt([&](const Vector2i& p) { return Vector2i(sum - p); });
  if (size.x() != size.y()) return;
  attempt([&](const Vector2i& p) { return Vector2i(low + (p - low).reverse()); });
  if (x && y) return;
  attempt([&](const Vector2i& p) { return Vector2i(lattice.upper() - (p - low).reverse()); });
}

}  // namespace

std::vector<Vector4d> missing_moments(const CellLattice& lattice, const CellGrid& cells,
                                      const std::vector<BondOffset>& family, const DraftBonds& bonds) {
  std::vector<Vector4d> missing(lattice.point_count());
  for (int i = 0; i < lattice.point_count(); ++i) {
    const Eigen::Vector2d n = cells.surface_vector(lattice.point(i));
    missing[i] = -Vector4d(n.x(), n.y() / 3, n.x() / 3, n.y());
  }
  for (std::size_t b = 0; b < bonds.first.size(); ++b) {
    const Vector4d moment = bonds.stiffness[b] * family[bonds.offset[b]].moment;
    missing[bonds.first[b]] -= moment;
    missing[bonds.second[b]] += moment;
  }
  return missing;
}

CornerReport close_corners(const CellLattice& lattice, const CellGrid& cells, const LatticeTemplates& templates,
                           DraftBonds& bonds, int threads) {
  std::vector<Vector4d> missing = missing_moments(lattice, cells, templates.family, bonds);
  const std::vector<std::uint8_t> near = adjustable_points(lattice, cells, templates.horizon_ratio, missing);
  std::vector<int> free;
  for (std::size_t b = 0; b < bonds.first.size(); ++b) {
    if (bonds.adjustable[b] && (near[bonds.first[b]] || near[bonds.second[b]])) free.push_back(static_cast<int>(b));
  }
  const std::vector<std::vector<int>> clusters = clusters_of(bonds, free, lattice.point_count());
  const CongruentClusters congruent = find_congruent(lattice, missing, bonds, clusters);
  std::vector<linalg::LeastChangeResult> results(clusters.size());
  parallel_for(congruent.originals.size(), threads, [&](std::size_t k) {
    const int c = congruent.originals[k];
    results[c] = linalg::solve_least_change(cluster_problem(templates.family, missing, bonds, clusters[c]));
  });
  CornerReport report;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const CongruentClusters::Image& image = congruent.images[c];
    const linalg::LeastChangeResult& result = results[image.original];
    for (std::size_t k = 0; k < clusters[c].size(); ++k) {
      bonds.stiffness[clusters[c][k]] = result.values[image.bonds.empty() ? k : image.bonds[k]];
    }
  }
  symmetrise(lattice, cells, free, bonds);
  for (const int b : free) report.positive = report.positive && bonds.stiffness[b] > 0;
  for (const Vector4d& r : missing_moments(lattice, cells, templates.family, bonds)) {
    report.residual = std::max(report.residual, r.lpNorm<Eigen::Infinity>());
  }
  return report;
}

}  // namespace bempd::pd
