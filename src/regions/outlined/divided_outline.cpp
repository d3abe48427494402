#include "regions/outlined/divided_outline.hpp"

#include <algorithm>
#include <numbers>

#include "error.hpp"
#include "pd/outlined/outlined_body.hpp"
#include "pd/outlined/surface_balance.hpp"

namespace bempd::regions {

namespace {

// Least length of a piece of the outline between two required places, in spacings.
constexpr double shortest_piece = 0.75;

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

}  // namespace

// Fractions of the edge, within `part`, at which pieces of the outline end: the ends of interfaces, and places that
// supports, loads and cracks need, where the pieces on both sides have room for a chord.
std::vector<double> DividedOutline::stations_on(const Preparation& preparation, const BorderPart& part) const {
  const Edge edge = preparation.scene.region(part.region).edge(part.edge);
  const double length = edge.length() / grid_.spacing(), room = shortest_piece / length;
  std::vector<double> wanted, stations = preparation.arrangement.breakpoints[part.region - 1][part.edge - 1];
  stations.insert(stations.end(), {0.0, 1.0});
  if (edge.piece_count() > 1) stations.push_back(edge.joint());
  std::sort(stations.begin(), stations.end());
  for (const auto* conditions : {&preparation.scene.supports(), &preparation.scene.loads()}) {
    for (const scene::Condition& condition : *conditions) {
      if (condition.removed()) continue;
      const auto breaks = condition.place->breaks_on(preparation.scene, part.region, part.edge, preparation.tolerance);
      wanted.insert(wanted.end(), breaks.begin(), breaks.end());
    }
  }
  // The mouth of a crack (where the crack meets an edge) has to lie in the middle of a chord, so chords have to end
  // half a spacing to either side of the mouth.
  for (const scene::Crack& crack : preparation.scene.cracks()) {
    for (const Point& p : crack.given()) {
      if (distance(edge, p) > 8 * preparation.tolerance) continue;
      const double mouth = closest_fraction(edge, p);
      wanted.insert(wanted.end(), {mouth - 0.5 / length, mouth + 0.5 / length});
    }
  }
  for (const double f : wanted) {
    const auto& contacts = preparation.arrangement.contacts;
    const bool is_shared = std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
      return c.region == part.region - 1 && c.edge == part.edge - 1 && c.from < f && f < c.to;
    });
    if (is_shared) continue;
    const auto after = std::lower_bound(stations.begin(), stations.end(), f);
    if (after == stations.begin() || after == stations.end()) continue;
    if (f - after[-1] >= room && *after - f >= room) stations.insert(after, f);
  }
  std::erase_if(stations, [&](double f) { return f < part.from || f > part.to; });
  return stations;
}

bool DividedOutline::divide(const Preparation& preparation) {
  for (const std::vector<BorderPart>& loop : loops_around(regions_, preparation)) {
    loops_.emplace_back();
    for (const BorderPart& part : loop) {
      const Edge edge = preparation.scene.region(part.region).edge(part.edge);
      const std::vector<double> stations = stations_on(preparation, part);
      for (std::size_t s = 0; s + 1 < stations.size(); ++s) {
        const Arc piece = edge.part(stations[s], stations[s + 1]);
        const Arc arc{grid_.to_grid(piece.start), grid_.to_grid(piece.end), piece.sweep};
        pieces_.push_back({part.region, part.edge, stations[s], stations[s + 1], arc});
        loops_.back().push_back(arc);
      }
    }
  }
  if (pieces_.empty()) return false;
  chords_ = pd::make_chords(loops_);
  shared_nodes(preparation);
  // Chords of different lengths are tried if the points that neighbours rely on leave too few chords to balance the
  // outline.
  if (pd::imbalance(chords_, pd::balancing_factors(chords_)) > 1e-13)
    chords_ = pd::make_chords(loops_, pieces_that_may_vary(preparation));
  return true;
}

