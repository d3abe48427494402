#include "fracture/window/window_narrowing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

void WindowNarrowing::restart() { next_ = WindowSettings::breaks_between_narrowings; }

void WindowNarrowing::stop() { next_ = std::numeric_limits<std::size_t>::max(); }

std::vector<double> WindowNarrowing::rears(const WindowSolver& window, double load_factor) const {
  const AffineRatios& ratios = window.ratios();
  const coupling::Terms& bonds = system_.terms();
  const std::vector<Zone>& zones = locator_.zones();
  double largest = 0;
  for (std::size_t b = 0; b < window.bonds().size(); ++b) {
    if (window.intact()[b]) largest = std::max(largest, ratios.at(b, load_factor));
  }
  std::vector<double> rear(zones.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t b = 0; b < window.bonds().size(); ++b) {
    if (!window.intact()[b] || ratios.at(b, load_factor) < WindowSettings::hot_when_narrowing * largest) continue;
    const Point& p = positions_[bonds.first[window.bonds()[b]]];
    const Point& q = positions_[bonds.second[window.bonds()[b]]];
    for (std::size_t z = 0; z < zones.size(); ++z) {
      if (!zones[z].contains(p) && !zones[z].contains(q)) continue;
      const double place = std::min(zones[z].coordinates(p).x(), zones[z].coordinates(q).x());
      rear[z] = std::isfinite(rear[z]) ? std::min(rear[z], place) : place;
    }
  }
  return rear;
}

bool WindowNarrowing::is_needed(int node, const std::vector<double>& rear) const {
  for (std::size_t z = 0; z < rear.size(); ++z) {
    const Zone& zone = locator_.zones()[z];
    if (!zone.contains(positions_[node])) continue;
    if (zone.coordinates(positions_[node]).x() > rear[z] - behind_hot_ * locator_.spacing(node)) {
      return true;
    }
  }
  return false;
}

bool WindowNarrowing::is_due(const WindowSolver& window) {
  if (window.breaks() < next_) return false;
  next_ = window.breaks() + WindowSettings::breaks_between_narrowings;
  return true;
}

void WindowNarrowing::narrow(WindowSolver& window, const std::vector<int>& dofs, double load_factor) {
  if (is_due(window)) leave(window, dofs, rears(window, load_factor));
}

void WindowNarrowing::narrow(WindowSolver& window, const std::vector<int>& dofs, const std::vector<Reach>& tips) {
  if (!is_due(window)) return;
  std::vector<double> rear(locator_.zones().size(), std::numeric_limits<double>::infinity());
  for (std::size_t z = 0; z < rear.size(); ++z) {
    const Zone& zone = locator_.zones()[z];
    for (const Reach& tip : tips)
      if (zone.contains(tip.place)) rear[z] = std::min(rear[z], zone.coordinates(tip.place).x() - tip.back);
  }
  leave(window, dofs, rear);
}

void WindowNarrowing::leave(WindowSolver& window, const std::vector<int>& dofs, const std::vector<double>& rear) const {
  std::vector<char> leaves;
  int leaving = 0;
  for (int dof : dofs) {
    const bool needed = is_needed(dof / 2, rear);
    leaves.push_back(needed ? 0 : 1);
    leaving += needed ? 0 : 1;
  }
  const int followed = window.followed(), dropped = static_cast<int>(leaves.size()) - followed;
  if (leaving - dropped >= WindowSettings::least_narrowing * followed) window.narrow(leaves);
}

}  // namespace bempd::fracture
