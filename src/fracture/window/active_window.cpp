#include "fracture/window/active_window.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;

ActiveWindow::ActiveWindow(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                           const StretchRatios& ratios, const Affine& displacement,
                           const std::vector<Function>& functions)
    : kept_(static_cast<Eigen::Index>(condensation.dofs().size())),
      functions_(static_cast<Eigen::Index>(functions.size())),
      followed_(condensation.dofs().size()),
      terms_(system, condensation, ratios, static_cast<int>(kept_ + functions_)),
      rows_(Affine::Zero(kept_ + functions_ + static_cast<Eigen::Index>(terms_.prescribed_dofs().size()), 2)),
      has_constant_part_(!displacement.col(0).isZero(0)),
      outside_(fracture::outside_stiffness(system, condensation, terms_)),
      flexibility_(condensation, functions_) {
  std::iota(followed_.begin(), followed_.end(), 0);
  rows_.topRows(kept_) = displacement(condensation.dofs(), Eigen::all);
  rows_.bottomRows(rows_.rows() - kept_ - functions_) = displacement(terms_.prescribed_dofs(), Eigen::all);
  collect_functions(condensation, functions, displacement.rows());
  update_ratios();
}

void ActiveWindow::collect_functions(const coupling::Condensation& condensation, const std::vector<Function>& functions,
                                     Eigen::Index dofs) {
  if (functions.empty()) return;
  Eigen::MatrixXd weights(dofs, functions_), kept_weights(kept_, functions_);
  for (Eigen::Index k = 0; k < functions_; ++k) weights.col(k) = functions[static_cast<std::size_t>(k)].weights;
  Eigen::Index k = 0;
  for (const coupling::CondensedFunction& f : condensation.condense(weights)) {
    kept_weights.col(k) = f.weights;
    rows_.row(kept_ + k++) = f.constant + f.weights.transpose() * rows_.topRows(kept_);
  }
  flexibility_.set_functions(kept_weights);
  for (const Function& f : functions) {
    moved_.push_back(f.moved.size() == 0 ? Eigen::VectorXd() : Eigen::VectorXd(f.moved(terms_.prescribed_dofs())));
  }
}

Eigen::RowVector2d ActiveWindow::elongation(const Pull& pull) const {
  Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
  for (int i = 0; i < 4; ++i) sum += pull.weight[i] * rows_.row(pull.row[i]);
  return sum;
}

double ActiveWindow::elongation(int bond, double load_factor) const {
  const Pull& pull = terms_.pull(bond);
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const int r = pull.row[k];
    sum += pull.weight[k] * (rows_(r, 0) + load_factor * rows_(r, 1));
  }
  return sum;
}

std::vector<Pull> ActiveWindow::pulls(std::span<const int> bonds) const {
  std::vector<Pull> result;
  for (int b : bonds) result.push_back(terms_.pull(b));
  return result;
}

bool ActiveWindow::remove_one(int bond, Eigen::Ref<Eigen::VectorXd> w, Eigen::Index changes_known) {
  const Pull& pull = terms_.pull(bond);
  const double k = terms_.stiffness(bond);
  flexibility_.update_response(pull, changes_known, w);
  double own = 0;
  for (int i = 0; i < 4; ++i) {
    if (!is_prescribed(pull.row[i])) own += pull.weight[i] * w[pull.row[i]];
  }
  const Eigen::RowVector2d e = elongation(pull);
  const double pivot = 1 - k * own;
  if (!(pivot > WindowSettings::smallest_pivot)) return false;
  detach_functions(pull, k, w);
  if (has_constant_part_) rows_.col(0).head(w.size()) += (k * e[0] / pivot) * w;
  rows_.col(1).head(w.size()) += (k * e[1] / pivot) * w;
  flexibility_.add_change(std::sqrt(k / pivot) * w);
  terms_.part(bond);
  return true;
}

// A bond to a moving support took part in what the support feels.
void ActiveWindow::detach_functions(const Pull& pull, double stiffness, Eigen::Ref<Eigen::VectorXd> w) {
  if (std::none_of(pull.row.begin(), pull.row.end(), [&](int r) { return is_prescribed(r); })) return;
  double own = 0;
  for (int i = 0; i < 4; ++i) {
    if (!is_prescribed(pull.row[i])) own += pull.weight[i] * w[pull.row[i]];
  }
  const Eigen::RowVector2d e = elongation(pull);
  for (std::size_t f = 0; f < moved_.size(); ++f) {
    if (moved_[f].size() == 0) continue;
    double lever = 0;
    for (int i = 0; i < 4; ++i) {
      if (is_prescribed(pull.row[i])) lever += pull.weight[i] * moved_[f][pull.row[i] - size() - functions_];
    }
    if (lever == 0) continue;
    const Eigen::Index row = size() + static_cast<Eigen::Index>(f);
    flexibility_.subtract_from_function(static_cast<Eigen::Index>(f), stiffness * lever * w.head(size()));
    rows_.row(row) -= stiffness * lever * e;
    w[row] -= stiffness * lever * own;
  }
}

