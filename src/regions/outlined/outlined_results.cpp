#include <algorithm>
#include <limits>

#include "pd/outlined/chord_search.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

namespace {

// Weights of a cell's corners (its shape functions) at a place, which may lie slightly outside the cell.
std::array<double, 4> weights_in(const std::vector<Point>& points, const std::array<int, 4>& cell, const Point& place) {
  const Point &a = points[cell[0]], &b = points[cell[1]], &d = points[cell[3]];
  const double area = cross(b - a, d - a);
  const double x = cross(place - a, d - a) / area, y = cross(b - a, place - a) / area;
  if (pd::is_triangle(cell)) return {1 - x - y, x, y, 0};
  return {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
}

// Estimate of the distance of a place from a cell, in grid units; not positive inside the cell.
double distance_outside(const std::vector<Point>& points, const std::array<int, 4>& cell, const Point& place) {
  double most = -std::numeric_limits<double>::infinity();
  const int count = pd::is_triangle(cell) ? 3 : 4;
  for (int k = 0; k < count; ++k) {
    const Point &a = points[cell[k]], along = points[cell[(k + 1) % count]] - a;
    most = std::max(most, cross(place - a, along) / along.norm());
  }
  return most;
}

}  // namespace

Cells OutlinedRegion::cells() const {
  Cells cells{4, {}};
  for (const auto& cell : body_.cells) cells.nodes.insert(cells.nodes.end(), cell.begin(), cell.end());
  return cells;
}

// Evaluates fields at places by interpolation: bilinear in lattice cells, linear in the triangles around them. Between
// a round edge and its chord the triangle at the chord is extrapolated.
class OutlinedRegion::CellEvaluator final : public Evaluator {
 public:
  CellEvaluator(const OutlinedRegion& region, const FieldsOfRegion& fields, bool with_stress)
      : region_(region),
        displacement_(fields(Field::displacement)),
        stress_(with_stress ? &fields(Field::stress) : nullptr) {
    Box all;
    for (const Point& p : region.points_) all.extend(p);
    near_ = pd::Buckets(all, 2);
    for (std::size_t c = 0; c < region.body_.cells.size(); ++c) {
      Box box;
      for (const int corner : region.body_.cells[c]) box.extend(region.points_[corner]);
      near_.add(box, static_cast<int>(c));
    }
  }

  PointValue at(const Point& place) override {
    const Point p = region_.to_grid(place);
    const std::array<int, 4>& cell = region_.body_.cells[nearest(p)];
    const std::array<double, 4> weights = weights_in(region_.points_, cell, p);
    PointValue value;
    value.region = region_.id();
    for (int k = 0; k < 4; ++k) {
      value.displacement += weights[k] * Eigen::Map<const Point>(&displacement_.values[2 * cell[k]]);
      if (stress_) value.stress += weights[k] * Eigen::Map<const Eigen::Vector3d>(&stress_->values[3 * cell[k]]);
    }
    return value;
  }

 private:
  std::size_t nearest(const Point& p) const {
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (double reach = 1e-6; !(least < reach); reach *= 100) {
      const Point margin = Point::Constant(reach);
      near_.any_near(Box(p - margin, p + margin), [&](int c) {
        const double off = distance_outside(region_.points_, region_.body_.cells[static_cast<std::size_t>(c)], p);
        if (off < least) least = off, best = c;
        return off <= 0;
      });
    }
    return static_cast<std::size_t>(best);
  }

  const OutlinedRegion& region_;
  const FieldValues& displacement_;
  const FieldValues* stress_;
  pd::Buckets near_;
};

std::unique_ptr<Evaluator> OutlinedRegion::evaluator(const Solution&, const FieldsOfRegion& fields,
                                                     bool with_stress) const {
  return std::make_unique<CellEvaluator>(*this, fields, with_stress);
}

}  // namespace bempd::regions
