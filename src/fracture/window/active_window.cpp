#include "fracture/window/active_window.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
    : kept_(static_cast<Eigen::Index>(condensation.dofs().size())),
      size_(kept_),
      functions_(static_cast<Eigen::Index>(functions.size())),
      followed_(condensation.dofs().size()),
      contained_(ratios.bonds().size(), 0) {
  std::iota(followed_.begin(), followed_.end(), 0);
  collect_bonds(system, condensation, ratios);
  extended_.setZero(size_ + functions_ + static_cast<Eigen::Index>(prescribed_dofs_.size()), 2);
  extended_.topRows(size_) = displacement(condensation.dofs(), Eigen::all);
  extended_.bottomRows(extended_.rows() - size_ - functions_) = displacement(prescribed_dofs_, Eigen::all);
  has_constant_part_ = !displacement.col(0).isZero(0);
  find_outside(system, condensation);
  flexibility_.resize(size_ + functions_, size_);
  flexibility_.topRows(size_) = condensation.factor();
  linalg::invert_from_cholesky(flexibility_.topRows(size_));
  pending_.resize(size_ + functions_, most_pending);
  collect_functions(condensation, functions, displacement.rows());
  update_ratios();
}

void ActiveWindow::collect_functions(const coupling::Condensation& condensation, const std::vector<Function>& functions,
                                     Eigen::Index dofs) {
  if (functions.empty()) return;
  Eigen::MatrixXd weights(dofs, functions_), kept_weights(size_, functions_);
  for (Eigen::Index k = 0; k < functions_; ++k) weights.col(k) = functions[static_cast<std::size_t>(k)].weights;
  Eigen::Index k = 0;
  for (const coupling::CondensedFunction& f : condensation.condense(weights)) {
    kept_weights.col(k) = f.weights;
    extended_.row(size_ + k++) = f.constant + f.weights.transpose() * extended_.topRows(size_);
  }
  const Eigen::MatrixXd answers = flexibility_.topRows(size_).selfadjointView<Eigen::Lower>() * kept_weights;
  flexibility_.bottomRows(functions_) = answers.transpose();
  for (const Function& f : functions) {
    moved_.push_back(f.moved.size() == 0 ? Eigen::VectorXd() : Eigen::VectorXd(f.moved(prescribed_dofs_)));
  }
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
        place = static_cast<int>(size_ + functions_ + static_cast<Eigen::Index>(prescribed_dofs_.size()));
        prescribed_dofs_.push_back(dof[k]);
      }
      pull.dof[k] = place;
    }
    contained_[b] = 1;
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
    if (system.intact()[b] && !contained_[b]) touched[bonds.first[b]] = touched[bonds.second[b]] = 1;
  }
  for (const coupling::HoldingSpring& s : system.springs()) touched[s.node] = 1;
  std::vector<int> row_of(static_cast<std::size_t>(size_), -1);
  for (Eigen::Index i = 0; i < size_; ++i) {
    const int node = condensation.dofs()[i] / 2;
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
      if (!intact_[b]) continue;
      ratios[b] = cosine_[b] * (u[d[2]] - u[d[0]]) + sine_[b] * (u[d[3]] - u[d[1]]);
    }
  };
  if (has_constant_part_) fill(0, ratios_.constant);
  fill(1, ratios_.proportional);
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
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(flexibility_.rows(), static_cast<Eigen::Index>(bonds.size()));
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(pending_count_, w.cols());
  for (Eigen::Index c = 0; c < w.cols(); ++c) {
    const Pull& pull = pulls_[bonds[c]];
    for (int k = 0; k < 4; ++k) {
      const Eigen::Index d = pull.dof[k];
      if (d >= size_ || pull.weight[k] == 0) continue;
      w.col(c).head(d) += pull.weight[k] * flexibility_.row(d).head(d).transpose();
      w.col(c).tail(w.rows() - d) += pull.weight[k] * flexibility_.col(d).tail(w.rows() - d);
      along.col(c) += pull.weight[k] * pending_.row(d).head(pending_count_).transpose();
    }
  }
  w.noalias() += pending_.leftCols(pending_count_) * along;
  return w;
}

