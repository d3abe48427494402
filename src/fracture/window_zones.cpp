#include "fracture/window_zones.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace bempd::fracture {

namespace {

// In lattice spacings: hot bonds nearer to each other than this are one crowd; broken bonds as near tell on which side
// of a crowd the crack is; the rim of a zone in front and behind, and beside.
constexpr double crowd_distance = 6;
constexpr double crack_distance = 8;
constexpr double front_rim = 3, side_rim = 0.75;
constexpr double beside_hot = 3;

// Of the largest ratio in a crowd: bonds that tell in which direction a crack opens.
constexpr double opening_share = 0.85;

class Builder {
 public:
  Builder(const StretchRatios& ratios, double load_factor, const std::vector<Point>& positions,
          const std::vector<double>& spacing)
      : ratios_(ratios), load_factor_(load_factor), positions_(positions), spacing_(spacing) {}

  Point middle(int b) const { return 0.5 * (positions_[bonds().first[b]] + positions_[bonds().second[b]]); }
  double spacing(int b) const { return spacing_[bonds().first[b]]; }

  std::vector<std::vector<int>> crowds(const std::vector<int>& hot) const {
    std::vector<int> crowd_of(hot.size(), -1);
    std::vector<std::vector<int>> result;
    for (std::size_t seed = 0; seed < hot.size(); ++seed) {
      if (crowd_of[seed] >= 0) continue;
      const int crowd = static_cast<int>(result.size());
      std::vector<std::size_t> open{seed};
      crowd_of[seed] = crowd;
      std::vector<int>& members = result.emplace_back();
      while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        members.push_back(hot[i]);
        for (std::size_t j = 0; j < hot.size(); ++j) {
          if (crowd_of[j] >= 0 || (middle(hot[i]) - middle(hot[j])).norm() > crowd_distance * spacing(hot[i])) continue;
          crowd_of[j] = crowd;
          open.push_back(j);
        }
      }
    }
    return result;
  }

  Zone zone(const std::vector<int>& crowd, const std::vector<Point>& parted, const ZoneShape& shape) const {
    double largest = 0;
    for (int b : crowd) largest = std::max(largest, ratios_.at(b, load_factor_));
    Eigen::Matrix2d opening = Eigen::Matrix2d::Zero();
    Zone zone;
    zone.centre.setZero();
    double weight = 0;
    for (int b : crowd) {
      const double ratio = ratios_.at(b, load_factor_);
      if (ratio < opening_share * largest) continue;
      const Point direction(bonds().cosine[b], bonds().sine[b]);
      opening += ratio * direction * direction.transpose();
      zone.centre += ratio * middle(b);
      weight += ratio;
    }
    zone.centre /= weight;
    const double dx = spacing(crowd.front());
    // A crack runs across the direction in which it opens.
    zone.axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(opening).eigenvectors().col(0);
    Point crack = Point::Zero();
    for (const Point& p : parted) {
      if ((p - zone.centre).norm() < crack_distance * dx) crack += p - zone.centre;
    }
    if (zone.axis.dot(crack) > 0) zone.axis = -zone.axis;
    const bool one_way = -zone.axis.dot(crack) > 0.5 * crack.norm() && crack.norm() > 0;
    fit(zone, crowd, one_way ? shape.back : shape.ahead, shape, dx);
    return zone;
  }

 private:
  const coupling::BondSet& bonds() const { return ratios_.bonds(); }

  void fit(Zone& zone, const std::vector<int>& crowd, double back, const ZoneShape& shape, double dx) const {
    Point low = Point::Zero(), high = Point::Zero();
    for (int b : crowd) {
      const Point p = zone.coordinates(middle(b));
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    zone.low = {low.x() - back * dx, std::min(-shape.half_width * dx, low.y() - beside_hot * dx)};
    zone.high = {high.x() + shape.ahead * dx, std::max(shape.half_width * dx, high.y() + beside_hot * dx)};
    // Behind the tip nothing is expected to break.
    zone.inner_low = zone.low + Point(back == shape.back ? side_rim * dx : front_rim * dx, side_rim * dx);
    zone.inner_high = zone.high - Point(front_rim * dx, side_rim * dx);
  }

  const StretchRatios& ratios_;
  double load_factor_;
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
  const Builder builder(ratios, load_factor, positions, spacing);
  std::vector<Point> parted;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (!intact[b]) parted.push_back(builder.middle(static_cast<int>(b)));
  }
  std::vector<Zone> zones;
  for (const std::vector<int>& crowd : builder.crowds(hot)) zones.push_back(builder.zone(crowd, parted, shape));
  return zones;
}

}  // namespace bempd::fracture
