#include "fracture/window/window_terms.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::fracture {

WindowTerms::WindowTerms(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                         const StretchRatios& ratios, int first_prescribed)
    : of_all_(ratios), contained_(ratios.terms().size(), 0) {
  const coupling::Terms& bonds = system.terms();
  std::vector<int> row_of(2 * static_cast<std::size_t>(system.node_count()), -1);
  for (std::size_t i = 0; i < condensation.dofs().size(); ++i) row_of[condensation.dofs()[i]] = static_cast<int>(i);
  const auto is_here = [&](int dof) { return row_of[dof] >= 0 || system.is_prescribed(dof); };
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (!system.intact()[b]) continue;
    const std::array<int, 4> dof{2 * bonds.first[b], 2 * bonds.first[b] + 1, 2 * bonds.second[b],
                                 2 * bonds.second[b] + 1};
    if (!std::all_of(dof.begin(), dof.end(), is_here)) continue;
    if (std::none_of(dof.begin(), dof.end(), [&](int d) { return system.is_unknown(d); })) continue;
    std::array<int, 4> row;
    for (int k = 0; k < 4; ++k) {
      int& place = row_of[dof[k]];
      if (place < 0) {
        place = first_prescribed + static_cast<int>(prescribed_dofs_.size());
        prescribed_dofs_.push_back(dof[k]);
      }
      row[k] = place;
    }
    add(static_cast<int>(b), system, row);
  }
  intact_.assign(size(), 1);
  ratios_.constant.assign(size(), 0.0);
  ratios_.proportional.assign(size(), 0.0);
}

void WindowTerms::add(int number, const coupling::EquilibriumSystem& system, const std::array<int, 4>& row) {
  contained_[number] = 1;
  numbers_.push_back(number);
  const double c = system.terms().cosine[number], s = system.terms().sine[number];
  pulls_.push_back({row, {-c, -s, c, s}});
  stiffness_.push_back(system.present_stiffness()[number]);
  stages_.push_back(system.stages()[number]);
  scales_.per_elongation.push_back(of_all_.scales().per_elongation[number]);
  scales_.cosine.push_back(of_all_.scales().cosine[number]);
  scales_.sine.push_back(of_all_.scales().sine[number]);
}

double WindowTerms::stiffness_after(const coupling::StageChange& change) const {
  const auto number = static_cast<std::size_t>(numbers_[change.term]);
  return of_all_.terms().law_of(number).stiffness_share(change.stage) * of_all_.terms().stiffness[number];
}

void WindowTerms::enter(const coupling::StageChange& change) {
  const auto number = static_cast<std::size_t>(numbers_[change.term]);
  const coupling::Terms& terms = of_all_.terms();
  stages_[change.term] = static_cast<std::uint8_t>(change.stage);
  intact_[change.term] = change.stage < terms.law_of(number).gone() ? 1 : 0;
  if (!intact_[change.term]) ratios_.constant[change.term] = ratios_.proportional[change.term] = 0;
  stiffness_[change.term] = stiffness_after(change);
  const double scale = 1 / (terms.length[number] * of_all_.critical_stretch(number, change.stage));
  scales_.per_elongation[change.term] = scale;
  scales_.cosine[change.term] = terms.cosine[number] * scale;
  scales_.sine[change.term] = terms.sine[number] * scale;
}

void WindowTerms::update_ratios(const coupling::Affine& rows, bool has_constant_part) {
  const auto fill = [&](int column, std::vector<double>& ratios) {
    const double* u = rows.col(column).data();
    for (std::size_t t = 0; t < size(); ++t) {
      const std::array<int, 4>& r = pulls_[t].row;
      if (!intact_[t]) continue;
      ratios[t] = coupling::along(scales_.cosine[t], scales_.sine[t], u[r[2]] - u[r[0]], u[r[3]] - u[r[1]]);
    }
  };
  if (has_constant_part) fill(0, ratios_.constant);
  fill(1, ratios_.proportional);
}

void WindowTerms::keep(const std::vector<char>& watched) {
  std::size_t to = 0;
  for (std::size_t t = 0; t < size(); ++t) {
    if (!watched[t]) continue;
    numbers_[to] = numbers_[t];
    pulls_[to] = pulls_[t];
    stiffness_[to] = stiffness_[t];
    stages_[to] = stages_[t];
    scales_.per_elongation[to] = scales_.per_elongation[t];
    scales_.cosine[to] = scales_.cosine[t];
    scales_.sine[to] = scales_.sine[t];
    ratios_.constant[to] = ratios_.constant[t];
    ratios_.proportional[to] = ratios_.proportional[t];
    ++to;
  }
  for (std::vector<double>* list : {&stiffness_, &scales_.per_elongation, &scales_.cosine, &scales_.sine,
                                    &ratios_.constant, &ratios_.proportional}) {
    list->resize(to);
  }
  stages_.resize(to);
  numbers_.resize(to);
  pulls_.resize(to);
  intact_.assign(to, 1);
}

void WindowTerms::renumber_rows(const std::vector<int>& row_after) {
  for (Pull& pull : pulls_) {
    for (int& row : pull.row) row = row_after[row];
  }
}

}  // namespace bempd::fracture
