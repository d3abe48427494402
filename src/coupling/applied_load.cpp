#include "coupling/applied_load.hpp"

#include <algorithm>
#include <utility>

namespace bempd::coupling {

// Stores the loads, and each different motion of supports (pair of constant and proportional part) once. The points of
// an edge usually move alike, so that thousands of degrees of freedom have a few motions.
void AppliedLoad::set(Affine force, Affine prescribed, const std::vector<DofKind>& kind, const NodeTies& ties) {
  force_ = std::move(force);
  prescribed_ = std::move(prescribed);
  support_motions_.clear();
  for (std::size_t dof = 0; dof < kind.size(); ++dof) {
    const auto row = static_cast<Eigen::Index>(dof);
    if (kind[dof] != DofKind::prescribed) prescribed_.row(row).setZero();
    const std::array<double, 2> motion{prescribed_(row, 0), prescribed_(row, 1)};
    if (motion != std::array<double, 2>{}) support_motions_.push_back(motion);
  }
  std::sort(support_motions_.begin(), support_motions_.end());
  support_motions_.erase(std::unique(support_motions_.begin(), support_motions_.end()), support_motions_.end());
  for (int part = 0; part < 2; ++part) force_parts_[part] = force_.col(part).lpNorm<Eigen::Infinity>();
  ties.collect(force_);
}

double AppliedLoad::support_motion() const {
  double largest = 0;
  for (const auto& motion : support_motions_) largest = std::max(largest, std::abs(motion[1]));
  return largest;
}

double AppliedLoad::support_motion(double load_factor) const {
  double largest = 0;
  for (const auto& motion : support_motions_)
    largest = std::max(largest, std::abs(motion[0] + load_factor * motion[1]));
  return largest;
}

double AppliedLoad::parts_of_support_motion(double load_factor) const {
  double largest = 0;
  for (const auto& motion : support_motions_)
    largest = std::max(largest, std::abs(motion[0]) + std::abs(load_factor * motion[1]));
  return largest;
}

}  // namespace bempd::coupling