// Flags of the pieces of the outline whose chords may differ in length. They lie on loops with interfaces. No neighbour
// relies on their points: the edge is free, or the elements there follow the points.
std::vector<char> DividedOutline::pieces_that_may_vary(const Preparation& preparation) const {
  std::vector<char> may_vary(pieces_.size(), 0);
  std::size_t first = 0;
  for (const std::vector<Arc>& loop : loops_) {
    bool has_interfaces = false;
    std::vector<char> fixed(loop.size(), 0);
    for (std::size_t a = 0; a < loop.size(); ++a) {
      const Piece& piece = pieces_[first + a];
      const double middle = 0.5 * (piece.from + piece.to);
      for (const Contact& c : preparation.arrangement.contacts) {
        if (c.region != piece.region - 1 || c.edge != piece.edge - 1 || middle < c.from || middle > c.to) continue;
        const scene::Region& other = preparation.scene.region(c.other_region + 1);
        has_interfaces = true;
        fixed[a] = !other.has_elements() || other.has_own_mesh(c.other_edge + 1);
      }
    }
    for (std::size_t a = 0; a < loop.size(); ++a) may_vary[first + a] = has_interfaces && !fixed[a];
    first += loop.size();
  }
  return may_vary;
}

std::vector<char> DividedOutline::shared_nodes(const Preparation& preparation) {
  std::vector<char> shared(chords_.nodes.size(), 0);
  chords_.kept = shared;
  for (const Contact& contact : preparation.arrangement.contacts) {
    if (!is_around(contact.region + 1)) continue;
    const bool tied = preparation.scene.region(contact.other_region + 1).has_own_mesh(contact.other_edge + 1);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const Piece& piece = pieces_[p];
      if (piece.region != contact.region + 1 || piece.edge != contact.edge + 1 || piece.from < contact.from ||
          piece.to > contact.to)
        continue;
      const int first = chords_.piece_start[p], end = chords_.piece_start[p + 1];
      for (int c = first; c < end; ++c) {
        for (const int node : {chords_.chords[c].first, chords_.chords[c].second}) {
          chords_.kept[node] = 1;
          if (!tied) shared[node] = 1;
        }
      }
      if (!tied) continue;
      if (piece.from == contact.from) shared[chords_.chords[first].first] = 1;
      if (piece.to == contact.to) shared[chords_.chords[end - 1].second] = 1;
    }
  }
  return shared;
}

std::vector<Point> DividedOutline::places_on(const Edge& edge, const Contact& own) const {
  std::vector<Point> found{edge.at(own.from)};
  for (const Piece& piece : pieces_) {
    const double middle = 0.5 * (piece.from + piece.to);
    const auto p = static_cast<std::size_t>(&piece - pieces_.data());
    if (piece.region != own.region + 1 || piece.edge != own.edge + 1 || middle < own.from || middle > own.to) continue;
    for (int node = chords_.piece_start[p] + 1; node < chords_.piece_start[p + 1]; ++node)
      found.push_back(grid_.from_grid(chords_.nodes[node]));
    found.push_back(edge.at(piece.to));
  }
  return found;
}

void DividedOutline::require_possible_corners() const {
  const auto corner = pd::find_impossible_corner(chords_);
  if (!corner) return;
  const Point where = grid_.from_grid(chords_.nodes[corner->node]);
  const auto& [region, edge, from, to, arc] = pieces_[chords_.chords[corner->node].piece];
  require(degrees(corner->angle) > 60 + 1e-9, "region ", region, " has a corner of ", degrees(corner->angle),
          " degrees at (", where.x(), ", ", where.y(), "), where edge ", edge,
          " begins; bonds that pull only cannot carry a corner below 60 degrees: cut it off over two spacings (",
          2 * grid_.spacing(), "), or round it");
  require(false, "region ", region, " has a corner of ", degrees(corner->angle), " degrees at (", where.x(), ", ",
          where.y(), "), where edge ", edge, " begins, between points ", corner->before * grid_.spacing(), " and ",
          corner->behind * grid_.spacing(),
          " from it; there the two lengths have to be more alike: choose a spacing that "
          "divides the edges of the corner, or longer edges");
}

double DividedOutline::fraction(const pd::Chord& chord, double part) const {
  const Piece& piece = pieces_[chord.piece];
  return piece.from + (chord.from + part * (chord.to - chord.from)) * (piece.to - piece.from);
}

std::vector<pd::Chord> DividedOutline::chords_on(int region, int edge) const {
  std::vector<pd::Chord> found;
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    if (pieces_[p].region != region || pieces_[p].edge != edge) continue;
    found.insert(found.end(), chords_.chords.begin() + chords_.piece_start[p],
                 chords_.chords.begin() + chords_.piece_start[p + 1]);
  }
  return found;
}

}  // namespace bempd::regions
