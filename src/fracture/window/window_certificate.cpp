#include "fracture/window/window_certificate.hpp"

#include <algorithm>
#include <cmath>

#include "cancellation.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

using coupling::Affine;

WindowCertificate::WindowCertificate(const coupling::EquilibriumSystem& system,
                                     const coupling::Condensation& condensation, const WindowSolver& window,
                                     const StretchRatios& ratios, bool proportional)
    : condensation_(condensation), window_(window), proportional_(proportional) {
  collect_bonds(system, ratios);
  rounding_ = WindowSettings::energy_rounding * window.outside_stiffness().diagonal().lpNorm<Eigen::Infinity>();
}

void WindowCertificate::collect_bonds(const coupling::EquilibriumSystem& system, const StretchRatios& ratios) {
  const coupling::Terms& bonds = system.terms();
  std::vector<double> compliance;
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const double scale = ratios.scales().per_elongation[b];
    if (!system.stages().intact()[b] || window_.contains(static_cast<int>(b)) || scale == 0)
      continue;  // bonds in the window, and bonds that cannot break
    first_.push_back(2 * bonds.first[b]);
    second_.push_back(2 * bonds.second[b]);
    cosine_.push_back(ratios.scales().cosine[b]);
    sine_.push_back(ratios.scales().sine[b]);
    compliance.push_back(scale / std::sqrt(system.stages().stiffness()[b]));
  }
  classify(compliance);
}

void WindowCertificate::classify(const std::vector<double>& compliance) {
  compliance_.setZero();
  class_of_.assign(compliance.size(), 0);
  if (compliance.empty()) return;
  const auto [least, most] = std::minmax_element(compliance.begin(), compliance.end());
  const double lowest = std::log(*least), width = std::max(std::log(*most) - lowest, WindowSettings::least_class_width);
  for (std::size_t b = 0; b < compliance.size(); ++b) {
    const int k =
        std::min(most_classes - 1, static_cast<int>(most_classes * (std::log(compliance[b]) - lowest) / width));
    class_of_[b] = static_cast<char>(k);
    compliance_[k] = std::max(compliance_[k], compliance[b]);
  }
}

std::vector<WindowCertificate::Classes> WindowCertificate::largest_ratios(const Eigen::MatrixXd& displacements) const {
  std::vector<Classes> result;
  // States are treated in batches, so that the numbers of a bond's degrees of freedom are read once for all states of a
  // batch.
  constexpr Eigen::Index batch = WindowSettings::states_swept_at_once;
  using Batch = Eigen::Array<double, batch, 1>;
  Eigen::Array<double, batch, Eigen::Dynamic> u;
  for (Eigen::Index first = 0; first < displacements.rows(); first += batch) {
    const Eigen::Index count = std::min(batch, displacements.rows() - first);
    u.setZero(batch, displacements.cols());
    u.topRows(count) = displacements.middleRows(first, count);
    std::array<Batch, most_classes> largest;
    largest.fill(Batch::Zero());
    for (std::size_t b = 0; b < first_.size(); ++b) {
      const int i = first_[b], j = second_[b];
      Batch& most = largest[class_of_[b]];
      most = most.max(elongation_along(cosine_[b], sine_[b], u.col(j) - u.col(i), u.col(j + 1) - u.col(i + 1)));
    }
    for (Eigen::Index k = 0; k < count; ++k) {
      Classes& classes = result.emplace_back();
      for (int n = 0; n < most_classes; ++n) classes[n] = largest[n][k];
    }
  }
  return result;
}

void WindowCertificate::compute_snapshots(const std::vector<int>& states) {
  for (std::size_t begin = 0; begin < states.size(); begin += WindowSettings::states_solved_at_once) {
    const std::size_t end = std::min(states.size(), begin + WindowSettings::states_solved_at_once);
    compute_together(
        {states.begin() + static_cast<std::ptrdiff_t>(begin), states.begin() + static_cast<std::ptrdiff_t>(end)});
  }
}

