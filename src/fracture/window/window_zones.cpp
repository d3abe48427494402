#include "fracture/window/window_zones.hpp"

#include <algorithm>

#include "linalg/symmetric_modes.hpp"

namespace bempd::fracture {

namespace {

constexpr double rounding_of_rims = 1e-6;  // in lattice spacings

// Groups of points: each point is within `distance` of another point of its group, if the group has more than one.
std::vector<std::vector<int>> crowds(const std::vector<Point>& points, double distance) {
  std::vector<char> taken(points.size(), 0);
  std::vector<std::vector<int>> result;
  for (std::size_t seed = 0; seed < points.size(); ++seed) {
    if (taken[seed]) continue;
    std::vector<int>& members = result.emplace_back(1, static_cast<int>(seed));
    taken[seed] = 1;
    for (std::size_t k = 0; k < members.size(); ++k) {
      for (std::size_t j = 0; j < points.size(); ++j) {
        if (taken[j] || (points[members[k]] - points[j]).norm() > distance) continue;
        taken[j] = 1;
        members.push_back(static_cast<int>(j));
      }
    }
  }
  return result;
}

// Sets the size of a zone, whose centre and axis are given: it holds some points and reaches beyond them by the lengths
// of `shape`, with `back` behind them. `dx` is the lattice spacing.
void fit(Zone& zone, const std::vector<Point>& points, double back, const ZoneShape& shape, double dx) {
  Point low = Point::Zero(), high = Point::Zero();
  for (const Point& point : points) {
    const Point p = zone.coordinates(point);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  zone.low = {low.x() - back * dx, std::min(-shape.half_width * dx, low.y() - WindowSettings::beside_hot * dx)};
  zone.high = {high.x() + shape.ahead * dx,
               std::max(shape.half_width * dx, high.y() + WindowSettings::beside_hot * dx)};
  // The zone is enlarged by rounding, so that nodes exactly on its edge count as inside.
  zone.low.array() -= rounding_of_rims * dx, zone.high.array() += rounding_of_rims * dx;
  // The back of a zone gets a rim only if breaks are expected in both directions; behind a tip none is expected.
  zone.inner_low = zone.low + Point(back == shape.back ? 0 : WindowSettings::front_rim * dx, 0);
  zone.inner_high = zone.high - Point(WindowSettings::front_rim * dx, 0);
}

class Builder {
 public:
  Builder(const StretchRatios& ratios, double load_factor, const std::vector<char>& intact,
          const std::vector<Point>& positions, const std::vector<double>& spacing)
      : ratios_(ratios), load_factor_(load_factor), intact_(intact), positions_(positions), spacing_(spacing) {}

  Point middle(int b) const { return 0.5 * (positions_[bonds().first[b]] + positions_[bonds().second[b]]); }

  Zone zone(const std::vector<int>& crowd, const std::vector<Point>& parted, const ZoneShape& shape) const {
    double largest = 0;
    for (int b : crowd) largest = std::max(largest, ratios_.at(b, load_factor_));
    Zone zone;
    zone.centre.setZero();
    double weight = 0;
    for (int b : crowd) {
      const double ratio = ratios_.at(b, load_factor_);
      if (ratio < WindowSettings::centre_share * largest) continue;
      zone.centre += ratio * middle(b);
      weight += ratio;
    }
    zone.centre /= weight;
    const double dx = spacing_[bonds().first[crowd.front()]];
    // A crack runs perpendicular to the direction in which it opens, so the zone's axis is the direction of least
    // opening.
    const linalg::SymmetricModes openings = linalg::symmetric_modes(
        opening(zone.centre, WindowSettings::opening_reach * dx, WindowSettings::opening_share * largest));
    zone.axis = openings.vectors.col(0);
    Point crack = Point::Zero();
    for (const Point& p : parted) {
      if ((p - zone.centre).norm() < WindowSettings::crack_distance * dx) crack += p - zone.centre;
    }
    const bool all_around = openings.values[0] > WindowSettings::opening_all_around * openings.values[1];
    if (all_around && !bonds().followers.empty() && crack.norm() > 0) zone.axis = -crack.normalized();
    if (zone.axis.dot(crack) > 0) zone.axis = -zone.axis;
    const bool one_way = -zone.axis.dot(crack) > 0.5 * crack.norm() && crack.norm() > 0;
    std::vector<Point> middles;
    middles.reserve(crowd.size());
    for (int b : crowd) middles.push_back(middle(b));
    fit(zone, middles, one_way ? shape.back : shape.ahead, shape, dx);
    return zone;
  }

 private:
  const coupling::Terms& bonds() const { return ratios_.terms(); }

  Eigen::Matrix2d opening(const Point& centre, double reach, double least_ratio) const {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (std::size_t b = 0; b < bonds().size(); ++b) {
      const double ratio = intact_[b] ? ratios_.at(b, load_factor_) : 0;
      if (ratio < least_ratio || (middle(static_cast<int>(b)) - centre).norm() > reach) continue;
      const Point direction(bonds().cosine[b], bonds().sine[b]);
      sum += ratio * direction * direction.transpose();
    }
    return sum;
  }

  const StretchRatios& ratios_;
  double load_factor_;
  const std::vector<char>& intact_;
  const std::vector<Point>& positions_;
  const std::vector<double>& spacing_;
};

}  // namespace

bool Zone::contains(const Point& p) const {
  const Point q = coordinates(p);
  return (q.array() >= low.array()).all() && (q.array() <= high.array()).all();
}

bool Zone::is_inner(const Point& p) const {
  const Point q = coordinates(p);
  return (q.array() >= inner_low.array()).all() && (q.array() <= inner_high.array()).all();
}

std::vector<Zone> zones_of(const std::vector<int>& hot, const StretchRatios& ratios, double load_factor,
                           const std::vector<char>& intact, const std::vector<Point>& positions,
                           const std::vector<double>& spacing, const ZoneShape& shape) {
  const Builder builder(ratios, load_factor, intact, positions, spacing);
  std::vector<Point> parted;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (!intact[b] && !ratios.terms().is_wide(b)) parted.push_back(builder.middle(static_cast<int>(b)));
  }
  std::vector<Point> middles;
  middles.reserve(hot.size());
  for (int b : hot) middles.push_back(builder.middle(b));
  const double dx = hot.empty() ? 0 : spacing[ratios.terms().first[hot.front()]];
  std::vector<Zone> zones;
  for (const std::vector<int>& crowd : crowds(middles, WindowSettings::crowd_distance * dx)) {
    std::vector<int> members;
    members.reserve(crowd.size());
    for (int k : crowd) members.push_back(hot[k]);
    zones.push_back(builder.zone(members, parted, shape));
  }
  return zones;
}

Zone zone_ahead(const Point& tip, const Point& direction, double spacing, const ZoneShape& shape) {
  Zone zone;
  zone.centre = tip;
  zone.axis = direction;
  fit(zone, {tip}, shape.back, shape, spacing);
  return zone;
}

std::vector<Zone> zones_at_ends(const std::vector<int>& cut, const coupling::Terms& bonds,
                                const std::vector<Point>& positions, const std::vector<double>& spacing,
                                const ZoneShape& shape) {
  std::vector<Point> middles;
  middles.reserve(cut.size());
  for (int b : cut) middles.push_back(0.5 * (positions[bonds.first[b]] + positions[bonds.second[b]]));
  const double dx = spacing[bonds.first[cut.front()]];
  std::vector<Zone> zones;
  for (const std::vector<int>& crowd : crowds(middles, WindowSettings::crowd_distance * dx)) {
    Point mean = Point::Zero();
    for (int k : crowd) mean += middles[k] / static_cast<double>(crowd.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (int k : crowd) spread += (middles[k] - mean) * (middles[k] - mean).transpose();
    const Point along = linalg::symmetric_modes(spread).vectors.col(1);
    for (const Point& axis : {along, Point(-along)}) {
      double end = 0;
      for (int k : crowd) end = std::max(end, axis.dot(middles[k] - mean));
      Zone& zone = zones.emplace_back();
      zone.centre = mean + end * axis;
      zone.axis = axis;
      fit(zone, {zone.centre}, shape.back, shape, dx);
    }
  }
  return zones;
}

}  // namespace bempd::fracture
