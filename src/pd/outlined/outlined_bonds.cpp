#include "pd/outlined/outlined_bonds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cancellation.hpp"

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

  DraftBonds draft() {
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
      made_.bonds.push_back({i, j, static_cast<int>(o), false, false, made_.offsets[o].bulk_stiffness});
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
      made_.bonds.push_back({i, j, static_cast<int>(made_.offsets.size()), false, false, stiffness});
      made_.offsets.push_back(offset_along(step, stiffness));
    }
  }

  const OutlinedPoints& points_;
  ChordSearch search_;
  double horizon_;
  const BondKernel& kernel_;
  std::vector<Vector2i> steps_;
  Buckets near_;
  DraftBonds made_;
};

}  // namespace

DraftBonds draft_outlined_bonds(const Chords& chords, const OutlinedPoints& points, int horizon_ratio,
                                const BondKernel& kernel) {
  return Drafting(chords, points, horizon_ratio, kernel).draft();
}

void mark_layer(const OutlinedPoints& points, const Layer& layer, DraftBonds& bonds) {
  for (DraftBond& b : bonds.bonds) {
    const BondOffset& offset = bonds.offsets[b.offset];
    const auto [less, more] = std::minmax({points.depth(b.first), points.depth(b.second)});
    b.stiffness = offset.bulk_stiffness;
    b.in_layer = less < layer.depth && more < layer.deepest;
    b.free = b.in_layer && offset.length < layer.reach;
  }
}

void share_by_area(const std::vector<double>& areas, DraftBonds& bonds) {
  constexpr double volume_stiffness = 8.0 / 3;
  constexpr int rounds = 10;
  struct LayerBond {
    int first, second;  // numbers of the ends among the points of the layer's bonds
    double half;        // half of k L^2
  };
  std::vector<int> number(areas.size(), -1);
  std::vector<double> wanted, of_others, factor;
  for (const DraftBond& b : bonds.bonds) {
    if (!b.in_layer) continue;
    for (const int point : {b.first, b.second}) {
      if (number[point] >= 0) continue;
      number[point] = static_cast<int>(wanted.size());
      wanted.push_back(volume_stiffness * areas[point]);
    }
  }
  of_others.assign(wanted.size(), 0.0), factor.assign(wanted.size(), 1.0);
  std::vector<LayerBond> shared;
  for (const DraftBond& b : bonds.bonds) {
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
    for (const LayerBond& b : shared) {
      const double half = factor[b.first] * factor[b.second] * b.half;
      resisted[b.first] += half, resisted[b.second] += half;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (resisted[i] > 0) factor[i] *= std::sqrt(wanted[i] / resisted[i]);
  }
  for (DraftBond& b : bonds.bonds)
    if (b.in_layer) b.stiffness *= factor[number[b.first]] * factor[number[b.second]];
}

}  // namespace bempd::pd
