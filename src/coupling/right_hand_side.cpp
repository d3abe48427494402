#include "coupling/right_hand_side.hpp"

namespace bempd::coupling {

Affine RightHandSide::sum() const {
  Affine load = parts_.operators.load();
  Affine support = parts_.load.prescribed();
  parts_.ties.expand(support);
  add_supports_of_terms(support, load);
  add_supports_of_penalties(support, load);
  add_supports_of_springs(support, load);
  if (parts_.terms.have_offsets()) add_offsets(load);
  parts_.ties.collect(load);
  return load(parts_.unknowns.dof_of, Eigen::all);
}

// Adds to `load` the forces of terms that are attached to prescribed displacements (`support`).
void RightHandSide::add_supports_of_terms(const Affine& support, Affine& load) const {
  const Terms& terms = parts_.terms;
  const std::vector<double>& stiffness = parts_.stages.stiffness();
  const auto is_free = [&](int node) {
    return parts_.unknowns.is_unknown(2 * node) && parts_.unknowns.is_unknown(2 * node + 1);
  };
  const auto add = [&](std::size_t t) {
    if (stiffness[t] == 0) return;
    const Eigen::RowVector2d tension = stiffness[t] * Eigen::RowVector2d(terms.elongation(t, support.col(0).data()),
                                                                         terms.elongation(t, support.col(1).data()));
    terms.for_each_entry(t, [&](int node, double x, double y) {
      load.row(2 * node) -= x * tension;
      load.row(2 * node + 1) -= y * tension;
    });
  };
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!is_free(terms.first[t]) || !is_free(terms.second[t])) {
      if (!terms.is_wide(t)) add(t);
    }
  }
  for (int t : terms.wide.term) add(static_cast<std::size_t>(t));
}

void RightHandSide::add_supports_of_penalties(const Affine& support, Affine& load) const {
  parts_.constraints.for_each_closed_penalty([&](const Constraint& constraint) {
    const Eigen::RowVector2d tension = constraint.stiffness * Eigen::RowVector2d(constraint.gap(support.col(0).data()),
                                                                                 constraint.gap(support.col(1).data()));
    for (const TermEntry& e : constraint.pull) {
      load.row(2 * e.node) -= e.x * tension;
      load.row(2 * e.node + 1) -= e.y * tension;
    }
  });
}

void RightHandSide::add_supports_of_springs(const Affine& support, Affine& load) const {
  for (const HoldingSpring& s : parts_.springs) {
    const int x = 2 * s.node;
    const Eigen::RowVector2d moved = s.cosine * support.row(x) + s.sine * support.row(x + 1);
    Eigen::RowVector2d pull = -s.stiffness * moved;
    pull[0] += s.stiffness * s.anchor;
    load.row(x) += s.cosine * pull;
    load.row(x + 1) += s.sine * pull;
  }
}

// Adds to `load` the forces of the terms' rest elongations e0: at zero displacement a term has the tension -k e0.
void RightHandSide::add_offsets(Affine& load) const {
  const Terms& terms = parts_.terms;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!parts_.stages.intact()[t]) continue;
    const double k = parts_.stages.stiffness()[t];
    const Eigen::RowVector2d tension(-k * terms.rest(t, 0), -k * terms.rest(t, 1));
    if (tension.isZero(0)) continue;
    terms.for_each_entry(t, [&](int node, double x, double y) {
      load.row(2 * node) -= x * tension;
      load.row(2 * node + 1) -= y * tension;
    });
  }
}

}  // namespace bempd::coupling
