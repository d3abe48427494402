#include "coupling/rigid_motion.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "linalg/symmetric_modes.hpp"
#include "number_range.hpp"

namespace bempd::coupling {

namespace {

// Limit on the ratio of an eigenvalue of D^T D to the largest one, where the rows of D are the directions in which
// rigid motions are held; above the limit a motion counts as held.
constexpr double rank_tolerance = 1e-12;

Eigen::Matrix<double, 3, Eigen::Dynamic> null_space(const Eigen::Matrix3d& gram) {
  const linalg::SymmetricModes modes = linalg::symmetric_modes(gram);
  const double largest = modes.values[2];
  int free = 0;
  while (free < 3 && !(largest > 0 && modes.values[free] > rank_tolerance * largest)) ++free;
  return modes.vectors.leftCols(free);
}

// Orthonormal basis, as columns, of the space R^n, where n is the length of `row`. The last vector lies along `row`.
Eigen::MatrixXd basis_along(const Eigen::RowVectorXd& row) {
  return linalg::symmetric_modes(row.transpose() * row).vectors;
}

}  // namespace

RigidMotion::RigidMotion(const std::vector<Point>& positions, const std::vector<int>& nodes,
                         const std::vector<HeldDirection>& held) {
  for (int node : nodes) centre_ += positions[node];
  centre_ /= static_cast<double>(std::max<std::size_t>(nodes.size(), 1));
  double radius = 0;
  for (int node : nodes) radius = std::max(radius, (positions[node] - centre_).norm());
  if (radius > 0) radius_ = radius;

  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  for (const HeldDirection& h : held) {
    const Eigen::RowVector3d r = row(positions[h.node], h.cosine, h.sine);
    gram += r.transpose() * r;
  }
  free_ = null_space(gram);
  if (radius == 0) {
    // A single node does not rotate, so only its two translations count.
    const linalg::SymmetricModes modes = linalg::symmetric_modes(gram.topLeftCorner<2, 2>());
    int free = 0;
    while (free < 2 && modes.values[free] <= rank_tolerance) ++free;
    free_.setZero(3, free);
    free_.topRows<2>() = modes.vectors.leftCols(free);
  }
}

Eigen::RowVector3d RigidMotion::row(const Point& position, double cosine, double sine) const {
  const Point arm = (position - centre_) / radius_;
  return {cosine, sine, -arm.y() * cosine + arm.x() * sine};
}

Point RigidMotion::displacement(int motion, const Point& position) const {
  return {row(position, 1, 0).dot(free_.col(motion)), row(position, 0, 1).dot(free_.col(motion))};
}

double RigidMotion::work(int motion, const std::vector<Point>& positions, const std::vector<int>& nodes,
                         const Eigen::Ref<const Eigen::VectorXd>& forces) const {
  double sum = 0;
  for (int node : nodes) sum += forces.segment<2>(2 * node).dot(displacement(motion, positions[node]));
  return sum;
}

std::vector<HeldDirection> RigidMotion::missing_supports(const std::vector<Point>& positions,
                                                         const std::vector<HeldDirection>& candidates) const {
  std::vector<HeldDirection> supports;
  Eigen::MatrixXd remaining = free_;
  while (remaining.cols() > 0) {
    const HeldDirection* best = nullptr;
    double largest = std::sqrt(rank_tolerance);
    for (const HeldDirection& h : candidates) {
      const double size = (row(positions[h.node], h.cosine, h.sine) * remaining).norm();
      if (size > largest * (1 + 1e-12)) {
        largest = size;
        best = &h;
      }
    }
    if (!best) break;
    supports.push_back(*best);
    // The motion that the chosen support holds is removed from the motions that remain free.
    const Eigen::RowVectorXd held = row(positions[best->node], best->cosine, best->sine) * remaining;
    remaining = (remaining * basis_along(held).leftCols(remaining.cols() - 1)).eval();
  }
  return supports;
}

std::string RigidMotion::describe() const {
  if (free_count() == 3) return "translate in x and y, and rotate";
  std::string sentence;
  const auto add = [&](const std::string& part) { sentence += (sentence.empty() ? "" : ", and ") + part; };
  const auto translation = [](const Eigen::Vector3d& m) -> std::string {
    if (std::abs(m.y()) < 1e-6) return "translate in x";
    if (std::abs(m.x()) < 1e-6) return "translate in y";
    return "translate along (" + std::to_string(m.x()) + ", " + std::to_string(m.y()) + ")";
  };
  // Pure translations are named before the rotation, because readers recognise them more easily.
  const bool rotates = free_count() > 0 && free_.row(2).norm() > 1e-9;
  const Eigen::MatrixXd sorted = free_ * basis_along(free_.row(2));
  const int translations = free_count() - (rotates ? 1 : 0);
  if (translations == 2) {
    add("translate in x and y");
  } else if (translations == 1) {
    add(translation(sorted.col(0)));
  }
  if (rotates) add("rotate");
  return sentence;
}

RigidFit nearest_rigid_motion(const std::vector<Point>& positions, const std::vector<int>& nodes,
                              const Eigen::VectorXd& displacement) {
  double largest = 0;
  for (const int node : nodes) largest = std::max(largest, displacement.segment<2>(2 * node).lpNorm<Eigen::Infinity>());
  if (const int far = far_exponent(largest); far != 0) {
    RigidFit near = nearest_rigid_motion(positions, nodes, displacement * std::ldexp(1, -far));
    for (double* value : {&near.translation.x(), &near.translation.y(), &near.rotation, &near.deviation})
      *value = in_range(std::ldexp(*value, far));
    return near;
  }
  RigidFit fit;
  for (int node : nodes) {
    fit.centre += positions[node] / static_cast<double>(nodes.size());
    fit.translation += displacement.segment<2>(2 * node) / static_cast<double>(nodes.size());
  }
  double turned = 0, inertia = 0;
  const auto lever = [&](int node) {
    return Eigen::Vector2d(fit.centre.y() - positions[node].y(), positions[node].x() - fit.centre.x());
  };
  for (int node : nodes) {
    turned += lever(node).dot(displacement.segment<2>(2 * node) - fit.translation);
    inertia += lever(node).squaredNorm();
  }
  if (inertia > 0) fit.rotation = turned / inertia;
  for (int node : nodes) {
    const Eigen::Vector2d rigid = fit.translation + fit.rotation * lever(node);
    fit.deviation = std::max(fit.deviation, (displacement.segment<2>(2 * node) - rigid).norm());
  }
  return fit;
}

}  // namespace bempd::coupling