bool ActiveWindow::is_supported(int bond) const {
  const std::array<int, 4>& row = terms_.pull(bond).row;
  return std::any_of(row.begin(), row.end(), [&](int r) { return is_prescribed(r); });
}

bool ActiveWindow::remove(std::span<const int> bonds) {
  flexibility_.make_room(static_cast<Eigen::Index>(bonds.size()));
  const Affine before = rows_;
  const Eigen::Index changes_before = flexibility_.changes();
  const bool functions_change = std::any_of(bonds.begin(), bonds.end(), [&](int b) { return is_supported(b); });
  Eigen::MatrixXd functions_before;
  if (functions_change) functions_before = flexibility_.function_rows();
  // Of all bonds at once, so that what is pending is read once; every bond adds what those before it changed.
  const std::vector<Pull> directions = pulls(bonds);
  Eigen::MatrixXd answers = flexibility_.responses(directions);
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    auto answer = answers.col(static_cast<Eigen::Index>(i));
    if (functions_change) answer = flexibility_.responses({&directions[i], 1});
    if (remove_one(bonds[i], answer, functions_change ? flexibility_.changes() : changes_before)) continue;
    rows_ = before;
    if (functions_change) flexibility_.set_function_rows(functions_before);
    flexibility_.take_back_changes(changes_before);
    for (int back : bonds) terms_.mend(back);
    update_ratios();
    return false;
  }
  for (int b : bonds) left_behind_.note_break(form(terms_.pull(b), 1), terms_.stiffness(b));
  update_ratios();
  return true;
}

LeftBehind::Form ActiveWindow::form(const Pull& pull, double scale) const {
  LeftBehind::Form result{{}, {}, Eigen::RowVector2d::Zero()};
  for (int k = 0; k < 4; ++k) {
    const int r = pull.row[k];
    result.weight[k] = pull.weight[k] * scale;
    result.dof[k] = is_prescribed(r) ? -1 : followed_[r];
    if (is_prescribed(r)) result.fixed += result.weight[k] * rows_.row(r);
  }
  return result;
}

LeftBehind::State ActiveWindow::state() const {
  LeftBehind::State result{Affine::Zero(kept_, 2), left_behind_.narrowings(), left_behind_.breaks()};
  result.displacement(followed_, Eigen::all) = rows_.topRows(size());
  return result;
}

void ActiveWindow::narrow(const std::vector<char>& leaves) {
  std::vector<int> stay, left, followed_then, left_then;
  for (int i = 0; i < followed(); ++i) {
    const bool goes = leaves[followed_[i]] != 0;
    (goes ? left : stay).push_back(i);
    (goes ? left_then : followed_then).push_back(followed_[i]);
  }
  if (left.empty()) return;
  std::vector<LeftBehind::Form> ratios;
  std::vector<char> watched(terms_.size(), 1);
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const std::array<int, 4>& row = terms_.pull(t).row;
    const auto goes = [&](int r) { return !is_prescribed(r) && leaves[followed_[r]]; };
    if (!terms_.intact()[t]) {
      watched[t] = 0;
    } else if (std::any_of(row.begin(), row.end(), goes)) {
      watched[t] = 0;
      const double scale = terms_.ratio_per_elongation(t);
      if (scale > 0) ratios.push_back(form(terms_.pull(t), scale));
    }
  }
  left_behind_.narrow(std::move(left_then), followed_then, flexibility_.block(left, stay), state().displacement,
                      std::move(ratios));
  terms_.keep(watched);
  keep_rows(stay);
  followed_ = std::move(followed_then);
}

// Of everything per degree of freedom, these rows, and all that are not displacements followed.
void ActiveWindow::keep_rows(const std::vector<int>& stay) {
  std::vector<int> rows = stay, place(static_cast<std::size_t>(rows_.rows()), -1);
  for (Eigen::Index r = size(); r < rows_.rows(); ++r) rows.push_back(static_cast<int>(r));
  for (std::size_t r = 0; r < rows.size(); ++r) place[rows[r]] = static_cast<int>(r);
  terms_.renumber_rows(place);
  rows_ = Affine(rows_(rows, Eigen::all));
  flexibility_.keep(stay);
}

}  // namespace bempd::fracture
