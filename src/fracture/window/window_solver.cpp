#include "fracture/window/window_solver.hpp"

#include <algorithm>
#include <cmath>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;

WindowSolver::WindowSolver(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                           const StretchRatios& ratios, const Affine& displacement,
                           const std::vector<Function>& functions)
    : kept_(static_cast<Eigen::Index>(condensation.dofs().size())),
      functions_(static_cast<Eigen::Index>(functions.size())),
      terms_(system, condensation, ratios, static_cast<int>(kept_ + functions_)),
      rows_(condensation.dofs(), functions_, terms_.prescribed_dofs(), displacement),
      has_constant_part_(!displacement.col(0).isZero(0)),
      outside_(fracture::outside_stiffness(system, condensation, terms_)),
      flexibility_(condensation, functions_) {
  balance_ = WindowBalance(system, condensation, terms_, rows_.values());
  collect_functions(condensation, functions, displacement.rows());
  update_ratios();
}

Affine WindowSolver::unbalanced() const {
  const Eigen::Index others = rows_.values().rows() - size();  // functions and prescribed displacements
  Affine rows = Affine::Zero(kept_ + others, 2), force = Affine::Zero(kept_, 2);
  rows.topRows(kept_) = displacement();
  rows.bottomRows(others) = rows_.values().bottomRows(others);
  for (int part = has_constant_part_ ? 0 : 1; part < 2; ++part)
    force.col(part) = balance_.unbalanced(rows.col(part), part, outside_);
  return force;
}

void WindowSolver::balance(Affine force) {
  Affine answer = Affine::Zero(kept_, 2);
  dropped_.transfer_forces(force, answer);
  for (int part = has_constant_part_ ? 0 : 1; part < 2; ++part) {
    rows_.values().col(part).head(size()) += answer.col(part)(rows_.followed());
    rows_.values().col(part).head(size()) += flexibility_.answer(force.col(part)(rows_.followed()));
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
    rows_.values().row(kept_ + k++) = f.constant + f.weights.transpose() * rows_.displacements();
  }
  flexibility_.set_functions(kept_weights);
  for (const Function& f : functions) {
    moved_.push_back(f.moved.size() == 0 ? Eigen::VectorXd() : Eigen::VectorXd(f.moved(terms_.prescribed_dofs())));
  }
}

bool WindowSolver::lose_one(const Loss& loss, Eigen::Ref<Eigen::VectorXd> w, Eigen::Index changes_known) {
  const auto& [pull, k] = loss;
  flexibility_.update_response(pull, changes_known, w);
  double own = 0;
  for (std::size_t i = 0; i < pull.size(); ++i) {
    if (!rows_.is_prescribed(pull.place[i])) own += pull.weight[i] * w[pull.place[i]];
  }
  const Eigen::RowVector2d e = rows_.elongation(pull);
  const double pivot = 1 - k * own;
  if (!(pivot > WindowSettings::smallest_pivot)) return false;
  detach_functions(pull, k, w);
  if (has_constant_part_) rows_.values().col(0).head(w.size()) += (k * e[0] / pivot) * w;
  rows_.values().col(1).head(w.size()) += (k * e[1] / pivot) * w;
  flexibility_.add_change(std::sqrt(std::abs(k) / pivot) * w, k < 0 ? -1 : 1);
  return true;
}

