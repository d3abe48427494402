#include "fracture/active_window.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/dense_inverse.hpp"

namespace bempd::fracture {

namespace {

// Below this pivot a bond was the last resistance to some motion, or nearly so.
constexpr double smallest_pivot = 1e-7;

// Columns collected before they are added to F: enough for a fast product, few enough to be cheap to carry along.
constexpr Eigen::Index most_pending = 96;

// Of a triangular factor, whose product with itself leaves out the rows above them.
constexpr Eigen::Index columns_at_once = 96;

}  // namespace

using coupling::Affine;
using coupling::BondSet;

ActiveWindow::ActiveWindow(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                           const StretchRatios& ratios, const Affine& displacement,
                           const std::vector<Function>& functions)
    : size_(static_cast<Eigen::Index>(condensation.dofs().size())),
      place_(ratios.bonds().size(), -1),
      extended_dofs_(condensation.dofs()) {
  collect_bonds(system, condensation, ratios);
  extended_.resize(static_cast<Eigen::Index>(extended_dofs_.size()), 2);
  for (Eigen::Index i = 0; i < extended_.rows(); ++i) extended_.row(i) = displacement.row(extended_dofs_[i]);
  has_constant_part_ = !extended_.col(0).isZero(0);
  find_outside(system, condensation);
  flexibility_ = condensation.factor();
  linalg::invert_from_cholesky(flexibility_);
  pending_.resize(size_, most_pending);

  Eigen::MatrixXd weights(displacement.rows(), static_cast<Eigen::Index>(functions.size()));
  for (std::size_t k = 0; k < functions.size(); ++k) weights.col(static_cast<Eigen::Index>(k)) = functions[k].weights;
  functions_ = condensation.condense(weights);
  for (const Function& f : functions) {
    moved_.push_back(f.moved.size() == 0 ? Eigen::VectorXd() : Eigen::VectorXd(f.moved(extended_dofs_)));
  }
  update_ratios();
}

void ActiveWindow::collect_bonds(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                                 const StretchRatios& ratios) {
  const BondSet& bonds = system.bonds();
  std::vector<int> place_of(2 * static_cast<std::size_t>(system.node_count()), -1);
  for (std::size_t i = 0; i < condensation.dofs().size(); ++i) place_of[condensation.dofs()[i]] = static_cast<int>(i);
  const auto is_here = [&](int dof) { return place_of[dof] >= 0 || system.is_prescribed(dof); };
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (!system.intact()[b]) continue;
    const std::array<int, 4> dof{2 * bonds.first[b], 2 * bonds.first[b] + 1, 2 * bonds.second[b],
                                 2 * bonds.second[b] + 1};
    if (!std::all_of(dof.begin(), dof.end(), is_here)) continue;
    if (std::none_of(dof.begin(), dof.end(), [&](int d) { return system.is_unknown(d); })) continue;
    Pull pull{{}, {-bonds.cosine[b], -bonds.sine[b], bonds.cosine[b], bonds.sine[b]}};
    for (int k = 0; k < 4; ++k) {
      int& place = place_of[dof[k]];
      if (place < 0) {
        place = static_cast<int>(extended_dofs_.size());
        extended_dofs_.push_back(dof[k]);
      }
      pull.dof[k] = place;
    }
    place_[b] = static_cast<int>(bonds_.size());
    bonds_.push_back(static_cast<int>(b));
    pulls_.push_back(pull);
    stiffness_.push_back(bonds.stiffness[b]);
    const double scale = 1 / (bonds.length[b] * ratios.critical_stretch()[b]);
    cosine_.push_back(bonds.cosine[b] * scale);
    sine_.push_back(bonds.sine[b] * scale);
  }
  intact_.assign(bonds_.size(), 1);
  ratios_.constant.assign(bonds_.size(), 0.0);
  ratios_.proportional.assign(bonds_.size(), 0.0);
}

void ActiveWindow::find_outside(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation) {
  const BondSet& bonds = system.bonds();
  std::vector<char> touched(system.node_count(), 0);
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (system.intact()[b] && place_[b] < 0) touched[bonds.first[b]] = touched[bonds.second[b]] = 1;
  }
  for (const coupling::HoldingSpring& s : system.springs()) touched[s.node] = 1;
  std::vector<int> row_of(static_cast<std::size_t>(size_), -1);
  for (Eigen::Index i = 0; i < size_; ++i) {
    const int node = extended_dofs_[i] / 2;
    if (!touched[node] && !system.in_dense_body(node)) continue;
    row_of[i] = static_cast<int>(outside_dofs_.size());
    outside_dofs_.push_back(static_cast<int>(i));
  }
  // The factor's rows end at their diagonal.
  const Eigen::Index columns = outside_dofs_.empty() ? 0 : outside_dofs_.back() + 1;
  const Eigen::MatrixXd rows = condensation.factor().leftCols(columns)(outside_dofs_, Eigen::all);
  outside_.setZero(rows.rows(), rows.rows());
  for (Eigen::Index c = 0; c < columns; c += columns_at_once) {
    const auto reaching = std::lower_bound(outside_dofs_.begin(), outside_dofs_.end(), static_cast<int>(c));
    const Eigen::Index above = reaching - outside_dofs_.begin(), height = rows.rows() - above;
    outside_.bottomRightCorner(height, height)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(rows.block(above, c, height, std::min(columns_at_once, columns - c)));
  }
  outside_.triangularView<Eigen::StrictlyUpper>() = outside_.transpose();
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    for (int r = 0; r < 4; ++r) {
      for (int c = 0; c < 4; ++c) {
        const int i = pulls_[b].dof[r], j = pulls_[b].dof[c];
        if (i >= size_ || j >= size_ || row_of[i] < 0 || row_of[j] < 0) continue;
        outside_(row_of[i], row_of[j]) -= stiffness_[b] * pulls_[b].weight[r] * pulls_[b].weight[c];
      }
    }
  }
}

