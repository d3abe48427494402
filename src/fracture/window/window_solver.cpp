#include "fracture/window/window_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;

WindowSolver::WindowSolver(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                           const StretchRatios& ratios, const Affine& displacement,
                           const std::vector<Function>& functions)
    : kept_(static_cast<Eigen::Index>(condensation.dofs().size())),
      functions_(static_cast<Eigen::Index>(functions.size())),
      kept_dofs_(condensation.dofs()),
      followed_(condensation.dofs().size()),
      terms_(system, condensation, ratios, static_cast<int>(kept_ + functions_)),
      rows_(Affine::Zero(kept_ + functions_ + static_cast<Eigen::Index>(terms_.prescribed_dofs().size()), 2)),
      has_constant_part_(!displacement.col(0).isZero(0)),
      outside_(fracture::outside_stiffness(system, condensation, terms_)),
      flexibility_(condensation, functions_),
      row_of_(static_cast<std::size_t>(displacement.rows())) {
  std::iota(followed_.begin(), followed_.end(), 0);
  number_rows();
  rows_.topRows(kept_) = displacement(condensation.dofs(), Eigen::all);
  rows_.bottomRows(rows_.rows() - kept_ - functions_) = displacement(terms_.prescribed_dofs(), Eigen::all);
  balance_ = WindowBalance(system, condensation, terms_, rows_);
  collect_functions(condensation, functions, displacement.rows());
  update_ratios();
}

Affine WindowSolver::unbalanced() const {
  Affine rows = Affine::Zero(kept_ + rows_.rows() - size(), 2), force = Affine::Zero(kept_, 2);
  rows.topRows(kept_) = displacement();
  rows.bottomRows(rows_.rows() - size()) = rows_.bottomRows(rows_.rows() - size());
  for (int part = has_constant_part_ ? 0 : 1; part < 2; ++part)
    force.col(part) = balance_.unbalanced(rows.col(part), part, outside_);
  return force;
}

void WindowSolver::balance(Affine force) {
  Affine answer = Affine::Zero(kept_, 2);
  dropped_.hand_over(force, answer);
  for (int part = has_constant_part_ ? 0 : 1; part < 2; ++part) {
    rows_.col(part).head(size()) += answer.col(part)(followed_);
    rows_.col(part).head(size()) += flexibility_.answer(force.col(part)(followed_));
  }
  update_ratios();
}

