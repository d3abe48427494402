#include "fracture/window/window_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fracture/window/window_settings.hpp"

namespace bempd::fracture {

// Whether events of a system may be computed in windows. Cell squares (wide terms) must break only with the bonds that
// they follow, because outside a window only bonds are watched.
bool has_window_form(const coupling::EquilibriumSystem& system) {
  return system.is_symmetric() && !system.response().has_offsets() && system.terms().wide_terms_only_follow();
}

WindowLocator::WindowLocator(coupling::EquilibriumSystem& system, const StretchRatios& ratios,
                             const std::vector<Point>& positions)
    : system_(system),
      ratios_(ratios),
      positions_(positions),
      spacing_(positions.size(), std::numeric_limits<double>::infinity()) {
  const coupling::Terms& bonds = system.terms();
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (bonds.is_wide(b)) continue;
    for (int node : {bonds.first[b], bonds.second[b]}) spacing_[node] = std::min(spacing_[node], bonds.length[b]);
  }
}

void WindowLocator::expect_cracks(const std::vector<int>& cut) {
  if (!has_window_form(system_) || cut.empty() || cut.size() > WindowSettings::most_cut_bonds) return;
  const ZoneShape shape{WindowSettings::length_of_expected * length_ahead(0)};
  std::vector<Zone> zones = zones_at_ends(cut, system_.terms(), positions_, spacing_, shape);
  std::vector<int> nodes = nodes_of(zones);
  if (is_too_large(nodes, shape)) return;
  keep(std::move(zones), std::move(nodes));
  expected_zones_ = zones_;
  expected_nodes_ = nodes_;
}

void WindowLocator::return_to_expected() {
  zones_ = expected_zones_;
  nodes_ = expected_nodes_;
  system_.factor().keep_last(nodes_);
}

void WindowLocator::go_back_to(WindowLocation memory) {
  zones_ = std::move(memory.zones);
  nodes_ = std::move(memory.nodes);
  system_.factor().keep_last(memory.are_last ? nodes_ : std::vector<int>());
}

// Sets the location of the window. Nodes that have terms to outside nodes are put first in the list, so that the
// stiffness of the outside is a corner block of the system's factor.
void WindowLocator::keep(std::vector<Zone> zones, std::vector<int> nodes) {
  zones_ = std::move(zones);
  nodes_ = std::move(nodes);
  mark_rim();
  std::stable_partition(nodes_.begin(), nodes_.end(), [&](int node) { return touches_outside_[node] != 0; });
  system_.factor().keep_last(nodes_);
}

double WindowLocator::length_ahead(double wanted) const {
  if (wanted > 0) return wanted;
  const double size = static_cast<double>(system_.counters().sparse_unknowns);
  return std::clamp(WindowSettings::length_at_20000_unknowns * std::sqrt(size / 20000), WindowSettings::least_length,
                    WindowSettings::most_length);
}

bool WindowLocator::is_too_large(const std::vector<int>& nodes, const ZoneShape& shape) const {
  return 2 * static_cast<double>(nodes.size()) >
         std::max(WindowSettings::least_most_unknowns, WindowSettings::most_unknowns_per_length * shape.ahead);
}

std::vector<int> WindowLocator::nodes_of(const std::vector<Zone>& zones) const {
  std::vector<int> nodes;
  for (int node = 0; node < system_.node_count(); ++node) {
    if (!std::isfinite(spacing_[node])) continue;
    if (!system_.unknowns().is_unknown(2 * node) && !system_.unknowns().is_unknown(2 * node + 1)) continue;
    const auto has = [&](const Zone& zone) { return zone.contains(positions_[node]); };
    if (std::any_of(zones.begin(), zones.end(), has)) nodes.push_back(node);
  }
  return nodes;
}

std::vector<char> WindowLocator::marks_of_nodes() const {
  std::vector<char> kept(system_.node_count(), 0);
  for (int node : nodes_) kept[node] = 1;
  return kept;
}

