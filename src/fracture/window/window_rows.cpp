#include "fracture/window/window_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bempd::fracture {

using coupling::Affine;

WindowRows::WindowRows(const std::vector<int>& kept_dofs, Eigen::Index functions,
                       const std::vector<int>& prescribed_dofs, const Affine& displacement)
    : kept_dofs_(kept_dofs),
      functions_(functions),
      followed_(kept_dofs.size()),
      row_of_(static_cast<std::size_t>(displacement.rows())) {
  std::iota(followed_.begin(), followed_.end(), 0);
  number_rows();
  const auto prescribed = static_cast<Eigen::Index>(prescribed_dofs.size());
  values_ = Affine::Zero(size() + functions + prescribed, 2);
  values_.topRows(size()) = displacement(kept_dofs, Eigen::all);
  values_.bottomRows(prescribed) = displacement(prescribed_dofs, Eigen::all);
}

bool WindowRows::is_supported(const Pull& pull) const {
  return std::any_of(pull.place.begin(), pull.place.end(), [&](int r) { return is_prescribed(r); });
}

Eigen::RowVector2d WindowRows::elongation(const Pull& pull) const {
  Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
  for (std::size_t i = 0; i < pull.size(); ++i) sum += pull.weight[i] * values_.row(pull.place[i]);
  return sum;
}

double WindowRows::elongation(const Pull& pull, double load_factor) const {
  double sum = 0;
  for (std::size_t k = 0; k < pull.size(); ++k) {
    const int r = pull.place[k];
    sum += pull.weight[k] * (values_(r, 0) + load_factor * values_(r, 1));
  }
  return sum;
}

bool WindowRows::follows(const coupling::Constraint& constraint) const {
  return constraint.is_on([&](int dof) { return row_of(dof) >= 0; });
}

double WindowRows::gap(const coupling::Constraint& constraint, double load_factor) const {
  return constraint.gap_at([&](int dof) { return values_(row_of(dof), 0) + load_factor * values_(row_of(dof), 1); });
}

double WindowRows::gap(const coupling::Constraint& constraint, double load_factor, const Affine& kept) const {
  return constraint.gap_at([&](int dof) {
    const int r = followed_[row_of(dof)];
    return kept(r, 0) + load_factor * kept(r, 1);
  });
}

double WindowRows::largest_displacement(double load_factor) const {
  const auto part = [&](Eigen::Index column) { return values_.col(column).head(size()).lpNorm<Eigen::Infinity>(); };
  return size() == 0 ? 0 : part(0) + std::abs(load_factor) * part(1);
}

void WindowRows::add_form(const Pull& pull, double scale, DroppedDofs::Forms& forms) const {
  Eigen::RowVector2d fixed = Eigen::RowVector2d::Zero();
  for (std::size_t k = 0; k < pull.size(); ++k) {
    const int r = pull.place[k];
    const double weight = pull.weight[k] * scale;
    if (is_prescribed(r)) {
      fixed += weight * values_.row(r);
    } else {
      forms.of_displacements.add(followed_[r], weight);
    }
  }
  forms.of_displacements.close();
  forms.fixed.push_back(fixed);
}

// Rows of functions and of prescribed displacements are all kept.
std::vector<int> WindowRows::keep(const std::vector<int>& kept_rows) {
  std::vector<int> rows = kept_rows, place(static_cast<std::size_t>(values_.rows()), -1), followed;
  for (const int r : kept_rows) followed.push_back(followed_[r]);
  for (Eigen::Index r = size(); r < values_.rows(); ++r) rows.push_back(static_cast<int>(r));
  for (std::size_t r = 0; r < rows.size(); ++r) place[rows[r]] = static_cast<int>(r);
  values_ = Affine(values_(rows, Eigen::all));
  followed_ = std::move(followed);
  number_rows();
  return place;
}

void WindowRows::number_rows() {
  std::fill(row_of_.begin(), row_of_.end(), -1);
  for (std::size_t i = 0; i < followed_.size(); ++i) row_of_[kept_dofs_[followed_[i]]] = static_cast<int>(i);
}

}  // namespace bempd::fracture