void WindowSolver::collect_functions(const coupling::Condensation& condensation, const std::vector<Function>& functions,
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

Eigen::RowVector2d WindowSolver::elongation(const Pull& pull) const {
  Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
  for (std::size_t i = 0; i < pull.size(); ++i) sum += pull.weight[i] * rows_.row(pull.place[i]);
  return sum;
}

double WindowSolver::elongation(int bond, double load_factor) const {
  const Pull& pull = terms_.pull(bond);
  double sum = 0;
  for (std::size_t k = 0; k < pull.size(); ++k) {
    const int r = pull.place[k];
    sum += pull.weight[k] * (rows_(r, 0) + load_factor * rows_(r, 1));
  }
  return sum;
}

bool WindowSolver::lose_one(const Loss& loss, Eigen::Ref<Eigen::VectorXd> w, Eigen::Index changes_known) {
  const auto& [pull, k] = loss;
  flexibility_.update_response(pull, changes_known, w);
  double own = 0;
  for (std::size_t i = 0; i < pull.size(); ++i) {
    if (!is_prescribed(pull.place[i])) own += pull.weight[i] * w[pull.place[i]];
  }
  const Eigen::RowVector2d e = elongation(pull);
  const double pivot = 1 - k * own;
  if (!(pivot > WindowSettings::smallest_pivot)) return false;
  detach_functions(pull, k, w);
  if (has_constant_part_) rows_.col(0).head(w.size()) += (k * e[0] / pivot) * w;
  rows_.col(1).head(w.size()) += (k * e[1] / pivot) * w;
  flexibility_.add_change(std::sqrt(std::abs(k) / pivot) * w, k < 0 ? -1 : 1);
  return true;
}

// Updates the functions of a window when a term with prescribed ends (at a moving support) loses stiffness, because it
// contributed to the support's reaction and energy.
void WindowSolver::detach_functions(const Pull& pull, double stiffness, Eigen::Ref<Eigen::VectorXd> w) {
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

bool WindowSolver::is_supported(const Pull& pull) const {
  return std::any_of(pull.place.begin(), pull.place.end(), [&](int r) { return is_prescribed(r); });
}

bool WindowSolver::change(std::span<const coupling::StageChange> changes) {
  std::vector<Loss> losses;
  for (const coupling::StageChange& c : changes)
    losses.push_back({terms_.pull(static_cast<std::size_t>(c.term)), stiffness_lost(c)});
  const bool stiffens = std::any_of(losses.begin(), losses.end(), [](const Loss& loss) { return loss.stiffness < 0; });
  if (stiffens || !lose(losses)) return false;
  for (const coupling::StageChange& c : changes) terms_.enter(c);
  update_ratios();
  return true;
}

bool WindowSolver::lose(const std::vector<Loss>& losses) {
  flexibility_.make_room(static_cast<Eigen::Index>(losses.size()));
  const Affine before = rows_;
  const Eigen::Index changes_before = flexibility_.changes();
  std::vector<Pull> directions;
  bool functions_change = false;
  for (const Loss& loss : losses) {
    directions.push_back(loss.pull);
    functions_change = functions_change || is_supported(loss.pull);
  }
  Eigen::MatrixXd functions_before;
  if (functions_change) functions_before = flexibility_.function_rows();
  // Responses to all terms are computed at once, so that pending changes are read once; each term then adds the changes
  // of those before it.
  Eigen::MatrixXd answers = flexibility_.responses(directions);
  bool resisted = true;
  for (std::size_t i = 0; resisted && i < losses.size(); ++i) {
    auto answer = answers.col(static_cast<Eigen::Index>(i));
    if (functions_change) answer = flexibility_.responses({&directions[i], 1});
    resisted = lose_one(losses[i], answer, functions_change ? flexibility_.changes() : changes_before);
  }
  const auto size_of = [&](const Affine& rows) { return rows.topRows(size()).lpNorm<Eigen::Infinity>(); };
  resisted = resisted && size_of(rows_) <= WindowSettings::most_growth * size_of(before);
  if (!resisted) {
    rows_ = before;
    if (functions_change) flexibility_.set_function_rows(functions_before);
    flexibility_.take_back_changes(changes_before);
    return false;
  }
  DroppedDofs::Forms elongations;
  std::vector<double> lost;
  for (const Loss& loss : losses) {
    add_form(loss.pull, 1, elongations);
    lost.push_back(loss.stiffness);
  }
  dropped_.note_losses(elongations, lost);
  return true;
}

bool WindowSolver::follows(const coupling::Constraint& constraint) const {
  return constraint.is_on([&](int dof) { return row_of_[dof] >= 0; });
}

double WindowSolver::gap(const coupling::Constraint& constraint, double load_factor) const {
  return constraint.gap_at([&](int dof) { return rows_(row_of_[dof], 0) + load_factor * rows_(row_of_[dof], 1); });
}

double WindowSolver::gap(const coupling::Constraint& constraint, double load_factor, const Affine& kept) const {
  return constraint.gap_at([&](int dof) {
    const int r = followed_[row_of_[dof]];
    return kept(r, 0) + load_factor * kept(r, 1);
  });
}

double WindowSolver::largest_displacement(double load_factor) const {
  const auto part = [&](Eigen::Index column) { return rows_.col(column).head(size()).lpNorm<Eigen::Infinity>(); };
  return size() == 0 ? 0 : part(0) + std::abs(load_factor) * part(1);
}

bool WindowSolver::switch_constraints(std::span<const Switch> switches) {
  LinearForms pulls;
  std::vector<Loss> losses;
  for (const Switch& s : switches) {
    for (const coupling::TermEntry& e : s.constraint.pull) {
      pulls.add(row_of_[2 * e.node], e.x);
      pulls.add(row_of_[2 * e.node + 1], e.y);
    }
    pulls.close();
  }
  for (std::size_t i = 0; i < switches.size(); ++i)
    losses.push_back({pulls[i], (switches[i].closes ? -1 : 1) * switches[i].constraint.stiffness});
  if (!lose(losses)) return false;
  for (const Loss& loss : losses) {
    DroppedDofs::Forms form;
    add_form(loss.pull, 1, form);
    balance_.note_loss(form.of_displacements, loss.stiffness);
  }
  update_ratios();
  return true;
}

void WindowSolver::add_form(const Pull& pull, double scale, DroppedDofs::Forms& forms) const {
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

DroppedDofs::State WindowSolver::state() const {
  DroppedDofs::State result{Affine::Zero(kept_, 2), dropped_.narrowings(), dropped_.breaks()};
  result.displacement(followed_, Eigen::all) = rows_.topRows(size());
  return result;
}

void WindowSolver::narrow(const std::vector<char>& leaves) {
  std::vector<int> stay, left, followed_then, left_then;
  for (int i = 0; i < followed(); ++i) {
    const bool goes = leaves[followed_[i]] != 0;
    (goes ? left : stay).push_back(i);
    (goes ? left_then : followed_then).push_back(followed_[i]);
  }
  if (left.empty()) return;
  DroppedDofs::Forms ratios;
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
  dropped_.narrow(std::move(left_then), followed_then, flexibility_.block(left, stay), state().displacement, ratios);
  terms_.keep(watched);
  keep_rows(stay);
  followed_ = std::move(followed_then);
  number_rows();
}

void WindowSolver::number_rows() {
  std::fill(row_of_.begin(), row_of_.end(), -1);
  for (std::size_t i = 0; i < followed_.size(); ++i) row_of_[kept_dofs_[followed_[i]]] = static_cast<int>(i);
}

// Keeps the rows `stay` of everything that is stored by followed degrees of freedom, and all rows of functions and
// prescribed displacements.
void WindowSolver::keep_rows(const std::vector<int>& stay) {
  std::vector<int> rows = stay, place(static_cast<std::size_t>(rows_.rows()), -1);
  for (Eigen::Index r = size(); r < rows_.rows(); ++r) rows.push_back(static_cast<int>(r));
  for (std::size_t r = 0; r < rows.size(); ++r) place[rows[r]] = static_cast<int>(r);
  terms_.renumber_rows(place);
  rows_ = Affine(rows_(rows, Eigen::all));
  flexibility_.keep(stay);
}

}  // namespace bempd::fracture
