#include "pd/outlined/outlined_bonds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cancellation.hpp"
#include "linalg/disjoint_sets.hpp"
#include "linalg/profile_cholesky.hpp"

namespace bempd::pd {

namespace {

using Eigen::Vector2i;

BondOffset offset_along(const Point& step, double bulk_stiffness) {
  BondOffset offset;
  offset.step = step;
  offset.length = step.norm();
  offset.direction = step / offset.length;
  const double x = offset.direction.x(), y = offset.direction.y();
  offset.moment = offset.length * Eigen::Vector4d(x * x * x, x * x * y, x * y * y, y * y * y);
  offset.bulk_stiffness = bulk_stiffness;
  return offset;
}

class Drafting {
 public:
  Drafting(const Chords& chords, const OutlinedPoints& points, int horizon_ratio, const BondKernel& kernel)
      : points_(points), search_(chords), horizon_(horizon_ratio), kernel_(kernel) {
    for (const BondOffset& offset : bond_family(horizon_ratio, kernel)) {
      steps_.emplace_back(offset.step.cast<int>());
      made_.offsets.push_back(offset_along(points.turn() * offset.step, offset.bulk_stiffness));
    }
    Box box;
    for (int i = 0; i < points.outline_count(); ++i) box.extend(points.points()[i]);
    near_ = Buckets(box, horizon_);
    for (int i = 0; i < points.outline_count(); ++i) near_.add(Box(points.points()[i]), i);
  }

  OutlinedBonds draft() {
    made_.bonds.reserve(steps_.size() * static_cast<std::size_t>(points_.count()));
    for (int i = 0; i < points_.count(); ++i) {
      check_cancelled();
      if (points_.on_lattice(i)) {
        bond_on_lattice(i);
      } else {
        bond_on_outline(i);
      }
    }
    return std::move(made_);
  }

 private:
  void bond_on_lattice(int i) {
    std::optional<ChordSearch::View> view;
    for (std::size_t o = 0; o < steps_.size(); ++o) {
      const int j = points_.find_point(points_.lattice_point(i) + steps_[o]);
      if (j < 0) continue;
      if (points_.depth(i) + points_.depth(j) < made_.offsets[o].length) {
        if (!view) view.emplace(search_, points_.points()[i], horizon_);
        if (!view->sees(points_.points()[j])) continue;
      }
      made_.bonds.push_back({i, j, static_cast<int>(o), made_.offsets[o].bulk_stiffness, false, false});
    }
  }

  void bond_on_outline(int i) {
    const Point& p = points_.points()[i];
    std::vector<int> others;
    near_.any_near(Box(p - Point::Constant(horizon_), p + Point::Constant(horizon_)), [&](int j) {
      if (j > i) others.push_back(j);
      return false;
    });
    const Point at = points_.place_on_lattice(p);
    const Vector2i low = (at.array() - horizon_).ceil().cast<int>().matrix();
    const Vector2i high = (at.array() + horizon_).floor().cast<int>().matrix();
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        if (const int j = points_.find_point({x, y}); j >= 0) others.push_back(j);
    std::sort(others.begin(), others.end());
    const ChordSearch::View view(search_, p, horizon_);
    for (const int j : others) {
      const Point step = points_.points()[j] - p;
      // A bond as long as the horizon, up to rounding, has no stiffness.
      if (step.norm() > horizon_ - 1e-6 || !view.sees(points_.points()[j])) continue;
      const double stiffness = kernel_stiffness(kernel_, step.norm(), horizon_);
      made_.bonds.push_back({i, j, static_cast<int>(made_.offsets.size()), stiffness, false, false});
      made_.offsets.push_back(offset_along(step, stiffness));
    }
  }

