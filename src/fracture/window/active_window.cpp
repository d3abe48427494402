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
  for (std::size_t i = 0; i < pull.size(); ++i) sum += pull.weight[i] * rows_.row(pull.place[i]);
  return sum;
}

double ActiveWindow::elongation(int bond, double load_factor) const {
  const Pull& pull = terms_.pull(bond);
  double sum = 0;
  for (std::size_t k = 0; k < pull.size(); ++k) {
    const int r = pull.place[k];
    sum += pull.weight[k] * (rows_(r, 0) + load_factor * rows_(r, 1));
  }
  return sum;
}

bool ActiveWindow::change_one(const coupling::StageChange& change, Eigen::Ref<Eigen::VectorXd> w,
                              Eigen::Index changes_known) {
  const Pull& pull = terms_.pull(static_cast<std::size_t>(change.term));
  const double k = stiffness_lost(change);
  flexibility_.update_response(pull, changes_known, w);
  double own = 0;
  for (std::size_t i = 0; i < pull.size(); ++i) {
    if (!is_prescribed(pull.place[i])) own += pull.weight[i] * w[pull.place[i]];
  }
  const Eigen::RowVector2d e = elongation(pull);
  const double pivot = 1 - k * own;
  if (k < 0 || !(pivot > WindowSettings::smallest_pivot)) return false;
  detach_functions(pull, k, w);
  if (has_constant_part_) rows_.col(0).head(w.size()) += (k * e[0] / pivot) * w;
  rows_.col(1).head(w.size()) += (k * e[1] / pivot) * w;
  flexibility_.add_change(std::sqrt(k / pivot) * w);
  terms_.enter(change);
  return true;
}

// A bond to a moving support took part in what the support feels.
void ActiveWindow::detach_functions(const Pull& pull, double stiffness, Eigen::Ref<Eigen::VectorXd> w) {
  if (std::none_of(pull.place.begin(), pull.place.end(), [&](int r) { return is_prescribed(r); })) return;
  double own = 0;
  for (std::size_t i = 0; i < pull.size(); ++i) {
    if (!is_prescribed(pull.place[i])) own += pull.weight[i] * w[pull.place[i]];
  }
  const Eigen::RowVector2d e = elongation(pull);
  for (std::size_t f = 0; f < moved_.size(); ++f) {
    if (moved_[f].size() == 0) continue;
    double lever = 0;
    for (std::size_t i = 0; i < pull.size(); ++i) {
      if (is_prescribed(pull.place[i])) lever += pull.weight[i] * moved_[f][pull.place[i] - size() - functions_];
    }
    if (lever == 0) continue;
    const Eigen::Index row = size() + static_cast<Eigen::Index>(f);
    flexibility_.subtract_from_function(static_cast<Eigen::Index>(f), stiffness * lever * w.head(size()));
    rows_.row(row) -= stiffness * lever * e;
    w[row] -= stiffness * lever * own;
  }
}

bool ActiveWindow::is_supported(int bond) const {
  const std::span<const int> row = terms_.pull(bond).place;
  return std::any_of(row.begin(), row.end(), [&](int r) { return is_prescribed(r); });
}

bool ActiveWindow::change(std::span<const coupling::StageChange> changes) {
  flexibility_.make_room(static_cast<Eigen::Index>(changes.size()));
  const Affine before = rows_;
  const Eigen::Index changes_before = flexibility_.changes();
  std::vector<coupling::StageChange> back;
  std::vector<double> lost;
  std::vector<Pull> directions;
  bool functions_change = false;
  for (const coupling::StageChange& c : changes) {
    back.push_back({c.term, terms_.stage(static_cast<std::size_t>(c.term))});
    lost.push_back(stiffness_lost(c));
    directions.push_back(terms_.pull(static_cast<std::size_t>(c.term)));
    functions_change = functions_change || is_supported(c.term);
  }
  Eigen::MatrixXd functions_before;
  if (functions_change) functions_before = flexibility_.function_rows();
  // Of all terms at once, so that what is pending is read once; every term adds what those before it changed.
  Eigen::MatrixXd answers = flexibility_.responses(directions);
  bool resisted = true;
  for (std::size_t i = 0; resisted && i < changes.size(); ++i) {
    auto answer = answers.col(static_cast<Eigen::Index>(i));
    if (functions_change) answer = flexibility_.responses({&directions[i], 1});
    resisted = change_one(changes[i], answer, functions_change ? flexibility_.changes() : changes_before);
  }
  const auto size_of = [&](const Affine& rows) { return rows.topRows(size()).lpNorm<Eigen::Infinity>(); };
  resisted = resisted && size_of(rows_) <= WindowSettings::most_growth * size_of(before);
  if (!resisted) {
    rows_ = before;
    if (functions_change) flexibility_.set_function_rows(functions_before);
    flexibility_.take_back_changes(changes_before);
    for (const coupling::StageChange& c : back) terms_.enter(c);
    update_ratios();
    return false;
  }
  LeftBehind::Forms elongations;
  for (const Pull& direction : directions) add_form(direction, 1, elongations);
  left_behind_.note_losses(elongations, lost);
  update_ratios();
  return true;
}

void ActiveWindow::add_form(const Pull& pull, double scale, LeftBehind::Forms& forms) const {
  Eigen::RowVector2d fixed = Eigen::RowVector2d::Zero();
  for (std::size_t k = 0; k < pull.size(); ++k) {
    const int r = pull.place[k];
    const double weight = pull.weight[k] * scale;
    if (is_prescribed(r)) {
      fixed += weight * rows_.row(r);
    } else {
      forms.of_displacements.add(followed_[r], weight);
    }
  }
  forms.of_displacements.close();
  forms.fixed.push_back(fixed);
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
  LeftBehind::Forms ratios;
  std::vector<char> watched(terms_.size(), 1);
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const std::span<const int> row = terms_.pull(t).place;
    const auto goes = [&](int r) { return !is_prescribed(r) && leaves[followed_[r]]; };
    if (!terms_.intact()[t]) {
      watched[t] = 0;
    } else if (std::any_of(row.begin(), row.end(), goes)) {
      watched[t] = 0;
      const double scale = terms_.ratio_per_elongation(t);
      if (scale > 0) add_form(terms_.pull(t), scale, ratios);
    }
  }
  left_behind_.narrow(std::move(left_then), followed_then, flexibility_.block(left, stay), state().displacement,
                      ratios);
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