void ActiveWindow::flush() {
  if (size_ == 0 || pending_count_ == 0) return;
  const auto columns = pending_.leftCols(pending_count_);
  flexibility_.topRows(size_).selfadjointView<Eigen::Lower>().rankUpdate(columns.topRows(size_));
  flexibility_.bottomRows(functions_).noalias() += columns.bottomRows(functions_) * columns.topRows(size_).transpose();
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
  detach_functions(pull, k, w);
  if (has_constant_part_) extended_.col(0).head(w.size()) += (k * elongation[0] / pivot) * w;
  extended_.col(1).head(w.size()) += (k * elongation[1] / pivot) * w;
  pending_.col(pending_count_++) = std::sqrt(k / pivot) * w;
  intact_[bond] = 0;
  ratios_.constant[bond] = ratios_.proportional[bond] = 0;
  return true;
}

// A bond to a moving support took part in what the support feels.
void ActiveWindow::detach_functions(const Pull& pull, double stiffness, Eigen::Ref<Eigen::VectorXd> w) {
  double own = 0;
  Eigen::RowVector2d elongation = Eigen::RowVector2d::Zero();
  for (int i = 0; i < 4; ++i) {
    if (!is_prescribed(pull.dof[i])) own += pull.weight[i] * w[pull.dof[i]];
    elongation += pull.weight[i] * extended_.row(pull.dof[i]);
  }
  for (std::size_t f = 0; f < moved_.size(); ++f) {
    if (moved_[f].size() == 0) continue;
    double lever = 0;
    for (int i = 0; i < 4; ++i) {
      if (is_prescribed(pull.dof[i])) lever += pull.weight[i] * moved_[f][pull.dof[i] - size_ - functions_];
    }
    if (lever == 0) continue;
    const Eigen::Index row = size_ + static_cast<Eigen::Index>(f);
    flexibility_.row(row) -= stiffness * lever * w.head(size_).transpose();
    extended_.row(row) -= stiffness * lever * elongation;
    w[row] -= stiffness * lever * own;
  }
}

bool ActiveWindow::is_supported(int bond) const {
  const std::array<int, 4>& dof = pulls_[bond].dof;
  return std::any_of(dof.begin(), dof.end(), [&](int d) { return is_prescribed(d); });
}

bool ActiveWindow::remove(std::span<const int> bonds) {
  const auto count = static_cast<Eigen::Index>(bonds.size());
  if (pending_count_ + count > most_pending) flush();
  if (count > most_pending) pending_.conservativeResize(Eigen::NoChange, count);
  const Affine before = extended_;
  const Eigen::Index pending_before = pending_count_;
  const bool functions_change = std::any_of(bonds.begin(), bonds.end(), [&](int b) { return is_supported(b); });
  Eigen::MatrixXd functions_before;
  if (functions_change) functions_before = flexibility_.bottomRows(functions_);
  // Of all bonds at once, so that what is pending is read once; every bond adds what those before it changed.
  Eigen::MatrixXd answers = responses(bonds);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (functions_change) answers.col(i) = responses(bonds.subspan(i, 1));
    if (remove_one(bonds[i], answers.col(i), functions_change ? pending_count_ : pending_before)) continue;
    extended_ = before;
    if (functions_change) flexibility_.bottomRows(functions_) = functions_before;
    pending_count_ = pending_before;
    for (int back : bonds) intact_[back] = 1;
    update_ratios();
    return false;
  }
  for (int b : bonds) left_behind_.note_break(form(pulls_[b], 1, 1), stiffness_[b]);
  update_ratios();
  return true;
}

// Of the pull's weights, those along x and y scaled.
LeftBehind::Form ActiveWindow::form(const Pull& pull, double x, double y) const {
  LeftBehind::Form result{{}, {}, Eigen::RowVector2d::Zero()};
  for (int k = 0; k < 4; ++k) {
    const int d = pull.dof[k];
    result.weight[k] = pull.weight[k] * (k % 2 == 0 ? x : y);
    result.dof[k] = is_prescribed(d) ? -1 : followed_[d];
    if (is_prescribed(d)) result.fixed += result.weight[k] * extended_.row(d);
  }
  return result;
}

