#include "fracture/freed_parts.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "coupling/rigid_motion.hpp"

namespace bempd::fracture {

namespace {

using coupling::HeldDirection;
using coupling::HoldingSpring;
using coupling::RigidMotion;

// Bonds on one line up to this share of their stiffness do not resist a motion across it.
constexpr double collinearity_tolerance = 1e-10;

// Forces whose work on a free motion is a smaller share of their size are in equilibrium without support.
constexpr double balance_tolerance = 1e-9;

void append(FreedParts& found, FreedParts&& more) {
  found.springs.insert(found.springs.end(), more.springs.begin(), more.springs.end());
  found.nodes_with_lost_loads.insert(found.nodes_with_lost_loads.end(), more.nodes_with_lost_loads.begin(),
                                     more.nodes_with_lost_loads.end());
  found.fragments += more.fragments;
}

}  // namespace

FreedPartFinder::FreedPartFinder(const coupling::EquilibriumSystem& system, const std::vector<Point>& positions)
    : system_(system), positions_(positions), connectivity_(system) {
  double largest = 0;
  for (double k : system.bonds().stiffness) largest = std::max(largest, k);
  spring_stiffness_ = largest;
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

FreedParts FreedPartFinder::after_break(const std::vector<int>& removed_bonds,
                                        const Eigen::VectorXd& displacement) const {
  FreedParts found;
  std::vector<int> ends;
  for (int b : removed_bonds) {
    ends.push_back(system_.bonds().first[b]);
    ends.push_back(system_.bonds().second[b]);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (int node : ends) hold_loose_point(node, displacement, found);
  if (connectivity_.still_joined(removed_bonds)) return found;
  for (const auto& nodes : connectivity_.pieces()) hold_piece(nodes, displacement, found);
  return found;
}

void FreedPartFinder::hold_loose_point(int node, const Eigen::VectorXd& displacement, FreedParts& found) const {
  if (system_.in_dense_operator(node)) return;
  Eigen::Matrix2d resistance = Eigen::Matrix2d::Zero();
  const auto add = [&](double c, double s, double k) {
    const Eigen::Vector2d direction(c, s);
    resistance += k * direction * direction.transpose();
  };
  const coupling::BondSet& bonds = system_.bonds();
  for (int b : connectivity_.intact_bonds_at(node)) add(bonds.cosine[b], bonds.sine[b], bonds.stiffness[b]);
  if (resistance.isZero(0)) return;  // a piece of its own
  if (system_.is_prescribed(2 * node)) add(1, 0, spring_stiffness_);
  if (system_.is_prescribed(2 * node + 1)) add(0, 1, spring_stiffness_);
  for (const HoldingSpring& s : system_.springs()) {
    if (s.node == node) add(s.cosine, s.sine, s.stiffness);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(resistance);
  if (eigen.eigenvalues()[0] > collinearity_tolerance * eigen.eigenvalues()[1]) return;
  const Eigen::Vector2d weak = eigen.eigenvectors().col(0);
  found.springs.push_back(spring(node, weak.x(), weak.y(), displacement));
  const Eigen::RowVector2d push = weak.transpose() * system_.force().middleRows<2>(2 * node);
  if (push.norm() > balance_tolerance * system_.force().middleRows<2>(2 * node).norm()) {
    found.nodes_with_lost_loads.push_back(node);
  }
}

void FreedPartFinder::hold_piece(const std::vector<int>& nodes, const Eigen::VectorXd& displacement,
                                 FreedParts& found) const {
  std::vector<HeldDirection> held;
  std::vector<int> holdable;
  bool supported = false;
  for (int node : nodes) {
    for (int component = 0; component < 2; ++component) {
      if (!system_.is_prescribed(2 * node + component)) continue;
      held.push_back({node, component == 0 ? 1.0 : 0.0, component == 1 ? 1.0 : 0.0});
      supported = true;
    }
    if (system_.is_unknown(2 * node) && system_.is_unknown(2 * node + 1)) holdable.push_back(node);
  }
  std::vector<char> member(system_.node_count(), 0);
  for (int node : nodes) member[node] = 1;
  for (const HoldingSpring& s : system_.springs()) {
    if (member[s.node]) held.push_back({s.node, s.cosine, s.sine});
  }
  for (const HoldingSpring& s : found.springs) {
    if (member[s.node]) held.push_back({s.node, s.cosine, s.sine});
  }
  const RigidMotion motion(positions_, nodes, held);
  if (motion.free_count() == 0 || holdable.empty()) return;

  FreedParts piece;
  for (const HeldDirection& h : motion.missing_supports(positions_, holdable)) {
    piece.springs.push_back(spring(h.node, h.cosine, h.sine, displacement));
  }
  piece.fragments = supported ? 0 : 1;
  bool pushed = false;
  for (int column = 0; column < 2; ++column) {
    const auto force = system_.force().col(column);
    double size = 0;
    for (int node : nodes) size += force.segment<2>(2 * node).norm();
    for (int k = 0; k < motion.free_count(); ++k) {
      pushed = pushed || std::abs(motion.work(k, positions_, nodes, force)) > balance_tolerance * size;
    }
  }
  if (pushed) piece.nodes_with_lost_loads = nodes;
  append(found, std::move(piece));
}

HoldingSpring FreedPartFinder::against(const Eigen::VectorXd& motion, const Eigen::VectorXd& displacement) const {
  int largest = -1;
  for (int dof = 0; dof < motion.size(); ++dof) {
    if (!system_.is_unknown(dof)) continue;
    if (largest < 0 || std::abs(motion[dof]) > std::abs(motion[largest])) largest = dof;
  }
  return spring(largest / 2, largest % 2 == 0 ? 1 : 0, largest % 2 == 0 ? 0 : 1, displacement);
}

}  // namespace bempd::fracture