void ActiveWindow::update_ratios() {
  const auto fill = [&](int column, std::vector<double>& ratios) {
    const double* u = extended_.col(column).data();
    for (std::size_t b = 0; b < bonds_.size(); ++b) {
      const std::array<int, 4>& d = pulls_[b].dof;
      ratios[b] = cosine_[b] * (u[d[2]] - u[d[0]]) + sine_[b] * (u[d[3]] - u[d[1]]);
    }
  };
  if (has_constant_part_) fill(0, ratios_.constant);
  fill(1, ratios_.proportional);
}

Eigen::Matrix<double, Eigen::Dynamic, 2> ActiveWindow::function_values() const {
  Eigen::Matrix<double, Eigen::Dynamic, 2> values(static_cast<Eigen::Index>(functions_.size()), 2);
  for (std::size_t k = 0; k < functions_.size(); ++k) {
    values.row(static_cast<Eigen::Index>(k)) =
        functions_[k].constant + functions_[k].weights.transpose() * extended_.topRows(size_);
  }
  return values;
}

double ActiveWindow::elongation(int bond, double load_factor) const {
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const int d = pulls_[bond].dof[k];
    sum += pulls_[bond].weight[k] * (extended_(d, 0) + load_factor * extended_(d, 1));
  }
  return sum;
}

Eigen::MatrixXd ActiveWindow::responses(std::span<const int> bonds) const {
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(size_, static_cast<Eigen::Index>(bonds.size()));
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(pending_count_, w.cols());
  for (Eigen::Index c = 0; c < w.cols(); ++c) {
    const Pull& pull = pulls_[bonds[c]];
    for (int k = 0; k < 4; ++k) {
      const Eigen::Index d = pull.dof[k];
      if (d >= size_ || pull.weight[k] == 0) continue;
      w.col(c).head(d) += pull.weight[k] * flexibility_.row(d).head(d).transpose();
      w.col(c).tail(size_ - d) += pull.weight[k] * flexibility_.col(d).tail(size_ - d);
      along.col(c) += pull.weight[k] * pending_.row(d).head(pending_count_).transpose();
    }
  }
  w.noalias() += pending_.leftCols(pending_count_) * along;
  return w;
}

void ActiveWindow::flush() {
  if (size_ == 0 || pending_count_ == 0) return;
  flexibility_.selfadjointView<Eigen::Lower>().rankUpdate(pending_.leftCols(pending_count_));
  pending_count_ = 0;
}

bool ActiveWindow::remove_one(int bond, Eigen::Ref<Eigen::VectorXd> w, Eigen::Index changes_known) {
  const Pull& pull = pulls_[bond];
  const double k = stiffness_[bond];
  for (Eigen::Index c = changes_known; c < pending_count_; ++c) {
    double along = 0;
    for (int i = 0; i < 4; ++i) {
      if (pull.dof[i] < size_) along += pull.weight[i] * pending_(pull.dof[i], c);
    }
    w += along * pending_.col(c);
  }
  double own = 0;
  Eigen::RowVector2d elongation = Eigen::RowVector2d::Zero();
  for (int i = 0; i < 4; ++i) {
    if (pull.dof[i] < size_) own += pull.weight[i] * w[pull.dof[i]];
    elongation += pull.weight[i] * extended_.row(pull.dof[i]);
  }
  const double pivot = 1 - k * own;
  if (!(pivot > smallest_pivot)) return false;
  if (has_constant_part_) extended_.col(0).head(size_) += (k * elongation[0] / pivot) * w;
  extended_.col(1).head(size_) += (k * elongation[1] / pivot) * w;
  pending_.col(pending_count_++) = std::sqrt(k / pivot) * w;
  // A bond to a moving support took part in what the support feels.
  for (std::size_t f = 0; f < functions_.size(); ++f) {
    if (moved_[f].size() == 0) continue;
    double lever = 0;
    for (int i = 0; i < 4; ++i) lever += pull.weight[i] * moved_[f][pull.dof[i]];
    if (lever == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const int d = pull.dof[i];
      if (d < size_) {
        functions_[f].weights[d] -= k * lever * pull.weight[i];
      } else {
        functions_[f].constant -= k * lever * pull.weight[i] * extended_.row(d);
      }
    }
  }
  intact_[bond] = 0;
  return true;
}

bool ActiveWindow::remove(std::span<const int> bonds) {
  if (pending_count_ + static_cast<Eigen::Index>(bonds.size()) > most_pending) flush();
  if (static_cast<Eigen::Index>(bonds.size()) > most_pending) pending_.conservativeResize(size_, bonds.size());
  const Affine before = extended_;
  const Eigen::Index pending_before = pending_count_;
  const auto is_supported = [&](int b) {
    return std::any_of(pulls_[b].dof.begin(), pulls_[b].dof.end(), [&](int d) { return d >= size_; });
  };
  const bool functions_change = std::any_of(bonds.begin(), bonds.end(), is_supported);
  std::vector<coupling::CondensedFunction> functions_before;
  if (functions_change) functions_before = functions_;
  // Of all bonds at once, so that what is pending is read once; every bond adds what those before it changed.
  Eigen::MatrixXd answers = responses(bonds);
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    if (remove_one(bonds[i], answers.col(static_cast<Eigen::Index>(i)), pending_before)) continue;
    extended_ = before;
    if (functions_change) functions_ = std::move(functions_before);
    pending_count_ = pending_before;
    for (int back : bonds) intact_[back] = 1;
    return false;
  }
  update_ratios();
  return true;
}

}  // namespace bempd::fracture
