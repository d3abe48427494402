#include "fracture/window/window_terms.hpp"

#include <algorithm>

namespace bempd::fracture {

WindowTerms::WindowTerms(const coupling::EquilibriumSystem& system, const coupling::Condensation& condensation,
                         const StretchRatios& ratios, int first_prescribed)
    : of_all_(ratios), contained_(ratios.terms().size(), 0) {
  const coupling::Terms& terms = system.terms();
  std::vector<int> row_of(2 * static_cast<std::size_t>(system.node_count()), -1);
  for (std::size_t i = 0; i < condensation.dofs().size(); ++i) row_of[condensation.dofs()[i]] = static_cast<int>(i);
  const auto row = [&](int dof) {
    int& place = row_of[dof];
    if (place < 0) {
      place = first_prescribed + static_cast<int>(prescribed_dofs_.size());
      prescribed_dofs_.push_back(dof);
    }
    return place;
  };
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!system.stages().intact()[t]) continue;
    bool is_here = true, has_unknown = false;
    terms.for_each_node(t, [&](int node) {
      for (int dof = 2 * node; dof < 2 * node + 2; ++dof) {
        is_here = is_here && (row_of[dof] >= 0 || system.unknowns().is_prescribed(dof));
        has_unknown = has_unknown || system.unknowns().is_unknown(dof);
      }
    });
    if (!is_here || !has_unknown) continue;
    terms.for_each_entry(t, [&](int node, double x, double y) {
      pulls_.add(row(2 * node), x);
      pulls_.add(row(2 * node + 1), y);
    });
    pulls_.close();
    add(static_cast<int>(t), system);
  }
  intact_.assign(size(), 1);
  ratios_.constant.assign(size(), 0.0);
  ratios_.proportional.assign(size(), 0.0);
  across_ = ratios.across().chosen(
      numbers_, [&](int number) { return place_of(number); },
      [&](int number) { return system.stages().intact()[number] != 0; });
}

void WindowTerms::add(int number, const coupling::EquilibriumSystem& system) {
  contained_[number] = 1;
  numbers_.push_back(number);
  stiffness_.push_back(system.stages().stiffness()[number]);
  stages_.push_back(system.stages().numbers()[number]);
  scales_.per_elongation.push_back(of_all_.scales().per_elongation[number]);
  scales_.cosine.push_back(of_all_.scales().cosine[number]);
  scales_.sine.push_back(of_all_.scales().sine[number]);
}

int WindowTerms::place_of(int number) const {
  const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), number);
  return found != numbers_.end() && *found == number ? static_cast<int>(found - numbers_.begin()) : -1;
}

double WindowTerms::stiffness_after(const coupling::StageChange& change) const {
  const auto number = static_cast<std::size_t>(numbers_[change.term]);
  return of_all_.terms().law_of(number).stiffness_share(change.stage) * of_all_.terms().stiffness[number];
}

void WindowTerms::enter(const coupling::StageChange& change) {
  const auto number = static_cast<std::size_t>(numbers_[change.term]);
  const coupling::Terms& terms = of_all_.terms();
  stages_[change.term] = static_cast<std::uint8_t>(change.stage);
  intact_[change.term] = terms.is_broken(number, change.stage) ? 0 : 1;
  if (!intact_[change.term]) ratios_.constant[change.term] = ratios_.proportional[change.term] = 0;
  stiffness_[change.term] = stiffness_after(change);
  scales_.set(static_cast<std::size_t>(change.term), terms, number, of_all_.critical_stretch(number, change.stage));
}

void WindowTerms::update_ratios(const coupling::Affine& rows, bool has_constant_part) {
  const auto fill = [&](int column, std::vector<double>& ratios) {
    const double* u = rows.col(column).data();
    for (std::size_t t = 0; t < size(); ++t) {
      if (!intact_[t] || scales_.per_elongation[t] == 0) continue;
      const Pull pull = pulls_[t];
      if (scales_.cosine[t] != 0 || scales_.sine[t] != 0) {
        const int* r = pull.place.data();
        ratios[t] = elongation_along(scales_.cosine[t], scales_.sine[t], u[r[2]] - u[r[0]], u[r[3]] - u[r[1]]);
        continue;
      }
      double elongation = 0;
      for (std::size_t k = 0; k < pull.size(); ++k) elongation += pull.weight[k] * u[pull.place[k]];
      ratios[t] = scales_.per_elongation[t] * elongation;
    }
  };
  if (has_constant_part) fill(0, ratios_.constant);
  fill(1, ratios_.proportional);
  relieve();
}

void WindowTerms::relieve() {
  if (!across_.empty())
    across_.relieve(ratios_.constant, ratios_.proportional, scales_.per_elongation, intact_, ratios_.relief);
}

void WindowTerms::keep(const std::vector<char>& watched) {
  if (!across_.empty()) {
    std::vector<int> kept, place_after(size(), -1);
    for (std::size_t t = 0; t < size(); ++t) {
      if (!watched[t]) continue;
      place_after[t] = static_cast<int>(kept.size());
      kept.push_back(static_cast<int>(t));
    }
    across_ = across_.chosen(
        kept, [&](int place) { return place_after[place]; }, [&](int place) { return intact_[place] != 0; });
  }
  pulls_.keep(watched);
  std::size_t to = 0;
  for (std::size_t t = 0; t < size(); ++t) {
    if (!watched[t]) continue;
    numbers_[to] = numbers_[t];
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
  intact_.assign(to, 1);
  relieve();
}

void WindowTerms::renumber_rows(const std::vector<int>& row_after) { pulls_.renumber(row_after); }

}  // namespace bempd::fracture