// Updates the functions of a window (reactions and energies) when a term with an end at a moving support loses
// stiffness, because the term contributed to the reaction and the energy of the support.
void WindowSolver::detach_functions(const Pull& pull, double stiffness, Eigen::Ref<Eigen::VectorXd> w) {
  if (!rows_.is_supported(pull)) return;
  double own = 0;
  for (std::size_t i = 0; i < pull.size(); ++i) {
    if (!rows_.is_prescribed(pull.place[i])) own += pull.weight[i] * w[pull.place[i]];
  }
  const Eigen::RowVector2d e = rows_.elongation(pull);
  for (std::size_t f = 0; f < moved_.size(); ++f) {
    if (moved_[f].size() == 0) continue;
    double lever = 0;
    for (std::size_t i = 0; i < pull.size(); ++i) {
      if (rows_.is_prescribed(pull.place[i])) lever += pull.weight[i] * moved_[f][pull.place[i] - size() - functions_];
    }
    if (lever == 0) continue;
    const Eigen::Index row = size() + static_cast<Eigen::Index>(f);
    flexibility_.subtract_from_function(static_cast<Eigen::Index>(f), stiffness * lever * w.head(size()));
    rows_.values().row(row) -= stiffness * lever * e;
    w[row] -= stiffness * lever * own;
  }
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
  const Affine before = rows_.values();
  const Eigen::Index changes_before = flexibility_.changes();
  std::vector<Pull> directions;
  bool functions_change = false;
  for (const Loss& loss : losses) {
    directions.push_back(loss.pull);
    functions_change = functions_change || rows_.is_supported(loss.pull);
  }
  Eigen::MatrixXd functions_before;
  if (functions_change) functions_before = flexibility_.function_rows();
  // The responses to all losses are computed at once, so that the pending changes are read only once. lose_one() then
  // adds to each response the changes by the losses before.
  Eigen::MatrixXd answers = flexibility_.responses(directions);
  bool resisted = true;
  for (std::size_t i = 0; resisted && i < losses.size(); ++i) {
    auto answer = answers.col(static_cast<Eigen::Index>(i));
    if (functions_change) answer = flexibility_.responses({&directions[i], 1});
    resisted = lose_one(losses[i], answer, functions_change ? flexibility_.changes() : changes_before);
  }
  const auto size_of = [&](const Affine& rows) { return rows.topRows(size()).lpNorm<Eigen::Infinity>(); };
  resisted = resisted && size_of(rows_.values()) <= WindowSettings::most_growth * size_of(before);
  if (!resisted) {
    rows_.values() = before;
    if (functions_change) flexibility_.set_function_rows(functions_before);
    flexibility_.take_back_changes(changes_before);
    return false;
  }
  DroppedDofs::Forms elongations;
  std::vector<double> lost;
  for (const Loss& loss : losses) {
    rows_.add_form(loss.pull, 1, elongations);
    lost.push_back(loss.stiffness);
  }
  dropped_.note_lost_stiffness(elongations, lost);
  return true;
}

bool WindowSolver::switch_constraints(std::span<const Switch> switches) {
  LinearForms pulls;
  std::vector<Loss> losses;
  for (const Switch& s : switches) {
    for (const coupling::TermEntry& e : s.constraint.pull) {
      pulls.add(rows_.row_of(2 * e.node), e.x);
      pulls.add(rows_.row_of(2 * e.node + 1), e.y);
    }
    pulls.close();
  }
  for (std::size_t i = 0; i < switches.size(); ++i)
    losses.push_back({pulls[i], (switches[i].closes ? -1 : 1) * switches[i].constraint.stiffness});
  if (!lose(losses)) return false;
  for (const Loss& loss : losses) {
    DroppedDofs::Forms form;
    rows_.add_form(loss.pull, 1, form);
    balance_.note_loss(form.of_displacements, loss.stiffness);
  }
  update_ratios();
  return true;
}

DroppedDofs::State WindowSolver::state() const {
  DroppedDofs::State result{Affine::Zero(kept_, 2), dropped_.narrowings(), dropped_.breaks()};
  result.displacement(rows_.followed(), Eigen::all) = rows_.displacements();
  return result;
}

void WindowSolver::narrow(const std::vector<char>& leaves) {
  std::vector<int> kept_rows, dropped_rows, followed_dofs, dropped_dofs;
  for (int i = 0; i < followed(); ++i) {
    const int kept = rows_.followed()[i];
    const bool goes = leaves[kept] != 0;
    (goes ? dropped_rows : kept_rows).push_back(i);
    (goes ? dropped_dofs : followed_dofs).push_back(kept);
  }
  if (dropped_rows.empty()) return;
  DroppedDofs::Forms ratios;
  std::vector<char> watched(terms_.size(), 1);
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const std::span<const int> row = terms_.pull(t).place;
    const auto goes = [&](int r) { return !rows_.is_prescribed(r) && leaves[rows_.followed()[r]]; };
    if (!terms_.intact()[t]) {
      watched[t] = 0;
    } else if (std::any_of(row.begin(), row.end(), goes)) {
      watched[t] = 0;
      const double scale = terms_.ratio_per_elongation(t);
      if (scale > 0) rows_.add_form(terms_.pull(t), scale, ratios);
    }
  }
  dropped_.narrow(std::move(dropped_dofs), followed_dofs, flexibility_.block(dropped_rows, kept_rows),
                  state().displacement, ratios);
  terms_.keep(watched);
  terms_.renumber_rows(rows_.keep(kept_rows));
  flexibility_.keep(kept_rows);
}

}  // namespace bempd::fracture