void WindowCertificate::compute_together(const std::vector<int>& states) {
  check_cancelled();
  std::vector<int> solved = states;
  std::erase(solved, 0);
  Eigen::MatrixXd whole = solve(solved);
  // Pairs (state, load factor) at which the largest stretch ratios are needed: for each state both ends of the range of
  // all load factors, then the load factors of its checks.
  std::vector<std::pair<int, double>> wanted;
  for (int state : states) {
    wanted.emplace_back(state, lowest_);
    if (proportional_) continue;
    wanted.emplace_back(state, highest_);
    for (const OutsideCheck& check : checks_[state]) wanted.emplace_back(state, check.load_factor);
  }
  const bool are_these = proportional_ && wanted.size() == solved.size() && lowest_ == 1;
  const std::vector<Classes> largest = largest_ratios(are_these ? std::move(whole) : values(wanted, solved, whole));
  std::size_t next = 0;
  for (int state : states) {
    Snapshot& snapshot = snapshots_[state];
    snapshot.bound = largest[next++];
    if (proportional_) {
      snapshot.largest.assign(checks_[state].size(), snapshot.bound.maxCoeff());
      continue;
    }
    snapshot.bound = snapshot.bound.max(largest[next++]);
    for (std::size_t c = 0; c < checks_[state].size(); ++c) snapshot.largest.push_back(largest[next++].maxCoeff());
  }
}

// Displacements of the whole body in some states: one row for each state (proportional part), or two (constant and
// proportional part).
Eigen::MatrixXd WindowCertificate::solve(const std::vector<int>& states) {
  if (states.empty()) return {};
  const int parts = proportional_ ? 1 : 2;
  const auto kept = static_cast<Eigen::Index>(condensation_.dofs().size());
  Eigen::MatrixXd columns(kept, parts * static_cast<Eigen::Index>(states.size()));
  std::vector<int> part;
  for (int state : states) {
    for (int p = 0; p < parts; ++p) {
      part.push_back(proportional_ ? 1 : p);
      columns.col(static_cast<Eigen::Index>(part.size() - 1)) = (*states_)[state].col(part.back());
    }
  }
  Eigen::MatrixXd whole = condensation_.expand(columns, part);
  if (states.back() + 1 == static_cast<int>(states_->size())) {
    solved_state_ = states.back();
    solved_ = whole.bottomRows(parts).transpose();
  }
  return whole;
}

// Displacements of the whole body at pairs (state, load factor). `whole` holds the solutions of the states `solved`;
// for state 0 the displacements are known without a solution.
Eigen::MatrixXd WindowCertificate::values(const std::vector<std::pair<int, double>>& wanted,
                                          const std::vector<int>& solved, const Eigen::MatrixXd& whole) const {
  const int parts = proportional_ ? 1 : 2;
  Eigen::MatrixXd result(static_cast<Eigen::Index>(wanted.size()), whole_first_->rows());
  for (std::size_t w = 0; w < wanted.size(); ++w) {
    const auto [state, load_factor] = wanted[w];
    auto row = result.row(static_cast<Eigen::Index>(w));
    if (state == 0) {
      row = load_factor * whole_first_->col(1).transpose();
      if (!proportional_) row += whole_first_->col(0).transpose();
      continue;
    }
    const auto at = parts * (std::find(solved.begin(), solved.end(), state) - solved.begin());
    row = whole.row(at);
    if (!proportional_) row += load_factor * whole.row(at + 1);
  }
  return result;
}

bool WindowCertificate::is_exceeded(int state) const {
  const Snapshot& snapshot = snapshots_.at(state);
  for (std::size_t c = 0; c < checks_[state].size(); ++c) {
    if (!(snapshot.largest[c] < checks_[state][c].limit_less_rounding())) return true;
  }
  return false;
}

Eigen::VectorXd WindowCertificate::on_boundary(int state, double load_factor) const {
  const Affine& kept = (*states_)[state];
  const std::vector<int>& dofs = window_.outside_dofs();
  Eigen::VectorXd u = load_factor * kept.col(1)(dofs);
  if (!proportional_) u += kept.col(0)(dofs);
  return u;
}