  const OutlinedPoints& points_;
  ChordSearch search_;
  double horizon_;
  const BondKernel& kernel_;
  std::vector<Vector2i> steps_;
  Buckets near_;
  OutlinedBonds made_;
};

}  // namespace

OutlinedBonds draft_outlined_bonds(const Chords& chords, const OutlinedPoints& points, int horizon_ratio,
                                   const BondKernel& kernel) {
  return Drafting(chords, points, horizon_ratio, kernel).draft();
}

void mark_layer(const OutlinedPoints& points, const Layer& layer, OutlinedBonds& bonds) {
  for (OutlinedBond& b : bonds.bonds) {
    const BondOffset& offset = bonds.offsets[b.offset];
    const auto [less, more] = std::minmax({points.depth(b.first), points.depth(b.second)});
    b.stiffness = offset.bulk_stiffness;
    b.in_layer = less < layer.depth && more < layer.deepest;
    b.free = b.in_layer && offset.length < layer.reach;
  }
}

void share_by_area(const std::vector<double>& areas, OutlinedBonds& bonds) {
  constexpr double volume_stiffness = 8.0 / 3;
  constexpr int rounds = 10;
  struct Shared {
    int first, second;  // among the points of such bonds
    double half;        // of k L^2
  };
  std::vector<int> number(areas.size(), -1);
  std::vector<double> wanted, of_others, factor;
  for (const OutlinedBond& b : bonds.bonds) {
    if (!b.in_layer) continue;
    for (const int point : {b.first, b.second}) {
      if (number[point] >= 0) continue;
      number[point] = static_cast<int>(wanted.size());
      wanted.push_back(volume_stiffness * areas[point]);
    }
  }
  of_others.assign(wanted.size(), 0.0), factor.assign(wanted.size(), 1.0);
  std::vector<Shared> shared;
  for (const OutlinedBond& b : bonds.bonds) {
    const int first = number[b.first], second = number[b.second];
    if (first < 0 && second < 0) continue;
    const double length = bonds.offsets[b.offset].length, half = 0.5 * b.stiffness * length * length;
    if (b.in_layer) {
      shared.push_back({first, second, half});
    } else {
      if (first >= 0) of_others[first] += half;
      if (second >= 0) of_others[second] += half;
    }
  }
  std::vector<double> resisted;
  for (int round = 0; round < rounds; ++round) {
    resisted = of_others;
    for (const Shared& b : shared) {
      const double half = factor[b.first] * factor[b.second] * b.half;
      resisted[b.first] += half, resisted[b.second] += half;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (resisted[i] > 0) factor[i] *= std::sqrt(wanted[i] / resisted[i]);
  }
  for (OutlinedBond& b : bonds.bonds)
    if (b.in_layer) b.stiffness *= factor[number[b.first]] * factor[number[b.second]];
}

std::vector<Eigen::Vector4d> missing_moments(const std::vector<Point>& surface, const OutlinedBonds& bonds) {
  std::vector<Eigen::Vector4d> missing(surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const Point& n = surface[i];
    missing[i] = -Eigen::Vector4d(n.x(), n.y() / 3, n.x() / 3, n.y());
  }
  for (const OutlinedBond& b : bonds.bonds) {
    const Eigen::Vector4d moment = b.stiffness * bonds.offsets[b.offset].moment;
    missing[b.first] -= moment;
    missing[b.second] += moment;
  }
  return missing;
}

Eigen::Vector4d even_moment(const BondOffset& offset) {
  const double c = offset.direction.x(), s = offset.direction.y(), square = offset.length * offset.length;
  const double cos2 = c * c - s * s, sin2 = 2 * c * s;
  return square * Eigen::Vector4d(cos2, sin2, cos2 * cos2 - sin2 * sin2, 2 * cos2 * sin2);
}

std::vector<Eigen::Vector4d> missing_even_moments(std::size_t point_count, const OutlinedBonds& bonds) {
  std::vector<Eigen::Vector4d> missing(point_count, Eigen::Vector4d::Zero());
  for (const OutlinedBond& b : bonds.bonds) {
    const Eigen::Vector4d moment = b.stiffness * even_moment(bonds.offsets[b.offset]);
    missing[b.first] -= moment;
    missing[b.second] -= moment;
  }
  return missing;
}

LayerParts parts_of_layer(const OutlinedBonds& bonds, std::size_t point_count) {
  linalg::DisjointSets sets(static_cast<int>(point_count));
  for (const OutlinedBond& b : bonds.bonds)
    if (b.free) sets.join(b.first, b.second);
  LayerParts found;
  found.number.assign(point_count, -1);
  std::vector<int> part_of(point_count, -1);
  for (std::size_t b = 0; b < bonds.bonds.size(); ++b) {
    const OutlinedBond& bond = bonds.bonds[b];
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

std::vector<int> order_of(const OutlinedBonds& bonds, const LayerParts::Part& part, const std::vector<int>& number) {
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

}  // namespace bempd::pd
