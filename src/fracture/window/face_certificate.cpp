#include "fracture/window/face_certificate.hpp"

#include <algorithm>

#include "fracture/contact/gap_rule.hpp"
#include "fracture/window/computed_events.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

FaceCertificate::FaceCertificate(const std::vector<WatchedConstraint>& constraints,
                                 const std::vector<ForecastEvent>& events, double from, bool proportional)
    : constraints_(constraints) {
  // If displacements are proportional to the load factor, the sign of a gap is the same at all of them, and 1 stands
  // for all.
  double arrival = proportional ? 1 : from;
  for (std::size_t e = 0; e <= events.size(); ++e) {
    const double departure = proportional || e == events.size() ? arrival : events[e].event.load_factor;
    load_factors_.push_back({arrival, departure});
    arrival = departure;
  }
}

bool FaceCertificate::holds(const WatchedConstraint& one, int state, double gap, double rate,
                            const std::array<double, 2>& largest) const {
  if (state < one.since || state >= one.until) return true;
  const std::array<double, 2>& at = load_factors_[static_cast<std::size_t>(state)];
  return std::none_of(at.begin(), at.end(), [&](double load_factor) {
    const double largest_displacement = largest[0] + std::abs(load_factor) * largest[1];
    return is_wrong(one.constraint, one.closed, gap + load_factor * rate, largest_displacement);
  });
}

int FaceCertificate::events_before_change(const std::vector<coupling::Affine>& kept, const std::vector<int>& dofs,
                                          const coupling::EquilibriumSystem& system, const OutsideGaps& outside) const {
  int last = static_cast<int>(kept.size()) - 1;
  if (constraints_.empty()) return last;
  const coupling::Affine& prescribed = system.load().prescribed();
  std::vector<int> row(static_cast<std::size_t>(prescribed.rows()), -1);
  for (std::size_t i = 0; i < dofs.size(); ++i) row[dofs[i]] = static_cast<int>(i);
  const auto is_known = [&](int dof) { return row[dof] >= 0 || system.unknowns().is_prescribed(dof); };
  std::vector<const WatchedConstraint*> inside;
  for (const WatchedConstraint& one : constraints_) {
    if (one.constraint.is_on(is_known)) {
      inside.push_back(&one);
    } else if (!one.known && one.since < one.until) {
      last = std::min(last, std::max(one.since - 1, 0));
    }
  }
  std::array<Eigen::MatrixXd, 2> gaps;  // of constraints outside the window, in some states from `first` on
  int first = 0;
  for (int state = 0; state <= last; ++state) {
    const coupling::Affine& u = kept[state];
    const std::array<double, 2> largest{u.col(0).lpNorm<Eigen::Infinity>(), u.col(1).lpNorm<Eigen::Infinity>()};
    const auto values = [&](int part) {
      return [&, part](int dof) { return row[dof] >= 0 ? u(row[dof], part) : prescribed(dof, part); };
    };
    for (const WatchedConstraint* one : inside) {
      const coupling::Constraint& its = one->constraint;
      if (!holds(*one, state, its.gap_at(values(0)), its.gap_at(values(1)), largest)) return std::max(state - 1, 0);
    }
    if (state - first >= gaps[0].cols()) {
      first = state;
      const int count = std::min(last + 1 - first, WindowSettings::states_swept_at_once);
      for (const int part : {0, 1}) gaps[part] = outside.at({kept.begin() + first, kept.begin() + first + count}, part);
    }
    for (std::size_t k = 0; k < outside.constraints().size(); ++k) {
      const auto of = static_cast<Eigen::Index>(k), at = static_cast<Eigen::Index>(state - first);
      const WatchedConstraint& one = constraints_[outside.constraints()[k]];
      if (!holds(one, state, gaps[0](of, at), gaps[1](of, at), largest)) return std::max(state - 1, 0);
    }
  }
  return last;
}

}  // namespace bempd::fracture
