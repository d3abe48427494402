#include "fracture/window/face_watch.hpp"

#include <algorithm>

#include "fracture/window/lookahead.hpp"

namespace bempd::fracture {

FaceWatch::FaceWatch(CrackFaces& faces, const std::vector<ForeseenEvent>& events, double from, bool proportional) {
  if (faces.are_none()) return;
  std::vector<std::vector<int>> gone;
  for (const ForeseenEvent& foreseen : events) gone.push_back(coupling::terms_of(foreseen.event.changes));
  places_ = faces.watched(gone);
  // In proportion all load factors are alike.
  double arrival = proportional ? 1 : from;
  for (std::size_t e = 0; e <= events.size(); ++e) {
    const double departure = proportional || e == events.size() ? arrival : events[e].event.load_factor;
    load_factors_.push_back({arrival, departure});
    arrival = departure;
  }
}

int FaceWatch::events_before_change(const std::vector<coupling::Affine>& kept, const std::vector<int>& dofs,
                                    int dof_count) const {
  const int last = static_cast<int>(kept.size()) - 1;
  if (is_idle()) return last;
  std::vector<int> row(static_cast<std::size_t>(dof_count), -1);
  for (std::size_t i = 0; i < dofs.size(); ++i) row[dofs[i]] = static_cast<int>(i);
  std::vector<const WatchedPlace*> inside;
  for (const WatchedPlace& place : places_) {
    const auto is_kept = [&](const coupling::TermEntry& e) { return row[2 * e.node] >= 0 && row[2 * e.node + 1] >= 0; };
    if (std::all_of(place.contact.pull.begin(), place.contact.pull.end(), is_kept)) inside.push_back(&place);
  }
  for (int state = 1; state <= last; ++state) {
    const coupling::Affine& u = kept[state];
    const std::array<double, 2> largest{u.col(0).lpNorm<Eigen::Infinity>(), u.col(1).lpNorm<Eigen::Infinity>()};
    for (const WatchedPlace* place : inside) {
      const auto part = [&](int column) { return [&u, &row, column](int dof) { return u(row[dof], column); }; };
      if (!holds(*place, state, part(0), part(1), largest)) return state - 1;
    }
  }
  return last;
}

}  // namespace bempd::fracture
