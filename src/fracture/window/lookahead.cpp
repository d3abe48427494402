#include "fracture/window/lookahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bempd::fracture {

namespace {

// How far a window reaches, in lattice spacings, and how many unknowns it may have. Its own costs grow with the square
// of its length per bond and with the cube once; the longer it is, the fewer factorizations of the whole body it takes,
// whose cost grows with the size of the system to the power 1.5. Both sides balance where the length grows with the
// root.
constexpr double length_at_20000_unknowns = 31, least_length = 8, most_length = 320;
// At the ends of initial cracks, where a straight run is to take one factorization, windows are longer by this factor.
constexpr double length_of_expected = 1.5;
constexpr double least_most_unknowns = 2600, most_unknowns_per_length = 46;
constexpr std::size_t most_hot_bonds = 1500, most_cut_bonds = 6000;

// Bonds broken between two looks at what can be left behind; the least share of what is followed that is worth it; and
// where it lies: so many lattice spacings behind the bonds with this share of the largest ratio.
constexpr std::size_t breaks_between_narrowings = 96;
constexpr double least_narrowing = 0.15, hot_share = 0.5, behind_hot = 1;

// Events computed at once: few at first, in case the host wants few, then up to this many.
constexpr int first_events = 16, most_events_at_once = 1024;

// Worst residual with which computed events are taken; what is left is rounding.
constexpr double acceptable_residual = 1e-11;

}  // namespace

using coupling::Affine;

Lookahead::Lookahead(coupling::EquilibriumSystem& system, const FreedPartFinder& freed_parts,
                     const StretchRatios& ratios, const std::vector<Point>& positions,
                     const std::vector<std::vector<int>>& reaction_dofs)
    : system_(system),
      freed_parts_(freed_parts),
      whole_ratios_(ratios),
      positions_(positions),
      reaction_dofs_(reaction_dofs),
      spacing_(positions.size(), std::numeric_limits<double>::infinity()) {
  const coupling::BondSet& bonds = system.bonds();
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    for (int node : {bonds.first[b], bonds.second[b]}) spacing_[node] = std::min(spacing_[node], bonds.length[b]);
  }
}

void Lookahead::expect_cracks(const std::vector<int>& cut) {
  if (!system_.is_symmetric() || cut.empty() || cut.size() > most_cut_bonds) return;
  ZoneShape shape;
  shape.ahead = length_of_expected * length_ahead();
  std::vector<Zone> zones = zones_at_ends(cut, whole_ratios_.bonds(), positions_, spacing_, shape);
  std::vector<int> nodes = nodes_of(zones);
  if (is_too_large(nodes, shape)) return;
  keep(std::move(zones), std::move(nodes));
  expected_zones_ = zones_;
  expected_nodes_ = nodes_;
}

// Nodes that touch the outside come first: what the window needs to know of the outside is then a corner of the factor.
void Lookahead::keep(std::vector<Zone> zones, std::vector<int> nodes) {
  zones_ = std::move(zones);
  nodes_ = std::move(nodes);
  mark_rim();
  std::stable_partition(nodes_.begin(), nodes_.end(), [&](int node) { return touches_outside_[node] != 0; });
  system_.keep_last(nodes_);
}

double Lookahead::length_ahead() const {
  if (options_.ahead > 0) return options_.ahead;
  const double size = static_cast<double>(system_.counters().sparse_unknowns);
  return std::clamp(length_at_20000_unknowns * std::sqrt(size / 20000), least_length, most_length);
}

bool Lookahead::is_too_large(const std::vector<int>& nodes, const ZoneShape& shape) const {
  return 2 * static_cast<double>(nodes.size()) > std::max(least_most_unknowns, most_unknowns_per_length * shape.ahead);
}

void Lookahead::forget() {
  close();
  most_events_ = first_events;
  zones_ = expected_zones_;
  nodes_ = expected_nodes_;
  system_.keep_last(nodes_);
}

void Lookahead::close() {
  if (!window_) return;
  window_.reset();
  certificate_.reset();
  condensation_.reset();
  events_.clear();
  states_.clear();
  if (system_has_changed_) system_.forget_factor();
  if (needs_whole_body_) system_.keep_last({});  // what comes next factorizes, twice, and needs no window for it
}

std::vector<int> Lookahead::nodes_of(const std::vector<Zone>& zones) const {
  std::vector<int> nodes;
  for (int node = 0; node < system_.node_count(); ++node) {
    if (!std::isfinite(spacing_[node])) continue;
    if (!system_.is_unknown(2 * node) && !system_.is_unknown(2 * node + 1)) continue;
    const auto has = [&](const Zone& zone) { return zone.contains(positions_[node]); };
    if (std::any_of(zones.begin(), zones.end(), has)) nodes.push_back(node);
  }
  return nodes;
}

