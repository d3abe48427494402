#include "stress.hpp"

#include <cmath>

namespace directions {

MeanStress::MeanStress(const Body& body, const Window& window, double radius) : body_(body), window_(window) {
  const std::vector<int>& points = window.points();
  neighbours_.resize(points.size());
  for (std::size_t a = 0; a < points.size(); ++a) {
    double sum = 0;
    for (std::size_t b = 0; b < points.size(); ++b) {
      const double ratio =
          (body.points[static_cast<std::size_t>(points[a])] - body.points[static_cast<std::size_t>(points[b])]).norm() /
          (radius + 1e-12);
      const double weight = a == b ? 1 : ratio < 1 ? (1 - ratio * ratio) * (1 - ratio * ratio) : 0;
      if (weight > 0) neighbours_[a].push_back({static_cast<int>(b), weight}), sum += weight;
    }
    for (Neighbour& n : neighbours_[a]) n.weight /= sum;
  }
  own_.resize(points.size());
  mean_.resize(points.size());
}

void MeanStress::update() {
  for (Eigen::Vector3d& s : own_) s.setZero();
  for (const int k : window_.bonds()) {
    const double stiffness = window_.stiffness(k);
    if (stiffness == 0) continue;
    const Bond& bond = body_.bonds[static_cast<std::size_t>(k)];
    const Point e = bond.direction;
    const double share = stiffness * window_.elongation(k) * bond.length / 2;
    const Eigen::Vector3d part = share * Eigen::Vector3d(e.x() * e.x(), e.y() * e.y(), e.x() * e.y());
    own_[static_cast<std::size_t>(window_.local(bond.first))] += part;
    own_[static_cast<std::size_t>(window_.local(bond.second))] += part;
  }
  for (std::size_t a = 0; a < mean_.size(); ++a) {
    mean_[a].setZero();
    for (const Neighbour& n : neighbours_[a]) mean_[a] += n.weight * own_[static_cast<std::size_t>(n.local)];
  }
}

Principal principal(const Eigen::Vector3d& stress) {
  const double middle = (stress[0] + stress[1]) / 2, half = (stress[0] - stress[1]) / 2;
  const double radius = std::hypot(half, stress[2]);
  const double angle = std::atan2(stress[2], half) / 2;
  return {middle + radius, {std::cos(angle), std::sin(angle)}};
}

}  // namespace directions