LeftBehind::State ActiveWindow::state() const {
  LeftBehind::State result{Affine::Zero(kept_, 2), left_behind_.narrowings(), left_behind_.breaks()};
  result.displacement(followed_, Eigen::all) = extended_.topRows(size_);
  return result;
}

void ActiveWindow::narrow(const std::vector<char>& leaves) {
  std::vector<int> stay, left, followed_then, left_then;
  for (Eigen::Index i = 0; i < size_; ++i) {
    const bool goes = leaves[followed_[i]] != 0;
    (goes ? left : stay).push_back(static_cast<int>(i));
    (goes ? left_then : followed_then).push_back(followed_[i]);
  }
  if (left.empty()) return;
  std::vector<LeftBehind::Form> ratios;
  std::vector<char> watched(bonds_.size(), 1);
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    const std::array<int, 4>& dof = pulls_[b].dof;
    const auto goes = [&](int d) { return !is_prescribed(d) && leaves[followed_[d]]; };
    if (!intact_[b]) {
      watched[b] = 0;
    } else if (std::any_of(dof.begin(), dof.end(), goes)) {
      watched[b] = 0;
      const double scale = std::hypot(cosine_[b], sine_[b]);
      if (scale > 0) ratios.push_back(form(pulls_[b], scale, scale));
    }
  }
  left_behind_.narrow(std::move(left_then), followed_then, response_of(left, stay), state().displacement,
                      std::move(ratios));
  keep_bonds(watched);
  keep_rows(stay);
  followed_ = std::move(followed_then);
}

// Displacements of rows to forces on columns, of the present flexibility.
Eigen::MatrixXd ActiveWindow::response_of(const std::vector<int>& left, const std::vector<int>& stay) const {
  const Eigen::MatrixXd from = pending_.leftCols(pending_count_)(left, Eigen::all);
  const Eigen::MatrixXd to = pending_.leftCols(pending_count_)(stay, Eigen::all);
  Eigen::MatrixXd result = from * to.transpose();
  for (std::size_t c = 0; c < stay.size(); ++c) {
    for (std::size_t r = 0; r < left.size(); ++r) {
      const auto [column, row] = std::minmax(stay[c], left[r]);
      result(r, c) += flexibility_(row, column);
    }
  }
  return result;
}

void ActiveWindow::keep_bonds(const std::vector<char>& watched) {
  std::size_t to = 0;
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    if (!watched[b]) continue;
    bonds_[to] = bonds_[b];
    pulls_[to] = pulls_[b];
    stiffness_[to] = stiffness_[b];
    cosine_[to] = cosine_[b];
    sine_[to] = sine_[b];
    ratios_.constant[to] = ratios_.constant[b];
    ratios_.proportional[to] = ratios_.proportional[b];
    ++to;
  }
  for (std::vector<double>* list : {&stiffness_, &cosine_, &sine_, &ratios_.constant, &ratios_.proportional}) {
    list->resize(to);
  }
  bonds_.resize(to);
  pulls_.resize(to);
  intact_.assign(to, 1);
}

// Of everything per degree of freedom, these rows, and all that are not displacements followed.
void ActiveWindow::keep_rows(const std::vector<int>& stay) {
  std::vector<int> rows = stay, place(static_cast<std::size_t>(extended_.rows()), -1);
  for (Eigen::Index r = size_; r < extended_.rows(); ++r) rows.push_back(static_cast<int>(r));
  for (std::size_t r = 0; r < rows.size(); ++r) place[rows[r]] = static_cast<int>(r);
  for (Pull& pull : pulls_) {
    for (int& d : pull.dof) d = place[d];
  }
  extended_ = Affine(extended_(rows, Eigen::all));
  size_ = static_cast<Eigen::Index>(stay.size());
  rows.resize(static_cast<std::size_t>(size_ + functions_));
  pending_ = Eigen::MatrixXd(pending_(rows, Eigen::all));
  Eigen::MatrixXd smaller(size_ + functions_, size_);
  for (Eigen::Index c = 0; c < size_; ++c) {
    for (Eigen::Index r = c; r < smaller.rows(); ++r) smaller(r, c) = flexibility_(rows[r], stay[c]);
  }
  flexibility_.swap(smaller);
}

}  // namespace bempd::fracture
