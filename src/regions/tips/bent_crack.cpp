#include "regions/tips/bent_crack.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/segment.hpp"

namespace bempd::regions {

namespace {

// Distance from the tip up to which the crack is followed, relative to the radius that is asked for. A shorter crack is
// extended straight to this distance.
constexpr double two_sided_reach = 3;
// Length of a part of a crack face [spacings].
constexpr double part_length = 0.25;

// Largest distance of nodes from the middle of a part of a crack face at which the nodes have a share in the
// displacement of that part [spacings].
constexpr double share_reach = 2.5;
// Distance from the straight line through the tip, relative to the radius or to the spacing, below which a place of the
// crack counts as lying on that line.
constexpr double on_line = 1e-9;
// Rounding error of a number of parts: a piece of the crack gets an additional part only if its length exceeds a whole
// number of parts by more than this share of a part.
constexpr double rounding = 1e-6;
// Mean square distance [spacings^2] of the nodes at a part of a crack face from the straight line that fits them best.
// Below it (nodes in a row) the nodes do not determine the slope of the displacement across this line.
constexpr double least_moment = 1e-3;

double angle_on_left(const Point& local) {
  const double angle = std::atan2(local.y(), local.x());
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

}  // namespace

BentCrack::BentCrack(const std::vector<Point>& path, double radius) {
  for (auto p = path.rbegin(); p != path.rend(); ++p) {
    path_.push_back(*p);
    if (p->norm() > two_sided_reach * radius) break;
  }
  const bool is_bent = std::any_of(path_.begin(), path_.end(),
                                   [&](const Point& p) { return std::max(std::abs(p.y()), p.x()) > on_line * radius; });
  if (!is_bent || path_.size() < 2) {
    path_.clear();
    return;
  }
  beside_ = {Point(0, 0)};
  beside_.insert(beside_.end(), path_.begin(), path_.end());
  const Point last = path_.back();
  if (last.norm() < two_sided_reach * radius)
    beside_.push_back(last + two_sided_reach * radius * (last - path_[path_.size() - 2]).normalized());
  // The outline of the area returns to the straight line behind the tip by a corner outside of the circle of the
  // radius. A straight return would leave out places within the radius.
  const double far = beside_.back().norm();
  Point between = beside_.back() / far + Point(-1, 0);
  if (between.norm() > 1e-6) beside_.push_back(2 * far * between.normalized());
  beside_.emplace_back(-far, 0);
}

// Whether a place lies between the bent crack and the straight line back from the tip, by the even-odd rule.
bool BentCrack::is_beside_line(const Point& place) const {
  bool inside = false;
  for (std::size_t i = 0, j = beside_.size() - 1; i < beside_.size(); j = i++) {
    const Point &a = beside_[i], &b = beside_[j];
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    if (place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

TipPolar BentCrack::polar(const Point& place, const Point& centre) const {
  const Point local = place - centre;
  TipPolar found{local.norm(), std::atan2(local.y(), local.x())};
  if (!beside_.empty() && is_beside_line(place)) found.angle += (local.y() < 0 ? 2 : -2) * std::numbers::pi;
  return found;
}

void BentCrack::divide(const std::vector<Point>& nodes, double spacing) {
  for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
    const Segment piece{path_[i + 1], path_[i]};
    const bool on_its_line =
        std::abs(piece.start.y()) <= on_line * spacing && std::abs(piece.end.y()) <= on_line * spacing;
    if (on_its_line) continue;
    const int count = std::max(1, static_cast<int>(std::ceil(piece.length() / (part_length * spacing) - rounding)));
    const Point right = Point(piece.direction().y(), -piece.direction().x()) / count;
    for (int k = 0; k < count; ++k) {
      const Point middle = piece.at((k + 0.5) / count);
      add_part({middle, right, true, {}}, nodes, spacing);
      add_part({middle, -right, false, {}}, nodes, spacing);
    }
  }
}

// Finds the shares of the nodes by a fit of a linear function to the nodes on the part's side, in which nearer nodes
// have more weight. The function is written about the weighted mean place of the nodes. The fit is then exact for
// constants even if the nodes do not determine every slope, such as nodes in a row.
void BentCrack::add_part(const Part& part, const std::vector<Point>& nodes, double spacing) {
  const auto crosses = [&](const Segment& sight) {
    for (std::size_t i = 0; i + 1 < path_.size(); ++i)
      if (proper_crossing(sight, {path_[i], path_[i + 1]})) return true;
    return false;
  };
  const Point seen_from = part.middle - 1e-6 * spacing * part.area.normalized();
  std::vector<std::pair<std::size_t, double>> near;  // nodes and their weights
  double total = 0;
  Point mean = Point::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double gap = (nodes[i] - part.middle).norm() / (share_reach * spacing);
    if (gap >= 1 || crosses({seen_from, nodes[i]})) continue;
    near.emplace_back(i, std::pow(1 - gap * gap, 2));
    total += near.back().second;
    mean += near.back().second * nodes[i];
  }
  if (near.empty()) return;
  mean /= total;
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
  for (const auto& [i, weight] : near) moments += weight * (nodes[i] - mean) * (nodes[i] - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> modes(moments);
  const double least = least_moment * total * spacing * spacing;
  Point slope = Point::Zero();
  for (int k = 0; k < 2; ++k)
    if (modes.eigenvalues()[k] > least)
      slope +=
          modes.eigenvectors().col(k).dot(part.middle - mean) / modes.eigenvalues()[k] * modes.eigenvectors().col(k);
  Part found = part;
  for (const auto& [i, weight] : near)
    found.shares.emplace_back(static_cast<int>(i), weight * (1 / total + slope.dot(nodes[i] - mean)));
  parts_.push_back(std::move(found));
}

void BentCrack::add_forces(const CrackTipField& field, const Point& centre,
                           const std::function<void(int node, const Point& force)>& add) const {
  for (const Part& part : parts_) {
    const Point local = part.middle - centre;
    const double angle = angle_on_left(local) - (part.is_left ? 0 : 2 * std::numbers::pi);
    const Eigen::Vector3d s = field.stress({local.norm(), angle});
    const Point force(s[0] * part.area.x() + s[2] * part.area.y(), s[2] * part.area.x() + s[1] * part.area.y());
    for (const auto& [node, share] : part.shares) add(node, share * force);
  }
}

}  // namespace bempd::regions
