#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

// Throws Error (argument) if a peridynamic neighbour would have other points on the interface: the spacings must be
// equal, and the interface must end at lattice points of the neighbour.
void OutlinedRegion::require_common_points(const Preparation& preparation, const Contact& contact) const {
  const int other = contact.other_region + 1;
  const auto* points = dynamic_cast<const PeridynamicDescription*>(&preparation.scene.region(other));
  if (!points) return;
  require(std::abs(points->spacing() / spacing() - 1) < 1e-9, "peridynamic regions ", id(), " and ", other,
          " touch, but their spacings are ", spacing(), " and ", points->spacing(), "; give them the same one");
  const auto grid = points->node_grid();
  const Edge edge = preparation.scene.region(id()).edge(contact.edge + 1);
  for (const Point& end : {edge.at(contact.from), edge.at(contact.to)}) {
    const Point scaled = grid ? Point((end - grid->origin) / grid->spacing) : Point::Zero();
    const Point nearest = scaled.array().round();
    require((scaled - nearest).norm() < 1e-6, "peridynamic regions ", id(), " and ", other, " touch as far as (",
            end.x(), ", ", end.y(), "), which is not a lattice point of region ", other,
            "; move that corner to a multiple of the spacing ", spacing(), " from the region's corner");
  }
}

std::vector<Point> OutlinedRegion::interface_points(const Preparation& preparation, const Contact& own) {
  divide_outline(preparation);
  const Edge edge = preparation.scene.region(id()).edge(own.edge + 1);
  std::vector<Point> found{edge.at(own.from)};
  for (const Piece& piece : pieces_) {
    const double middle = 0.5 * (piece.from + piece.to);
    const auto p = static_cast<std::size_t>(&piece - pieces_.data());
    if (piece.edge != own.edge + 1 || middle < own.from || middle > own.to) continue;
    for (int node = body_.chords.piece_start[p] + 1; node < body_.chords.piece_start[p + 1]; ++node)
      found.push_back(from_grid(body_.chords.nodes[node]));
    found.push_back(edge.at(piece.to));
  }
  return found;
}

// Flags of the pieces of the outline whose chords may differ in length. They lie on loops with interfaces. No neighbour
// relies on their points: the edge is free, or the elements there follow the points.
std::vector<char> OutlinedRegion::pieces_that_may_vary(const Preparation& preparation) const {
  std::vector<char> may_vary(pieces_.size(), 0);
  std::size_t first = 0;
  for (const std::vector<Arc>& loop : loops_) {
    bool has_interfaces = false;
    std::vector<char> fixed(loop.size(), 0);
    for (std::size_t a = 0; a < loop.size(); ++a) {
      const Piece& piece = pieces_[first + a];
      const double middle = 0.5 * (piece.from + piece.to);
      for (const Contact& c : preparation.arrangement.contacts) {
        if (c.region != id() - 1 || c.edge != piece.edge - 1 || middle < c.from || middle > c.to) continue;
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

std::vector<char> OutlinedRegion::shared_points(const Preparation& preparation) {
  std::vector<char> shared(body_.chords.nodes.size(), 0);
  body_.chords.kept = shared;
  for (const Contact& contact : preparation.arrangement.contacts) {
    if (contact.region != id() - 1) continue;
    const bool tied = preparation.scene.region(contact.other_region + 1).has_own_mesh(contact.other_edge + 1);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const Piece& piece = pieces_[p];
      if (piece.edge != contact.edge + 1 || piece.from < contact.from || piece.to > contact.to) continue;
      const int first = body_.chords.piece_start[p], end = body_.chords.piece_start[p + 1];
      for (int c = first; c < end; ++c) {
        for (const int node : {body_.chords.chords[c].first, body_.chords.chords[c].second}) {
          body_.chords.kept[node] = 1;
          if (!tied) shared[node] = 1;
        }
      }
      if (!tied) continue;
      if (piece.from == contact.from) shared[body_.chords.chords[first].first] = 1;
      if (piece.to == contact.to) shared[body_.chords.chords[end - 1].second] = 1;
    }
  }
  return shared;
}

// Ties the points on an interface to the elements of the region `leader`, as points of a row whose spacing is the
// length of the interface's chords.
void OutlinedRegion::follow(const LeadingElements& leading, int leader, coupling::NodeTies& ties) const {
  const Point &start = leading.places.front(), &end = leading.places.back();
  std::vector<int> points;
  for (int i = 0; i < body_.chords.count(); ++i)
    if (distance(Segment{start, end}, position(i)) < 1e-6 * spacing()) points.push_back(i);
  const auto along = [&](int i) { return (position(i) - start).dot(end - start); };
  std::sort(points.begin(), points.end(), [&](int i, int j) { return along(i) < along(j); });
  // An interface that ends at the mouth of a crack reaches half a chord beyond its last point.
  const double beyond = (position(points.front()) - start).norm() + (end - position(points.back())).norm();
  const double at_mouths = beyond > 1e-6 * spacing() ? beyond : 0;
  const double chord =
      points.size() > 1 ? ((end - start).norm() - at_mouths) / static_cast<double>(points.size() - 1) : spacing();
  tie_points(leading, leader, points, chord, ties);
}

}  // namespace bempd::regions