// Marks the rim of the window: nodes with terms to outside nodes that lie near the end of a zone. Bonds that end on
// such nodes are left to the next window, because the bonds outside would break soon after.
void WindowLocator::mark_rim() {
  std::vector<char> kept = marks_of_nodes();
  touches_outside_.assign(system_.node_count(), 0);
  for (int node = 0; node < system_.node_count(); ++node) {
    if (system_.unknowns().is_prescribed(2 * node) && system_.unknowns().is_prescribed(2 * node + 1)) kept[node] = 1;
  }
  const coupling::Terms& bonds = system_.terms();
  for (std::size_t b = 0; b < bonds.size(); ++b) {
    if (!system_.stages().intact()[b]) continue;
    bool some = false, all = true;
    bonds.for_each_node(b, [&](int node) { some = some || kept[node] != 0, all = all && kept[node] != 0; });
    if (some && !all) bonds.for_each_node(b, [&](int node) { touches_outside_[node] = 1; });
  }
  on_rim_ = touches_outside_;
  for (int node : nodes_) {
    const auto is_inside = [&](const Zone& zone) { return zone.is_inner(positions_[node]); };
    if (on_rim_[node] && std::any_of(zones_.begin(), zones_.end(), is_inside)) on_rim_[node] = 0;
  }
}

bool WindowLocator::is_far_from_rim(const std::vector<int>& bonds) const {
  return std::none_of(bonds.begin(), bonds.end(),
                      [&](int b) { return on_rim_[system_.terms().first[b]] || on_rim_[system_.terms().second[b]]; });
}

bool WindowLocator::still_holds(const std::vector<int>& hot) {
  if (nodes_.empty() || !system_.factor().keeps(nodes_)) return false;
  mark_rim();
  const std::vector<char> kept = marks_of_nodes();
  std::vector<coupling::StageChange> next;
  next.reserve(hot.size());
  for (const int b : hot) next.push_back(system_.stages().after_critical(b));
  bool all_kept = true;
  for (const coupling::StageChange& c : system_.stages().with_followers(std::move(next))) {
    system_.terms().for_each_node(static_cast<std::size_t>(c.term),
                                  [&](int node) { all_kept = all_kept && kept[node] != 0; });
  }
  return all_kept && is_far_from_rim(hot);
}

std::vector<int> WindowLocator::hot_bonds(double load_factor, double share) const {
  const std::vector<char>& intact = system_.stages().intact();
  double largest = 0;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (intact[b]) largest = std::max(largest, ratios_.at(b, load_factor));
  }
  std::vector<int> hot;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (intact[b] && ratios_.at(b, load_factor) >= share * largest) hot.push_back(static_cast<int>(b));
  }
  return hot;
}

bool WindowLocator::choose(double load_factor, double tie_band, double ahead) {
  // Bonds at clamps and corners are nearly as close to breaking as bonds at crack tips in lattices with cell squares.
  // So in such lattices the present window is kept as long as it holds all bonds that are very close to breaking.
  if (!system_.terms().followers.empty() &&
      still_holds(hot_bonds(load_factor, WindowSettings::hot_share_in_present_window)))
    return true;
  const ZoneShape shape{length_ahead(ahead)};
  std::vector<double> shares(WindowSettings::hot_shares.begin(), WindowSettings::hot_shares.end());
  shares.push_back(tie_limit(tie_band));
  for (double share : shares) {
    const std::vector<int> hot = hot_bonds(load_factor, share);
    if (hot.size() > WindowSettings::most_hot_bonds) continue;
    if (still_holds(hot)) return true;
    std::vector<Zone> zones =
        zones_of(hot, ratios_, load_factor, system_.stages().intact(), positions_, spacing_, shape);
    std::vector<int> nodes = nodes_of(zones);
    if (nodes.empty() || is_too_large(nodes, shape)) continue;
    keep(std::move(zones), std::move(nodes));
    return true;
  }
  return false;
}

bool WindowLocator::choose(const std::vector<PathAhead>& paths, double ahead) {
  std::vector<int> next;
  for (const PathAhead& path : paths) next.insert(next.end(), path.bonds.begin(), path.bonds.end());
  std::sort(next.begin(), next.end());
  next.erase(std::unique(next.begin(), next.end()), next.end());
  if (next.empty()) return false;
  if (still_holds(next)) return true;
  ZoneShape shape{length_ahead(ahead)};
  std::vector<Zone> zones;
  for (const PathAhead& path : paths) {
    if (path.bonds.empty()) continue;
    const double spacing = spacing_[system_.terms().first[path.bonds.front()]];
    const double reach = path.horizon / spacing + WindowSettings::margin_beside_path;
    shape.half_width = std::max(shape.half_width, reach);
    shape.back = std::max(shape.back, reach);
    zones.push_back(zone_ahead(path.from, path.direction, spacing, shape));
  }
  std::vector<int> nodes = nodes_of(zones);
  if (nodes.empty() || is_too_large(nodes, shape)) return false;
  keep(std::move(zones), std::move(nodes));
  return true;
}

}  // namespace bempd::fracture