std::vector<int> WindowCertificate::uncertified() const {
  struct Question {
    int state;
    double limit;
    Classes mean;  // largest ratios in the mean of two snapshots
  };
  std::vector<Question> questions;
  std::vector<Eigen::VectorXd> differences;
  for (auto a = snapshots_.begin(), b = std::next(a); b != snapshots_.end(); ++a, ++b) {
    for (int state = a->first + 1; state < b->first; ++state) {
      for (const OutsideCheck& check : checks_[state]) {
        const Eigen::VectorXd start = on_boundary(a->first, check.load_factor);
        const Eigen::VectorXd way = on_boundary(b->first, check.load_factor) - start;
        const Eigen::VectorXd here = on_boundary(state, check.load_factor) - start;
        const double length = way.squaredNorm();
        const double t = length > 0 ? std::clamp(way.dot(here) / length, 0.0, 1.0) : 0.0;
        questions.push_back({state, check.limit_less_rounding(), (1 - t) * a->second.bound + t * b->second.bound});
        differences.push_back(here - t * way);
      }
    }
  }
  std::vector<int> found;
  if (questions.empty()) return found;
  Eigen::MatrixXd d(differences.front().size(), static_cast<Eigen::Index>(differences.size()));
  for (std::size_t q = 0; q < differences.size(); ++q) d.col(static_cast<Eigen::Index>(q)) = differences[q];
  const Eigen::MatrixXd force = window_.outside_stiffness() * d;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    const auto column = static_cast<Eigen::Index>(q);
    const double energy = std::max(0.0, d.col(column).dot(force.col(column))) + rounding_ * d.col(column).squaredNorm();
    const Classes ratio = questions[q].mean + std::sqrt(energy) * compliance_;
    const bool sure = ratio.maxCoeff() < questions[q].limit;
    if (!sure && (found.empty() || found.back() != questions[q].state)) found.push_back(questions[q].state);
  }
  return found;
}

// States to compute for the whole body next: up to three in every run of neighbouring uncertified states; in the last
// round all uncertified states.
std::vector<int> WindowCertificate::between_snapshots(const std::vector<int>& states, int round) const {
  if (round >= WindowSettings::most_rounds) return states;
  std::vector<int> chosen;
  for (std::size_t begin = 0; begin < states.size();) {
    std::size_t end = begin + 1;
    while (end < states.size() && states[end] == states[end - 1] + 1) ++end;
    const std::size_t length = end - begin;
    if (length <= 2) {
      chosen.insert(chosen.end(), states.begin() + begin, states.begin() + end);
    } else {
      const std::size_t parts = std::min<std::size_t>(4, length / 2 + 1);
      for (std::size_t p = 1; p < parts; ++p) chosen.push_back(states[begin + p * length / parts]);
    }
    begin = end;
  }
  return chosen;
}

Affine WindowCertificate::last_displacement(int state) const {
  if (state != solved_state_) return condensation_.displacement((*states_)[state]);
  Affine all = Affine::Zero(solved_.rows(), 2);
  all.rightCols(solved_.cols()) = solved_;
  condensation_.recover(all);
  return all;
}

int WindowCertificate::first_violation(const std::vector<Affine>& states, const std::vector<int>& breaks,
                                       const std::vector<OutsideCheck>& checks, const Affine& first) {
  states_ = &states;
  whole_first_ = &first;
  snapshots_.clear();
  solved_state_ = -1;
  checks_.assign(states.size(), {});
  lowest_ = highest_ = checks.empty() ? 0 : checks.front().load_factor;
  for (const OutsideCheck& check : checks) {
    checks_[check.state].push_back(check);
    lowest_ = std::min(lowest_, check.load_factor);
    highest_ = std::max(highest_, check.load_factor);
  }
  std::vector<int> wanted;
  int counted = -WindowSettings::breaks_between_snapshots;
  for (int s = 0; s < static_cast<int>(states.size()); ++s) {
    if (breaks[s] - counted < WindowSettings::breaks_between_snapshots && s + 1 < static_cast<int>(states.size()))
      continue;
    wanted.push_back(s);
    counted = breaks[s];
  }
  int end = static_cast<int>(states.size());
  for (int round = 0; !wanted.empty(); ++round) {
    compute_snapshots(wanted);
    // States after the first violation need no results.
    for (auto s = snapshots_.begin(); s != snapshots_.end() && s->first < end; ++s) {
      if (is_exceeded(s->first)) end = s->first;
    }
    snapshots_.erase(snapshots_.upper_bound(end), snapshots_.end());
    const std::vector<int> doubtful = uncertified();
    // A proven state stays proven when more snapshots are added, so its checks are dropped.
    for (int state = 0; state < end; ++state) {
      if (!snapshots_.contains(state) && !std::binary_search(doubtful.begin(), doubtful.end(), state)) {
        checks_[state].clear();
      }
    }
    wanted = between_snapshots(doubtful, round);
  }
  return end;
}

}  // namespace bempd::fracture