// Bonds that end on a node with bonds to the outside are left to the next window if they lie near a zone's rim: there
// the neighbours outside soon break as well.
void Lookahead::mark_rim() {
  std::vector<char> kept(system_.node_count(), 0);
  touches_outside_.assign(system_.node_count(), 0);
  for (int node : nodes_) kept[node] = 1;
  for (int node = 0; node < system_.node_count(); ++node) {
    if (system_.is_prescribed(2 * node) && system_.is_prescribed(2 * node + 1)) kept[node] = 1;
  }
  const coupling::BondSet& bonds = system_.bonds();
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    const int i = bonds.first[b], j = bonds.second[b];
    if (system_.intact()[b] && kept[i] != kept[j]) touches_outside_[i] = touches_outside_[j] = 1;
  }
  on_rim_ = touches_outside_;
  for (int node : nodes_) {
    const auto is_inside = [&](const Zone& zone) { return zone.is_inner(positions_[node]); };
    if (on_rim_[node] && std::any_of(zones_.begin(), zones_.end(), is_inside)) on_rim_[node] = 0;
  }
}

bool Lookahead::is_far_from_rim(const std::vector<int>& bonds) const {
  return std::none_of(bonds.begin(), bonds.end(),
                      [&](int b) { return on_rim_[system_.bonds().first[b]] || on_rim_[system_.bonds().second[b]]; });
}

bool Lookahead::choose_nodes(const EvolutionState& state, double load_factor) {
  double largest = 0;
  for (std::size_t b = 0; b < state.intact.size(); ++b) {
    if (state.intact[b]) largest = std::max(largest, whole_ratios_.at(b, load_factor));
  }
  ZoneShape shape;
  shape.ahead = length_ahead();
  for (double share : {0.7, 0.8, 0.9, 0.97, tie_limit(options_.tie_band)}) {
    std::vector<int> hot;
    for (std::size_t b = 0; b < state.intact.size(); ++b) {
      if (state.intact[b] && whole_ratios_.at(b, load_factor) >= share * largest) hot.push_back(static_cast<int>(b));
    }
    if (hot.size() > most_hot_bonds) continue;
    // The window before may still hold what is hot.
    if (!nodes_.empty() && system_.factor_keeps(nodes_)) {
      mark_rim();
      std::vector<char> kept(system_.node_count(), 0);
      for (int node : nodes_) kept[node] = 1;
      const bool all_kept = std::all_of(hot.begin(), hot.end(), [&](int b) {
        return kept[system_.bonds().first[b]] && kept[system_.bonds().second[b]];
      });
      if (all_kept && is_far_from_rim(hot)) return true;
    }
    std::vector<Zone> zones = zones_of(hot, whole_ratios_, load_factor, state.intact, positions_, spacing_, shape);
    std::vector<int> nodes = nodes_of(zones);
    if (nodes.empty() || is_too_large(nodes, shape)) continue;
    keep(std::move(zones), std::move(nodes));
    return true;
  }
  return false;
}

// The loads' work, the energy in moving supports, then the reactions: in this order in the values of a window.
std::vector<ActiveWindow::Function> Lookahead::functions() const {
  std::vector<ActiveWindow::Function> result;
  const Eigen::Index dofs = 2 * system_.node_count();
  for (int part = 0; part < 2; ++part) {
    Eigen::VectorXd load = system_.force().col(part);
    for (Eigen::Index dof = 0; dof < dofs; ++dof) {
      if (system_.is_prescribed(static_cast<int>(dof))) load[dof] = 0;
    }
    result.push_back({load, {}});
  }
  for (int part = 0; part < 2; ++part) {
    const Eigen::VectorXd moved = system_.prescribed().col(part);
    result.push_back({system_.internal_force(moved), moved});
  }
  for (const std::vector<int>& support : reaction_dofs_) {
    for (int component = 0; component < 2; ++component) {
      Eigen::VectorXd moved = Eigen::VectorXd::Zero(dofs);
      for (int dof : support) moved[dof] = dof % 2 == component ? 1 : moved[dof];
      result.push_back({system_.internal_force(moved), moved});
    }
  }
  return result;
}

EnergyForm Lookahead::energy(const Eigen::Matrix<double, Eigen::Dynamic, 2>& values) const {
  return {values(0, 0) + values(2, 0), values(0, 1) + values(3, 0), values(1, 1) + values(3, 1)};
}

