#include "fracture/window/face_certificate.hpp"

#include <algorithm>

#include "fracture/contact/gap_rule.hpp"
#include "fracture/window/event_forecast.hpp"
#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

FaceCertificate::FaceCertificate(const std::vector<WatchedPlace>& places, const std::vector<ForecastEvent>& events,
                                 double from, bool proportional)
    : places_(places) {
  // All load factors are alike where displacements are proportional.
  double arrival = proportional ? 1 : from;
  for (std::size_t e = 0; e <= events.size(); ++e) {
    const double departure = proportional || e == events.size() ? arrival : events[e].event.load_factor;
    load_factors_.push_back({arrival, departure});
    arrival = departure;
  }
}

bool FaceCertificate::holds(const WatchedPlace& place, int state, double gap, double rate,
                            const std::array<double, 2>& largest) const {
  if (state < place.since || state >= place.until) return true;
  for (const double load_factor : load_factors_[static_cast<std::size_t>(state)]) {
    const double zero = gap_rounding(largest[0] + std::abs(load_factor) * largest[1]);
    const double here = gap + load_factor * rate;
    if (passed_zero(place.closed, here) > zero) return false;
  }
  return true;
}

bool FaceCertificate::overlaps(int state, double gap, double rate, const std::array<double, 2>& largest) const {
  const std::array<double, 2>& at = load_factors_[static_cast<std::size_t>(state)];
  return std::any_of(at.begin(), at.end(), [&](double load_factor) {
    const double zero = face_rounding(largest[0] + std::abs(load_factor) * largest[1]);
    return passed_zero(false, gap + load_factor * rate) > zero;
  });
}

int FaceCertificate::events_before_change(const std::vector<coupling::Affine>& kept, const std::vector<int>& dofs,
                                          const coupling::EquilibriumSystem& system, const OutsideGaps& outside) const {
  int last = static_cast<int>(kept.size()) - 1;
  if (is_idle() && outside.faces().empty()) return last;
  const coupling::Affine& prescribed = system.prescribed();
  std::vector<int> row(static_cast<std::size_t>(prescribed.rows()), -1);
  for (std::size_t i = 0; i < dofs.size(); ++i) row[dofs[i]] = static_cast<int>(i);
  const auto is_known = [&](int dof) { return row[dof] >= 0 || system.is_prescribed(dof); };
  std::vector<const WatchedPlace*> inside;
  for (const WatchedPlace& place : places_) {
    const auto known = [&](const coupling::TermEntry& e) { return is_known(2 * e.node) && is_known(2 * e.node + 1); };
    if (std::all_of(place.contact.pull.begin(), place.contact.pull.end(), known)) {
      inside.push_back(&place);
    } else if (!place.known && place.since < place.until) {
      last = std::min(last, std::max(place.since - 1, 0));
    }
  }
  std::array<Eigen::MatrixXd, 2> gaps;  // outside, of some states from `first` on
  int first = 0;
  for (int state = 0; state <= last; ++state) {
    const coupling::Affine& u = kept[state];
    const std::array<double, 2> largest{u.col(0).lpNorm<Eigen::Infinity>(), u.col(1).lpNorm<Eigen::Infinity>()};
    const auto value = [&](int dof, int part) { return row[dof] >= 0 ? u(row[dof], part) : prescribed(dof, part); };
    for (const WatchedPlace* place : inside) {
      Eigen::RowVector2d gap = Eigen::RowVector2d::Zero();
      for (const coupling::TermEntry& e : place->contact.pull) {
        for (const int part : {0, 1}) gap[part] += e.x * value(2 * e.node, part) + e.y * value(2 * e.node + 1, part);
      }
      if (!holds(*place, state, gap[0], gap[1], largest)) return std::max(state - 1, 0);
    }
    if (state - first >= gaps[0].cols()) {
      first = state;
      const int count = std::min(last + 1 - first, WindowSettings::states_swept_at_once);
      for (const int part : {0, 1}) gaps[part] = outside.at({kept.begin() + first, kept.begin() + first + count}, part);
    }
    for (std::size_t k = 0; k < outside.places().size(); ++k) {
      const auto of = static_cast<Eigen::Index>(k), at = static_cast<Eigen::Index>(state - first);
      if (!holds(places_[outside.places()[k]], state, gaps[0](of, at), gaps[1](of, at), largest))
        return std::max(state - 1, 0);
    }
    for (const OutsideGaps::Gap& gap : outside.faces())
      if (overlaps(state, gap.at(u, 0), gap.at(u, 1), largest)) return std::max(state - 1, 0);
  }
  return last;
}

}  // namespace bempd::fracture
