#include "fracture/crack_fluid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bempd::fracture {

namespace {

// Distance beyond the ends of a facet (piece of crack face) or a bond, in spacings, within which the two still count as
// meeting, because bonds pass through points where facets join.
constexpr double rounding = 1e-6;

// Whether two segments (a, b) and (c, d) meet within `near`, ends included; parallel segments never do.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d, double near) {
  const Point along = b - a, other = d - c;
  const double area = cross(along, other);
  if (area == 0) return false;
  const double on_first = cross(Point(c - a), other) / area, on_other = cross(Point(c - a), along) / area;
  const double first = near / along.norm(), second = near / other.norm();
  return on_first >= -first && on_first <= 1 + first && on_other >= -second && on_other <= 1 + second;
}

}  // namespace

CrackFluid::CrackFluid(pd::FluidPaths paths, std::map<int, std::vector<int>> cut, const coupling::Terms& terms,
                       const std::vector<Point>& positions)
    : paths_(std::move(paths)),
      cut_(std::move(cut)),
      positions_(positions),
      facet_of_(terms.size(), -1),
      spacing_(std::numeric_limits<double>::infinity()) {
  int places = 0;
  for (std::size_t f = 0; f < paths_.facets.size(); ++f) {
    const pd::CrackFacet& facet = paths_.facets[f];
    facet_of_[static_cast<std::size_t>(facet.term)] = static_cast<int>(f);
    for (const int place : facet.places) places = std::max(places, place + 1);
    spacing_ = std::min(spacing_, (facet.to - facet.from).norm());
  }
  facets_at_ = linalg::make_adjacency(static_cast<std::size_t>(places), [&](const auto& add) {
    for (std::size_t f = 0; f < paths_.facets.size(); ++f)
      for (const int place : paths_.facets[f].places) add(place, static_cast<int>(f));
  });
  for (std::size_t f = 0; f < paths_.facets.size(); ++f)
    facets_in_[cell_of(0.5 * (paths_.facets[f].from + paths_.facets[f].to))].push_back(static_cast<int>(f));
}

CrackFluid::Cell CrackFluid::cell_of(const Point& place) const {
  const auto number = [&](double x) { return static_cast<std::int64_t>(std::floor(x / spacing_)); };
  return number(place.x()) * (std::int64_t{1} << 31) + number(place.y());
}

const std::vector<int>& CrackFluid::crossed_by(int bond, const coupling::Terms& terms) const {
  const auto [known, is_new] = crossed_.try_emplace(bond);
  std::vector<int>& found = known->second;
  if (!is_new) return found;
  const Point& a = positions_[static_cast<std::size_t>(terms.first[static_cast<std::size_t>(bond)])];
  const Point& b = positions_[static_cast<std::size_t>(terms.second[static_cast<std::size_t>(bond)])];
  const int parts = static_cast<int>(std::ceil(2 * (b - a).norm() / spacing_));
  for (int k = 0; k <= parts; ++k) {
    const Point place = a + (b - a) * k / parts;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto near = facets_in_.find(cell_of(place + spacing_ * Point(dx, dy)));
        if (near == facets_in_.end()) continue;
        for (const int f : near->second) {
          const pd::CrackFacet& facet = paths_.facets[static_cast<std::size_t>(f)];
          if (meet(a, b, facet.from, facet.to, rounding * spacing_)) found.push_back(f);
        }
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void CrackFluid::reach_facets(int crack, const std::vector<char>& intact, std::vector<int>& owner) const {
  std::vector<int> open;
  const auto reach = [&](int facet) {
    if (facet < 0 || owner[static_cast<std::size_t>(facet)] != 0) return;
    if (intact[static_cast<std::size_t>(paths_.facets[static_cast<std::size_t>(facet)].term)]) return;
    owner[static_cast<std::size_t>(facet)] = crack;
    open.push_back(facet);
  };
  for (const int term : cut_.at(crack)) reach(facet_of_[static_cast<std::size_t>(term)]);
  for (std::size_t k = 0; k < open.size(); ++k)
    for (const int place : paths_.facets[static_cast<std::size_t>(open[k])].places)
      for (const int next : facets_at_.of(place)) reach(next);
}

void CrackFluid::add_forces(const CrackPressures& pressures, const coupling::Terms& terms,
                            const std::vector<char>& intact, const std::vector<char>& unloaded,
                            coupling::Affine& force) const {
  std::vector<int> of_facet(paths_.facets.size(), 0), of_term(terms.size(), 0);
  for (const auto& [crack, pressure] : pressures) {
    for (const int bond : cut_.at(crack)) of_term[static_cast<std::size_t>(bond)] = crack;
    reach_facets(crack, intact, of_facet);
  }
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (intact[t] || of_term[t] != 0 || terms.is_wide(t)) continue;
    for (const int facet : crossed_by(static_cast<int>(t), terms))
      if (const int crack = of_facet[static_cast<std::size_t>(facet)]; crack != 0) of_term[t] = crack;
  }
  for (const coupling::Terms::Following& pair : terms.following)
    if (!intact[pair.follower] && of_term[pair.leader] != 0) of_term[pair.follower] = of_term[pair.leader];
  const auto push = [&](std::size_t t, int crack, double share) {
    bool loaded = true;
    terms.for_each_node(t, [&](int node) { loaded = loaded && !unloaded[static_cast<std::size_t>(node)]; });
    if (!loaded) return;
    const Eigen::RowVector2d size = share * paths_.push[t] * pressures.at(crack);
    terms.for_each_entry(
        t, [&](int node, double x, double y) { force.middleRows<2>(2 * node) += Eigen::Vector2d(x, y) * size; });
  };
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (of_term[t] != 0) push(t, of_term[t], 1);
  for (const auto& [term, share, crack] : paths_.weakened)
    if (const auto t = static_cast<std::size_t>(term); of_term[t] == 0 && pressures.contains(crack))
      push(t, crack, 1 - share);
}

}  // namespace bempd::fracture