bool Lookahead::open(const EvolutionState& state, double load_factor, const Options& options) {
  close();
  options_ = options;
  if (!system_.is_symmetric() || !choose_nodes(state, load_factor)) return false;
  condensation_ = std::make_unique<coupling::Condensation>(system_);
  window_ = std::make_unique<ActiveWindow>(system_, *condensation_, whole_ratios_, state.displacement, functions());
  proportional_ = state.displacement.col(0).isZero(0) && state.load_factor >= 0;
  certificate_ = std::make_unique<WindowCertificate>(system_, *condensation_, *window_, whole_ratios_, proportional_);
  whole_ = state.displacement;
  any_displacement_ = state.total_displacement;
  residual_ = state.residual;
  largest_force_ = state.largest_force;
  has_ended_ = needs_whole_body_ = system_has_changed_ = false;
  position_ = 0;
  next_narrowing_ = breaks_between_narrowings;
  states_ = {window_->displacement()};
  return true;
}

const ForeseenEvent* Lookahead::next(double load_factor, const std::function<void()>& before_computing) {
  if (position_ == static_cast<int>(events_.size())) {
    if (has_ended_) return nullptr;
    before_computing();
    compute(load_factor);
  }
  return position_ < static_cast<int>(events_.size()) ? &events_[position_] : nullptr;
}

void Lookahead::take() {
  system_.set_parted(events_[position_].bonds, true);
  system_has_changed_ = true;
  ++position_;
}

void Lookahead::return_to(int position) {
  while (position_ > position) system_.set_parted(events_[--position_].bonds, false);
}

Affine Lookahead::displacement(int position) const {
  const bool is_last = position + 1 == static_cast<int>(states_.size());
  return is_last ? whole_ : condensation_->displacement(states_[position]);
}

void Lookahead::compute(double load_factor) {
  events_.clear();
  checks_.clear();
  position_ = 0;
  foreseen_ = {window_->state()};
  double from = load_factor;
  while (!has_ended_ && static_cast<int>(events_.size()) < most_events_) {
    if (!foresee(from)) {
      has_ended_ = true;
    } else {
      from = events_.back().load_factor;
    }
  }
  most_events_ = std::min(4 * most_events_, most_events_at_once);
  states_ = window_->complete(foreseen_);
  certify();
  for (const ForeseenEvent& event : events_) system_.set_parted(event.bonds, false);
}

bool Lookahead::foresee(double from) {
  leave_behind(from);
  const double infinity = std::numeric_limits<double>::infinity();
  const AffineRatios& ratios = window_->ratios();
  const std::optional<double> next =
      proportional_ ? ratios.next_proportional_break(from) : ratios.next_break(window_->intact(), from, infinity);
  if (!next) return false;
  const double f = *next;
  const std::vector<int> chosen =
      proportional_ ? ratios.most_stretched(window_->intact(), f, options_.tie_band, options_.max_breaks_per_solve,
                                            f * ratios.steepest())
                    : ratios.most_stretched(window_->intact(), f, options_.tie_band, options_.max_breaks_per_solve);
  ForeseenEvent event{f, 0, {}, {}, {}, 0, 0, {}};
  std::vector<double> elongation;
  for (int b : chosen) {
    event.bonds.push_back(window_->bonds()[b]);
    event.ratio = std::max(event.ratio, ratios.at(b, f));
    elongation.push_back(window_->elongation(b, f));
  }
  if (!is_far_from_rim(event.bonds)) return false;
  system_.set_parted(event.bonds, true);
  const auto before = window_->function_values();
  if (!freed_parts_.frees_nothing(event.bonds, any_displacement_) || !window_->remove(chosen)) {
    system_.set_parted(event.bonds, false);
    needs_whole_body_ = true;
    return false;
  }
  const auto after = window_->function_values();
  event.before = energy(before);
  event.after = energy(after);
  const Eigen::Vector2d at(1, f);
  event.work = at.dot((after - before).topRows<2>() * at);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    event.released += 0.5 * window_->stiffness(chosen[i]) * elongation[i] * window_->elongation(chosen[i], f);
  }
  for (std::size_t s = 0; s < reaction_dofs_.size(); ++s) {
    Eigen::Vector2d reaction = after.middleRows<2>(4 + 2 * static_cast<Eigen::Index>(s)) * at;
    for (int dof : reaction_dofs_[s]) reaction[dof % 2] -= system_.force().row(dof).dot(at);
    event.reactions.insert(event.reactions.end(), {reaction.x(), reaction.y()});
  }
  const int state = static_cast<int>(events_.size());
  const double limit = tie_limit(options_.tie_band) * event.ratio;
  if (proportional_) {
    checks_.push_back({state, 1, limit / f});
  } else {
    if (from != f) checks_.push_back({state, from, 1});
    checks_.push_back({state, f, limit});
  }
  has_ended_ = 0.5 * event.after.proportional < options_.separated_energy;
  events_.push_back(std::move(event));
  foreseen_.push_back(window_->state());
  return true;
}

