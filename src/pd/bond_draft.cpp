#include "pd/bond_draft.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/disjoint_sets.hpp"
#include "linalg/profile_cholesky.hpp"
#include "pd/cell_squares.hpp"

namespace bempd::pd {

namespace {

// Whether the balance problems of two parts of a layer are equal: bonds with equal numbers join points with equal
// numbers and have equal offsets, and their stiffnesses and the points' missing third moments are equal up to rounding.
bool are_alike(const LayerParts& all, const DraftBonds& bonds, const std::vector<Eigen::Vector4d>& missing,
               const LayerParts::Part& one, const LayerParts::Part& other) {
  constexpr double rounding = 1e-12;  // of numbers of order one
  if (one.bonds.size() != other.bonds.size() || one.points.size() != other.points.size()) return false;
  for (std::size_t k = 0; k < one.bonds.size(); ++k) {
    const DraftBond &a = bonds.bonds[one.bonds[k]], &b = bonds.bonds[other.bonds[k]];
    if (a.offset != b.offset || all.number[a.first] != all.number[b.first] ||
        all.number[a.second] != all.number[b.second] || std::abs(a.stiffness - b.stiffness) > rounding)
      return false;
  }
  for (std::size_t i = 0; i < one.points.size(); ++i)
    if ((missing[one.points[i]] - missing[other.points[i]]).lpNorm<Eigen::Infinity>() > rounding) return false;
  return true;
}

}  // namespace

std::vector<Eigen::Vector4d> missing_moments(const std::vector<Point>& surface, const DraftBonds& bonds) {
  std::vector<Eigen::Vector4d> missing(surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const Point& n = surface[i];
    missing[i] = -Eigen::Vector4d(n.x(), n.y() / 3, n.x() / 3, n.y());
  }
  for (const DraftBond& b : bonds.bonds) {
    const Eigen::Vector4d moment = b.stiffness * bonds.offsets[b.offset].moment;
    missing[b.first] -= moment;
    missing[b.second] += moment;
  }
  return missing;
}

LayerParts parts_of_layer(const DraftBonds& bonds, std::size_t point_count) {
  linalg::DisjointSets sets(static_cast<int>(point_count));
  for (const DraftBond& b : bonds.bonds)
    if (b.free) sets.join(b.first, b.second);
  LayerParts found;
  found.number.assign(point_count, -1);
  std::vector<int> part_of(point_count, -1);
  for (std::size_t b = 0; b < bonds.bonds.size(); ++b) {
    const DraftBond& bond = bonds.bonds[b];
    if (!bond.free) continue;
    int& part = part_of[sets.find(bond.first)];
    if (part < 0) {
      part = static_cast<int>(found.parts.size());
      found.parts.emplace_back();
    }
    LayerParts::Part& own = found.parts[part];
    own.bonds.push_back(static_cast<int>(b));
    for (const int point : {bond.first, bond.second}) {
      if (found.number[point] >= 0) continue;
      found.number[point] = static_cast<int>(own.points.size());
      own.points.push_back(point);
    }
  }
  return found;
}

std::vector<std::size_t> alike_parts(const LayerParts& all, const DraftBonds& bonds,
                                     const std::vector<Eigen::Vector4d>& missing) {
  std::vector<std::size_t> original(all.parts.size());
  for (std::size_t p = 0; p < all.parts.size(); ++p) {
    original[p] = p;
    for (std::size_t q = 0; q < p && original[p] == p; ++q)
      if (original[q] == q && are_alike(all, bonds, missing, all.parts[p], all.parts[q])) original[p] = q;
  }
  return original;
}

std::vector<int> order_of(const DraftBonds& bonds, const LayerParts::Part& part, const std::vector<int>& number) {
  const std::size_t count = part.points.size();
  std::vector<int> start(count + 1, 0);
  for (const int b : part.bonds) ++start[number[bonds.bonds[b].first] + 1], ++start[number[bonds.bonds[b].second] + 1];
  for (std::size_t i = 0; i < count; ++i) start[i + 1] += start[i];
  std::vector<int> at(start.begin(), start.end() - 1), neighbours(2 * part.bonds.size());
  for (const int b : part.bonds) {
    const int first = number[bonds.bonds[b].first], second = number[bonds.bonds[b].second];
    neighbours[at[first]++] = second;
    neighbours[at[second]++] = first;
  }
  return linalg::close_order(start, neighbours);
}

Network finish_network(const std::vector<Point>& surface, DraftBonds draft, const PlaneElasticity& elasticity) {
  Network network;
  for (const Eigen::Vector4d& r : missing_moments(surface, draft))
    network.max_residual = std::max(network.max_residual, r.lpNorm<Eigen::Infinity>());
  const double unit = elasticity.thickness * bond_c1111(elasticity);
  network.min_weight_ratio = draft.bonds.empty() ? 1 : HUGE_VAL;
  network.bonds.reserve(draft.bonds.size());
  network.offset_of.reserve(draft.bonds.size());
  for (const DraftBond& b : draft.bonds) {
    network.bonds.push_back({b.first, b.second, unit * b.stiffness});
    network.offset_of.push_back(static_cast<std::uint32_t>(b.offset));
    network.min_weight_ratio = std::min(network.min_weight_ratio, b.stiffness / draft.offsets[b.offset].bulk_stiffness);
  }
  network.offsets = std::move(draft.offsets);
  return network;
}

}  // namespace bempd::pd
