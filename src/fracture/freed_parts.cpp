#include "fracture/freed_parts.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/rigid_motion.hpp"
#include "linalg/symmetric_modes.hpp"

namespace bempd::fracture {

namespace {

using coupling::HeldDirection;
using coupling::HoldingSpring;
using coupling::RigidMotion;

// Ratio of a point's smallest stiffness in any direction to its largest, below which the point's terms (bonds and cell
// squares) act along one line only and do not resist a motion across that line.
constexpr double collinearity_tolerance = 1e-10;

// Ratio of the work of forces on a free motion (of unit size) to the sum of the forces, below which the forces are in
// equilibrium without support.
constexpr double balance_tolerance = 1e-9;

// Relative difference up to which components of a motion count as equal, so that rounding does not decide which
// component is held.
constexpr double motion_rounding = 1e-6;

}  // namespace

FreedPartFinder::FreedPartFinder(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions)
    : system_(system), positions_(positions), connectivity_(system) {
  double largest = 0;
  for (double k : system.terms().stiffness) largest = std::max(largest, k);
  spring_stiffness_ = largest > 0 ? largest : system.stiffness_range().largest;
}

HoldingSpring FreedPartFinder::spring(int node, double cosine, double sine, const Eigen::VectorXd& displacement) const {
  return {node, cosine, sine, spring_stiffness_, cosine * displacement[2 * node] + sine * displacement[2 * node + 1]};
}

FreedParts FreedPartFinder::all_pieces(const Eigen::VectorXd& displacement) const {
  FreedParts found;
  for (int node = 0; node < system_.node_count(); ++node) hold_loose_point(node, displacement, found);
  for (const auto& nodes : connectivity_.pieces()) hold_piece(nodes, displacement, found);
  return found;
}

FreedParts FreedPartFinder::after_break(const std::vector<int>& removed, const Eigen::VectorXd& displacement) const {
  FreedParts found;
  std::vector<int> ends;
  for (int t : removed) {
    system_.terms().for_each_node(static_cast<std::size_t>(t), [&](int node) { ends.push_back(node); });
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (int node : ends) hold_loose_point(node, displacement, found);
  if (connectivity_.still_joined(removed)) return found;
  for (const auto& nodes : connectivity_.pieces()) hold_piece(nodes, displacement, found);
  return found;
}

bool FreedPartFinder::frees_nothing(const std::vector<int>& removed, const Eigen::VectorXd& displacement) const {
  FreedParts found;
  const coupling::Terms& terms = system_.terms();
  for (int t : removed) {
    terms.for_each_node(static_cast<std::size_t>(t), [&](int node) { hold_loose_point(node, displacement, found); });
  }
  const auto is_nothing = [&] { return found.springs.empty() && found.nodes_with_lost_loads.empty(); };
  if (!is_nothing()) return false;
  if (connectivity_.still_joined(removed)) return true;
  bool joined = true;
  for (int t : removed) {
    terms.for_each_node(static_cast<std::size_t>(t), [&](int node) {
      joined = joined && (node == terms.first[t] || connectivity_.are_joined(terms.first[t], node));
    });
  }
  if (joined) return true;
  for (const auto& nodes : connectivity_.pieces()) hold_piece(nodes, displacement, found);
  return is_nothing() && found.fragments == 0;
}

bool FreedPartFinder::Resistance::is_loose() const {
  return modes.values[0] <= collinearity_tolerance * modes.values[1];
}

FreedPartFinder::Resistance FreedPartFinder::resistance_of(int node) const {
  Eigen::Matrix2d resistance = Eigen::Matrix2d::Zero();
  const auto add = [&](double c, double s, double k) {
    const Eigen::Vector2d direction(c, s);
    resistance += k * direction * direction.transpose();
  };
  for (int t : connectivity_.intact_terms_at(node)) {
    system_.terms().for_each_entry(static_cast<std::size_t>(t), [&](int at, double x, double y) {
      if (at == node) add(x, y, system_.stages().stiffness()[t]);
    });
  }
  const bool has_terms = !resistance.isZero(0);
  if (system_.unknowns().is_prescribed(2 * node)) add(1, 0, spring_stiffness_);
  if (system_.unknowns().is_prescribed(2 * node + 1)) add(0, 1, spring_stiffness_);
  return {linalg::symmetric_modes(resistance), has_terms};
}

void FreedPartFinder::hold_loose_point(int node, const Eigen::VectorXd& displacement, FreedParts& found) const {
  if (system_.dense_bodies().contain(node)) return;
  const Resistance resistance = resistance_of(node);
  if (!resistance.has_terms || !resistance.is_loose()) return;  // a point without terms is a piece of its own
  const linalg::SymmetricModes& modes = resistance.modes;
  const Eigen::Vector2d weak = modes.vectors.col(0);
  const Eigen::RowVector2d push = weak.transpose() * system_.load().force().middleRows<2>(2 * node);
  auto& lost = found.nodes_with_lost_loads;
  const bool pushed = push.norm() > balance_tolerance * system_.load().force().middleRows<2>(2 * node).norm();
  if (pushed && std::find(lost.begin(), lost.end(), node) == lost.end()) {
    lost.push_back(node);
    ++found.fragments;  // the point swings on its last bond
  }
  double held = 0;
  for (const HoldingSpring& s : system_.springs()) {
    if (s.node == node) held += s.stiffness * std::pow(s.cosine * weak.x() + s.sine * weak.y(), 2);
  }
  if (held <= collinearity_tolerance * modes.values[1])
    found.springs.push_back(spring(node, weak.x(), weak.y(), displacement));
}

bool is_pushed(const RigidMotion& motion, const std::vector<Point>& positions, const std::vector<int>& nodes,
               const coupling::Affine& forces) {
  for (int column = 0; column < 2; ++column) {
    const auto force = forces.col(column);
    double size = 0;
    for (int node : nodes) size += force.segment<2>(2 * node).norm();
    for (int k = 0; k < motion.free_count(); ++k) {
      if (std::abs(motion.work(k, positions, nodes, force)) > balance_tolerance * size) return true;
    }
  }
  return false;
}

void FreedPartFinder::hold_piece(const std::vector<int>& nodes, const Eigen::VectorXd& displacement,
                                 FreedParts& found) const {
  std::vector<HeldDirection> held, holdable;
  for (int node : nodes) {
    for (int component = 0; component < 2; ++component) {
      const HeldDirection direction{node, component == 0 ? 1.0 : 0.0, component == 1 ? 1.0 : 0.0};
      if (system_.unknowns().is_prescribed(2 * node + component)) held.push_back(direction);
      if (system_.unknowns().is_unknown(2 * node + component)) holdable.push_back(direction);
    }
  }
  // Springs must not carry loads, so all loads of the piece count here, also those that acted before springs were
  // added.
  const RigidMotion unsupported(positions_, nodes, held);
  if (unsupported.free_count() == 0) return;
  const bool pushed = is_pushed(unsupported, positions_, nodes, system_.load().force());
  if (pushed) {
    found.nodes_with_lost_loads.insert(found.nodes_with_lost_loads.end(), nodes.begin(), nodes.end());
  }
  const bool supported = !held.empty();
  const auto add = [&](const std::vector<HoldingSpring>& springs) {
    for (const HoldingSpring& s : springs) {
      if (std::binary_search(nodes.begin(), nodes.end(), s.node)) held.push_back({s.node, s.cosine, s.sine});
    }
  };
  add(system_.springs());
  add(found.springs);
  const RigidMotion motion(positions_, nodes, held);
  const std::vector<HeldDirection> missing = motion.missing_supports(positions_, holdable);
  for (const HeldDirection& h : missing) found.springs.push_back(spring(h.node, h.cosine, h.sine, displacement));
  if (!missing.empty() && (!supported || pushed)) ++found.fragments;  // the piece is free, or it swings on a support
}

FreedPartFinder::PartsOnSprings FreedPartFinder::held_parts() const {
  PartsOnSprings held{std::vector<char>(system_.node_count(), 0), {}};
  std::vector<char> has_spring(system_.node_count(), 0);
  for (const HoldingSpring& s : system_.springs()) has_spring[s.node] = 1;
  for (const std::vector<int>& nodes : connectivity_.pieces()) {
    const auto is_supported = [&](int n) {
      return system_.unknowns().is_prescribed(2 * n) || system_.unknowns().is_prescribed(2 * n + 1);
    };
    if (std::none_of(nodes.begin(), nodes.end(), [&](int n) { return has_spring[n] != 0; })) continue;
    if (std::any_of(nodes.begin(), nodes.end(), is_supported)) continue;
    for (const int node : nodes) held.nodes[node] = 1;
  }
  std::vector<int> loose;
  for (const HoldingSpring& s : system_.springs()) {
    if (held.nodes[s.node]) continue;
    const linalg::SymmetricModes modes = resistance_of(s.node).modes;
    const Eigen::Vector2d along = modes.vectors.transpose() * Eigen::Vector2d(s.cosine, s.sine);
    const double resistance = modes.values.dot(along.cwiseAbs2());
    if (!system_.dense_bodies().contain(s.node) && resistance <= collinearity_tolerance * modes.values[1]) {
      loose.push_back(s.node);
    } else {
      held.springs_in_supported_pieces.push_back(s);
    }
  }
  for (const int node : loose) held.nodes[node] = 1;
  return held;
}

HoldingSpring FreedPartFinder::spring_against(const Eigen::VectorXd& motion,
                                              const Eigen::VectorXd& displacement) const {
  int largest = -1;
  for (int dof = 0; dof < motion.size(); ++dof) {
    if (!system_.unknowns().is_unknown(dof)) continue;
    if (largest < 0 || std::abs(motion[dof]) > (1 + motion_rounding) * std::abs(motion[largest])) largest = dof;
  }
  return spring(largest / 2, largest % 2 == 0 ? 1 : 0, largest % 2 == 0 ? 0 : 1, displacement);
}

}  // namespace bempd::fracture
