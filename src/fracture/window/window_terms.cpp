#include "fracture/window/window_terms.hpp"

#include <algorithm>
#include <cmath>

namespace bempd::fracture {

using coupling::BondSet;

WindowTerms::WindowTerms(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                         const StretchRatios& ratios, int first_prescribed)
    : contained_(ratios.bonds().size(), 0) {
  const BondSet& bonds = system.bonds();
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
    add(static_cast<int>(b), bonds, ratios, row);
  }
  intact_.assign(size(), 1);
  ratios_.constant.assign(size(), 0.0);
  ratios_.proportional.assign(size(), 0.0);
}

void WindowTerms::add(int number, const BondSet& bonds, const StretchRatios& ratios, const std::array<int, 4>& row) {
  contained_[number] = 1;
  numbers_.push_back(number);
  const double c = bonds.cosine[number], s = bonds.sine[number];
  pulls_.push_back({row, {-c, -s, c, s}});
  stiffness_.push_back(bonds.stiffness[number]);
  cosine_.push_back(ratios.directions().cosine[number]);
  sine_.push_back(ratios.directions().sine[number]);
}

double WindowTerms::ratio_per_elongation(std::size_t term) const { return std::hypot(cosine_[term], sine_[term]); }

void WindowTerms::part(int term) {
  intact_[term] = 0;
  ratios_.constant[term] = ratios_.proportional[term] = 0;
}

void WindowTerms::update_ratios(const coupling::Affine& rows, bool has_constant_part) {
  const auto fill = [&](int column, std::vector<double>& ratios) {
    const double* u = rows.col(column).data();
    for (std::size_t t = 0; t < size(); ++t) {
      const std::array<int, 4>& r = pulls_[t].row;
      if (!intact_[t]) continue;
      ratios[t] = cosine_[t] * (u[r[2]] - u[r[0]]) + sine_[t] * (u[r[3]] - u[r[1]]);
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
    cosine_[to] = cosine_[t];
    sine_[to] = sine_[t];
    ratios_.constant[to] = ratios_.constant[t];
    ratios_.proportional[to] = ratios_.proportional[t];
    ++to;
  }
  for (std::vector<double>* list : {&stiffness_, &cosine_, &sine_, &ratios_.constant, &ratios_.proportional}) {
    list->resize(to);
  }
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
