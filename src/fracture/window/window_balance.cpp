#include "fracture/window/window_balance.hpp"

namespace bempd::fracture {

using coupling::Affine;

WindowBalance::WindowBalance(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                             const WindowTerms& terms, const Affine& rows)
    : system_(&system), numbers_(terms.numbers()), load_(condensation.load()) {
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const Pull pull = terms.pull(t);
    for (std::size_t k = 0; k < pull.size(); ++k) pulls_.add(pull.place[k], pull.weight[k]);
    pulls_.close();
    // Prescribed displacements at the ends of terms also exert forces on the window's degrees of freedom through these
    // terms; such forces are a part of the load.
    Eigen::RowVector2d tension = Eigen::RowVector2d::Zero();
    for (std::size_t k = 0; k < pull.size(); ++k) {
      if (pull.place[k] >= load_.rows()) tension += terms.stiffness(t) * pull.weight[k] * rows.row(pull.place[k]);
    }
    if (tension.isZero(0)) continue;
    for (std::size_t k = 0; k < pull.size(); ++k) {
      if (pull.place[k] < load_.rows()) load_.row(pull.place[k]) += pull.weight[k] * tension;
    }
  }
}

void WindowBalance::note_loss(const LinearForms& pull, double stiffness) {
  lost_pulls_.append(pull);
  lost_.push_back(stiffness);
}

Eigen::VectorXd WindowBalance::unbalanced(const Eigen::VectorXd& rows, int part,
                                          const OutsideStiffness& outside) const {
  Eigen::VectorXd force = load_.col(part);
  if (!outside.dofs.empty()) force(outside.dofs) -= outside.matrix * rows(outside.dofs);
  const auto pull_back = [&](const Pull& pull, double stiffness) {
    double tension = 0;
    for (std::size_t k = 0; k < pull.size(); ++k) tension += stiffness * pull.weight[k] * rows[pull.place[k]];
    for (std::size_t k = 0; k < pull.size(); ++k) {
      if (pull.place[k] < force.size()) force[pull.place[k]] -= pull.weight[k] * tension;
    }
  };
  for (std::size_t t = 0; t < numbers_.size(); ++t) {
    const double stiffness = system_->stages().stiffness()[numbers_[t]];
    if (stiffness != 0) pull_back(pulls_[t], stiffness);
  }
  for (std::size_t i = 0; i < lost_.size(); ++i) pull_back(lost_pulls_[i], -lost_[i]);
  return force;
}

}  // namespace bempd::fracture
