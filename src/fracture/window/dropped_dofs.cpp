#include "fracture/window/dropped_dofs.hpp"

#include <algorithm>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;

namespace {

void append(const DroppedDofs::Forms& forms, DroppedDofs::Forms& to) {
  to.of_displacements.append(forms.of_displacements);
  to.fixed.insert(to.fixed.end(), forms.fixed.begin(), forms.fixed.end());
}

}  // namespace

void DroppedDofs::narrow(std::vector<int> dropped, const std::vector<int>& followed, Eigen::MatrixXd response,
                         const Affine& displacement, const Forms& ratios) {
  Level level{std::move(dropped), std::vector<int>(displacement.rows(), -1), std::move(response), {}, breaks()};
  for (std::size_t i = 0; i < followed.size(); ++i) level.column_of[followed[i]] = static_cast<int>(i);
  level.start = displacement(level.dropped, Eigen::all);
  levels_.push_back(std::move(level));
  append(ratios, ratios_);
}

void DroppedDofs::note_lost_stiffness(const Forms& elongations, const std::vector<double>& stiffnesses) {
  append(elongations, broken_);
  lost_.insert(lost_.end(), stiffnesses.begin(), stiffnesses.end());
}

std::vector<Affine> DroppedDofs::complete(const std::vector<State>& states, bool has_constant_part) const {
  std::vector<Affine> result;
  result.reserve(states.size());
  for (const State& state : states) result.push_back(state.displacement);
  const int first_part = has_constant_part ? 0 : 1, parts = 2 - first_part;
  // Degrees of freedom that were dropped last are completed first. The forces on those dropped earlier follow from
  // bonds that broke in between, and these bonds may end on degrees of freedom dropped later.
  for (std::size_t l = levels_.size(); l-- > 0;) {
    const Level& level = levels_[l];
    std::vector<std::size_t> later;
    for (std::size_t s = 0; s < states.size(); ++s) {
      if (states[s].narrowings > l) later.push_back(s);
    }
    const auto columns = parts * static_cast<Eigen::Index>(later.size());
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero(level.response.cols(), columns);
    for (Eigen::Index c = 0; c < columns; ++c) {
      const State& state = states[later[c / parts]];
      const Eigen::Index part = first_part + c % parts;
      const double* u = result[later[c / parts]].col(part).data();
      for (std::size_t b = level.breaks_before; b < state.breaks; ++b) {
        const LinearForms::Form form = broken_.of_displacements[b];
        double elongation = broken_.fixed[b][part];
        for (std::size_t k = 0; k < form.size(); ++k) elongation += form.weight[k] * u[form.place[k]];
        for (std::size_t k = 0; k < form.size(); ++k)
          pull(level.column_of[form.place[k]], c) += lost_[b] * elongation * form.weight[k];
      }
    }
    const Eigen::MatrixXd change = level.response * pull;
    for (Eigen::Index c = 0; c < columns; ++c) {
      const Eigen::Index part = first_part + c % parts;
      result[later[c / parts]].col(part)(level.dropped) = level.start.col(part) + change.col(c);
    }
  }
  return result;
}

// Transfers forces on dropped degrees of freedom (index l) to those that the window followed after the drop (index f).
// Let F0 be the flexibility at the drop, F the present one, and P = sum of k b b^T over the terms with the elongation
// b.u that have lost the stiffness k since. P acts on degrees of freedom f only, so F = F0 + F P F0. With y = F0_fl
// r_l, a force r_l therefore causes the displacements
//   F_fl r_l = y + F_ff P y.
void DroppedDofs::transfer_forces(Affine& force, Affine& answer) const {
  for (const Level& level : levels_) {
    const Affine y = level.response.transpose() * force(level.dropped, Eigen::all);
    for (std::size_t dof = 0; dof < level.column_of.size(); ++dof) {
      if (level.column_of[dof] >= 0) answer.row(static_cast<Eigen::Index>(dof)) += y.row(level.column_of[dof]);
    }
    for (std::size_t b = level.breaks_before; b < breaks(); ++b) {
      const LinearForms::Form form = broken_.of_displacements[b];
      Eigen::RowVector2d elongation = Eigen::RowVector2d::Zero();
      for (std::size_t k = 0; k < form.size(); ++k)
        elongation += form.weight[k] * y.row(level.column_of[form.place[k]]);
      for (std::size_t k = 0; k < form.size(); ++k) force.row(form.place[k]) += lost_[b] * form.weight[k] * elongation;
    }
  }
}

int DroppedDofs::first_violation(const std::vector<Affine>& states, const std::vector<OutsideCheck>& checks) const {
  // States are treated in batches, so that the numbers of a bond's degrees of freedom are read once for all states of a
  // batch.
  constexpr Eigen::Index batch = WindowSettings::states_swept_at_once;
  using Batch = Eigen::Array<double, batch, 1>;
  if (ratios_.fixed.empty() || checks.empty()) return static_cast<int>(states.size());
  Eigen::Array<double, batch, Eigen::Dynamic> u;
  for (std::size_t begin = 0; begin < checks.size(); begin += batch) {
    const std::size_t end = std::min(checks.size(), begin + batch);
    u.setZero(batch, states.front().rows());
    Batch load_factor = Batch::Zero();
    for (std::size_t c = begin; c < end; ++c) {
      const Affine& state = states[checks[c].state];
      const auto row = static_cast<Eigen::Index>(c - begin);
      load_factor[row] = checks[c].load_factor;
      u.row(row) = (state.col(0) + load_factor[row] * state.col(1)).transpose();
    }
    Batch largest = Batch::Zero();
    for (std::size_t r = 0; r < ratios_.fixed.size(); ++r) {
      const LinearForms::Form form = ratios_.of_displacements[r];
      Batch ratio = ratios_.fixed[r][0] + ratios_.fixed[r][1] * load_factor;
      for (std::size_t k = 0; k < form.size(); ++k) ratio += form.weight[k] * u.col(form.place[k]);
      largest = largest.max(ratio);
    }
    for (std::size_t c = begin; c < end; ++c) {
      const bool holds = largest[static_cast<Eigen::Index>(c - begin)] < checks[c].limit_less_rounding();
      if (!holds) return checks[c].state;
    }
  }
  return static_cast<int>(states.size());
}

}  // namespace bempd::fracture