// Keeps the events that the whole body would go through in the same way.
void Lookahead::certify() {
  if (events_.empty()) return;
  keep_first(window_->left_behind().first_violation(states_, checks_));
  if (events_.empty()) return;
  std::vector<int> breaks{0};
  for (const ForeseenEvent& event : events_) breaks.push_back(breaks.back() + static_cast<int>(event.bonds.size()));
  keep_first(certificate_->first_violation(states_, breaks, checks_, whole_));
  if (events_.empty()) return;  // whole_ is that of the state 0
  const Affine before = std::move(whole_);
  whole_ = certificate_->last_displacement(static_cast<int>(events_.size()));
  const double f = events_.back().load_factor;
  const Eigen::VectorXd force = system_.internal_force(coupling::evaluate(whole_, f));
  const Eigen::VectorXd load = coupling::evaluate(system_.force(), f);
  double unbalanced = 0;
  for (Eigen::Index dof = 0; dof < load.size(); ++dof) {
    if (!system_.is_prescribed(static_cast<int>(dof)))
      unbalanced = std::max(unbalanced, std::abs(force[dof] - load[dof]));
  }
  largest_force_ = std::max(largest_force_, force.lpNorm<Eigen::Infinity>());
  residual_ = largest_force_ > 0 ? unbalanced / largest_force_ : unbalanced;
  if (residual_ <= acceptable_residual) return;
  keep_first(0);
  whole_ = before;
}

void Lookahead::keep_first(int count) {
  if (count >= static_cast<int>(events_.size())) return;
  has_ended_ = true;
  needs_whole_body_ = false;
  most_events_ = std::max(first_events, 2 * count);  // more would be in vain again
  for (std::size_t e = count; e < events_.size(); ++e) system_.set_parted(events_[e].bonds, false);
  events_.resize(count);
  states_.resize(count + 1);
  std::erase_if(checks_, [&](const OutsideCheck& check) { return check.state >= count; });
}

// Behind the bonds that are hot in a zone nothing breaks any more.
void Lookahead::leave_behind(double load_factor) {
  const std::size_t broken = window_->breaks();
  if (broken < next_narrowing_) return;
  next_narrowing_ = broken + breaks_between_narrowings;
  const AffineRatios& ratios = window_->ratios();
  const coupling::BondSet& bonds = system_.bonds();
  double largest = 0;
  for (std::size_t b = 0; b < window_->bonds().size(); ++b) {
    if (window_->intact()[b]) largest = std::max(largest, ratios.at(b, load_factor));
  }
  std::vector<double> rear(zones_.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t b = 0; b < window_->bonds().size(); ++b) {
    if (!window_->intact()[b] || ratios.at(b, load_factor) < hot_share * largest) continue;
    const int i = bonds.first[window_->bonds()[b]], j = bonds.second[window_->bonds()[b]];
    for (std::size_t z = 0; z < zones_.size(); ++z) {
      if (!zones_[z].contains(positions_[i]) && !zones_[z].contains(positions_[j])) continue;
      const double place = std::min(zones_[z].coordinates(positions_[i]).x(), zones_[z].coordinates(positions_[j]).x());
      rear[z] = std::isfinite(rear[z]) ? std::min(rear[z], place) : place;
    }
  }
  std::vector<char> leaves;
  int leaving = 0;
  for (int dof : condensation_->dofs()) {
    const int node = dof / 2;
    const auto needs = [&](std::size_t z) {
      if (!zones_[z].contains(positions_[node])) return false;
      const Point place = zones_[z].coordinates(positions_[node]);
      return place.x() > rear[z] - behind_hot * spacing_[node];
    };
    bool needed = false;
    for (std::size_t z = 0; z < zones_.size(); ++z) needed = needed || needs(z);
    leaves.push_back(needed ? 0 : 1);
    leaving += needed ? 0 : 1;
  }
  const int followed = window_->followed(), gone = static_cast<int>(leaves.size()) - followed;
  if (leaving - gone >= least_narrowing * followed) window_->narrow(leaves);
}

}  // namespace bempd::fracture
