#include "pd/outlined/outlined_bonds.hpp"

#include <algorithm>
#include <cmath>

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
  Drafting(const Chords& chords, const OutlinedPoints& points, int horizon_ratio, double free_depth,
           const BondKernel& kernel)
      : points_(points), search_(chords), horizon_(horizon_ratio), free_depth_(free_depth), kernel_(kernel) {
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
    for (std::size_t o = 0; o < steps_.size(); ++o) {
      const int j = points_.find_point(points_.lattice_point(i) + steps_[o]);
      if (j < 0) continue;
      const double clear = std::max(points_.depth(i), points_.depth(j));
      if (clear < made_.offsets[o].length && !search_.in_sight(points_.points()[i], points_.points()[j])) continue;
      const bool free = points_.depth(i) < free_depth_ || points_.depth(j) < free_depth_;
      made_.bonds.push_back({i, j, static_cast<int>(o), made_.offsets[o].bulk_stiffness, free});
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
    for (const int j : others) {
      const Point step = points_.points()[j] - p;
      // What is as long as the horizon up to rounding carries nothing.
      if (step.norm() > horizon_ - 1e-6 || !search_.in_sight(p, points_.points()[j])) continue;
      const double stiffness = kernel_stiffness(kernel_, step.norm(), horizon_);
      made_.bonds.push_back({i, j, static_cast<int>(made_.offsets.size()), stiffness, true});
      made_.offsets.push_back(offset_along(step, stiffness));
    }
  }

  const OutlinedPoints& points_;
  ChordSearch search_;
  double horizon_, free_depth_;
  const BondKernel& kernel_;
  std::vector<Vector2i> steps_;
  Buckets near_;
  OutlinedBonds made_;
};

}  // namespace

OutlinedBonds draft_outlined_bonds(const Chords& chords, const OutlinedPoints& points, int horizon_ratio,
                                   double free_depth, const BondKernel& kernel) {
  return Drafting(chords, points, horizon_ratio, free_depth, kernel).draft();
}

void share_by_area(const std::vector<double>& areas, OutlinedBonds& bonds) {
  constexpr double volume_stiffness = 8.0 / 3;
  constexpr int rounds = 30;
  struct Free {
    int first, second;
    double half;  // of k L^2
  };
  std::vector<Free> free;
  std::vector<double> of_others(areas.size(), 0.0), factor(areas.size(), 1.0);
  std::vector<char> near(areas.size(), 0);
  for (const OutlinedBond& b : bonds.bonds) {
    const double length = bonds.offsets[b.offset].length, half = 0.5 * b.stiffness * length * length;
    if (b.free) {
      free.push_back({b.first, b.second, half});
      near[b.first] = near[b.second] = 1;
    } else {
      of_others[b.first] += half, of_others[b.second] += half;
    }
  }
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> resisted = of_others;
    for (const Free& b : free) {
      const double half = factor[b.first] * factor[b.second] * b.half;
      resisted[b.first] += half, resisted[b.second] += half;
    }
    for (std::size_t i = 0; i < areas.size(); ++i)
      if (near[i] && resisted[i] > 0) factor[i] *= std::sqrt(volume_stiffness * areas[i] / resisted[i]);
  }
  for (OutlinedBond& b : bonds.bonds)
    if (b.free) b.stiffness *= factor[b.first] * factor[b.second];
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

}  // namespace bempd::pd
