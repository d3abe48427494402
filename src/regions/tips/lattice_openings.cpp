#include "regions/tips/lattice_openings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/segment.hpp"
#include "linalg/least_squares.hpp"

namespace bempd::regions {

namespace {

// Half axes [spacings], along the crack and across it, of the half ellipse on one side of the crack with the material
// points for the fit, and the factor by which the ellipse is enlarged if it holds too few points.
constexpr double half_axis_along = 2.5, half_axis_across = 3, enlargement = 1.5;
constexpr int most_ellipses = 3;
constexpr std::size_t enough_for_quadratic = 8, enough_for_linear = 4;

// Largest error of the fit for constant values at which the fit counts as determined by its points.
constexpr double determined = 1e-6;

// Distance from the crack [spacings] at which a place counts as lying on one side of the crack.
constexpr double beside = 1e-3;

class OpeningsOfCrack {
 public:
  OpeningsOfCrack(const BondedBody& body, const std::vector<std::vector<Point>>& paths, std::size_t crack)
      : body_(body), paths_(paths), path_(paths[crack]) {
    for (const auto& region : body.discretization.regions) {
      const std::optional<LatticeGrid> grid = region->lattice_grid();
      if (!grid) continue;
      nodes_.insert(nodes_.end(), region->nodes().begin(), region->nodes().end());
      spacing_ = std::min(spacing_, grid->spacing);
    }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) length_ += (path_[i + 1] - path_[i]).norm();
    has_start_ = is_inside(path_.front()), has_end_ = is_inside(path_.back());
  }

  Point at(double fraction, const Eigen::VectorXd& displacement) const {
    const Place place = place_at(fraction);
    const Point jump = face(place, 1, displacement) - face(place, -1, displacement);
    return {place.tangent.dot(jump), place.normal().dot(jump)};
  }

 private:
  struct Place {
    Point at, tangent;
    Point normal() const { return {-tangent.y(), tangent.x()}; }  // to the left
  };

  // Whether an end of the crack lies inside the body and is a tip. An end on the boundary is a mouth.
  bool is_inside(const Point& end) const {
    return std::any_of(body_.discretization.regions.begin(), body_.discretization.regions.end(),
                       [&](const auto& region) {
                         return scene::has_inside(body_.scene, region->id(), end, body_.discretization.tolerance);
                       });
  }

  Place place_at(double fraction) const {
    double left = fraction * length_;
    for (std::size_t i = 0;; ++i) {
      const Point way = path_[i + 1] - path_[i];
      const double length = way.norm();
      if (left <= length || i + 2 == path_.size()) return {path_[i] + std::min(left / length, 1.0) * way, way / length};
      left -= length;
    }
  }

  // Whether a crack crosses the straight line between two places, so that one place is hidden from the other.
  bool is_hidden(const Point& from, const Point& to) const {
    const Segment sight{from, to};
    for (const std::vector<Point>& path : paths_)
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        if (proper_crossing(sight, Segment{path[i], path[i + 1]})) return true;
    return false;
  }

  // Whether a point lies ahead of a tip of the crack, where it lies on neither side of the crack.
  bool is_ahead_of_end(const Point& point) const {
    const auto is_ahead = [&](const Point& end, const Point& before) { return (point - end).dot(end - before) > 0; };
    return (has_start_ && is_ahead(path_.front(), path_[1])) || (has_end_ && is_ahead(path_.back(), path_.end()[-2]));
  }

  Point face(const Place& place, double side, const Eigen::VectorXd& displacement) const {
    double reach = 1;
    for (int k = 0; k < most_ellipses; ++k, reach *= enlargement) {
      const std::vector<int> found = points(place, side, reach);
      if (found.size() >= enough_for_quadratic)
        if (const std::optional<Point> fit = fitted(place, reach, found, displacement, 6)) return *fit;
      if (k + 1 == most_ellipses && found.size() >= enough_for_linear)
        if (const std::optional<Point> fit = fitted(place, reach, found, displacement, 3)) return *fit;
    }
    return Point::Constant(std::numeric_limits<double>::quiet_NaN());
  }

  std::vector<int> points(const Place& place, double side, double reach) const {
    const Point normal = place.normal(), from = place.at + side * beside * spacing_ * normal;
    std::vector<int> found;
    for (const int node : nodes_) {
      const Point& point = body_.discretization.positions[static_cast<std::size_t>(node)];
      const Point arm = (point - place.at) / spacing_;
      if (weight(place, arm, reach) <= 0 || side * arm.dot(normal) <= beside || is_ahead_of_end(point)) continue;
      if (!is_hidden(from, point)) found.push_back(node);
    }
    return found;
  }

  static double weight(const Place& place, const Point& arm, double reach) {
    const double x = arm.dot(place.tangent) / (half_axis_along * reach),
                 y = arm.dot(place.normal()) / (half_axis_across * reach);
    return std::sqrt(std::max(0.0, 1 - x * x - y * y));
  }

  // Displacement at a place by a least-squares fit of a polynomial with 6 terms (quadratic) or 3 terms (linear) to some
  // nodes around the place. Empty if the nodes do not determine the polynomial, such as nodes in two rows: the same fit
  // to the constant 1 then does not give 1.
  std::optional<Point> fitted(const Place& place, double reach, const std::vector<int>& nodes,
                              const Eigen::VectorXd& displacement, Eigen::Index term_count) const {
    Eigen::MatrixXd terms(static_cast<Eigen::Index>(nodes.size()), term_count);
    Eigen::MatrixXd values(terms.rows(), 3);
    for (Eigen::Index i = 0; i < terms.rows(); ++i) {
      const int node = nodes[static_cast<std::size_t>(i)];
      const Point arm = (body_.discretization.positions[static_cast<std::size_t>(node)] - place.at) / spacing_;
      const double x = arm.dot(place.tangent), y = arm.dot(place.normal()), w = weight(place, arm, reach);
      terms.row(i).head<3>() << w, w * x, w * y;
      if (term_count == 6) terms.row(i).tail<3>() << w * x * x, w * x * y, w * y * y;
      values.row(i) << w * displacement.segment<2>(2 * node).transpose(), w;
    }
    const Eigen::RowVectorXd found = linalg::LeastSquares(terms).solve(values).row(0);
    if (std::abs(found[2] - 1) > determined) return std::nullopt;
    return Point(found[0], found[1]);
  }

  const BondedBody& body_;
  const std::vector<std::vector<Point>>& paths_;
  const std::vector<Point>& path_;
  std::vector<int> nodes_;  // nodes of all lattices
  double spacing_ = std::numeric_limits<double>::infinity(), length_ = 0;
  bool has_start_ = false, has_end_ = false;  // whether the start and the end are tips
};

}  // namespace

std::vector<Point> lattice_openings(const BondedBody& body, const std::vector<std::vector<Point>>& paths,
                                    std::size_t crack, const std::vector<double>& fractions,
                                    const Eigen::VectorXd& displacement) {
  const OpeningsOfCrack openings(body, paths, crack);
  std::vector<Point> values;
  values.reserve(fractions.size());
  for (const double fraction : fractions) values.push_back(openings.at(fraction, displacement));
  return values;
}

}  // namespace bempd::regions
