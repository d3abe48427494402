#include "regions/boundary/boundary_meshing.hpp"

#include <algorithm>

#include "error.hpp"
#include "geometry/coarse_sizes.hpp"
#include "geometry/halving.hpp"
#include "geometry/segment.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/boundary/corner_grading.hpp"
#include "regions/boundary/grid_borders.hpp"
#include "regions/outlined/outlined_region.hpp"

namespace bempd::regions {

using scene::Condition;
using scene::EdgeMesh;
using scene::Scene;

namespace {

// Contact (interface) that an edge has at a fraction of its length; null if the edge is free there. The fraction must
// not be an end of a contact.
const Contact* contact_at(const Arrangement& arrangement, int region, int edge, double fraction) {
  for (const Contact& contact : arrangement.contacts) {
    if (contact.region == region - 1 && contact.edge == edge - 1 && contact.from < fraction && fraction < contact.to) {
      return &contact;
    }
  }
  return nullptr;
}

// Neighbour at a contact, if the neighbour is a region with points on its outline; null for other regions.
OutlinedRegion* outlined_at(const Preparation& p, const Contact& contact) {
  const auto reaches = [](const std::unique_ptr<Region>& region, int wanted) { return region->id() < wanted; };
  const auto found = std::lower_bound(p.regions.begin(), p.regions.end(), contact.other_region + 1, reaches);
  return dynamic_cast<OutlinedRegion*>(found->get());
}

Border border_of(const Preparation& p, const Contact* contact) {
  if (!contact) return Border::free;
  const bool has_places = p.node_grid(contact->other_region + 1) || outlined_at(p, *contact);
  return has_places ? Border::grid : Border::elements;
}

// Fractions of an edge where panels have to end because of the region itself: corners, interfaces, supports and loads.
std::vector<double> own_breaks(const Preparation& p, int region, int edge) {
  std::vector<double> breaks = p.arrangement.breakpoints[region - 1][edge - 1];
  breaks.push_back(p.scene.region(region).edge(edge).joint());
  for (const std::vector<Condition>* conditions : {&p.scene.supports(), &p.scene.loads()}) {
    for (const Condition& condition : *conditions) {
      if (condition.removed()) continue;
      for (double fraction : condition.place->breaks_on(p.scene, region, edge, p.tolerance)) {
        // Ends of supports and loads are ignored on interfaces with lattices, where elements end at material points.
        if (border_of(p, contact_at(p.arrangement, region, edge, fraction)) != Border::grid) breaks.push_back(fraction);
      }
    }
  }
  return breaks;
}

std::vector<double> all_breaks(const Preparation& p, int region, int edge, const std::vector<Point>& mouths) {
  std::vector<double> breaks = own_breaks(p, region, edge);
  const Edge whole = p.scene.region(region).edge(edge);
  for (const Point& mouth : mouths)
    if (least_distance(whole, mouth) <= 16 * p.tolerance && distance(whole, mouth) <= 8 * p.tolerance)
      breaks.push_back(closest_fraction(whole, mouth));
  for (const Contact& contact : p.arrangement.contacts) {
    if (contact.region != region - 1 || contact.edge != edge - 1) continue;
    if (border_of(p, &contact) != Border::elements) continue;
    const double span = contact.other_to - contact.other_from;
    for (double theirs : own_breaks(p, contact.other_region + 1, contact.other_edge + 1)) {
      const double share = (theirs - contact.other_from) / span;
      if (share > 0 && share < 1) breaks.push_back(contact.from + share * (contact.to - contact.from));
    }
  }
  breaks.push_back(0);
  breaks.push_back(1);
  std::sort(breaks.begin(), breaks.end());
  const double close = p.tolerance / whole.length();
  std::vector<double> distinct{0.0};
  for (double fraction : breaks) {
    if (fraction - distinct.back() > close) distinct.push_back(fraction);
  }
  if (1 - distinct.back() <= close && distinct.size() > 1) distinct.pop_back();
  distinct.push_back(1);
  return distinct;
}

// Element ends on an interface between two boundary element regions, as fractions of the piece. Both regions get the
// elements of the region with the shorter element length, or with the lower id if both lengths are equal.
std::vector<double> shared_stations(const Scene& scene, int region, int edge, const Contact& contact,
                                    const Arc& piece) {
  const int other = contact.other_region + 1;
  const EdgeMesh ours = scene.region(region).edge_mesh(edge);
  const EdgeMesh theirs = scene.region(other).edge_mesh(contact.other_edge + 1);
  const bool lower = region < other;
  const EdgeMesh& first = lower ? ours : theirs;
  const EdgeMesh& second = lower ? theirs : ours;
  const EdgeMesh& mesh = second.element_length < first.element_length ? second : first;
  return element_stations(piece.length(), mesh.element_length, mesh.grading, piece.sweep);
}

// Piece of a boundary from which a panel comes, with the displacement components that supports hold on this piece and
// the loads that act on it.
BoundaryPiece piece_of(const Scene& scene, int region, const PanelSource& source, const Arc& arc) {
  BoundaryPiece piece{arc, HeldComponents::interface, 0, {}};
  if (source.border != Border::free) return piece;
  const double middle = 0.5 * (source.from + source.to);
  const auto acts = [&](const Condition& one) {
    return !one.removed() && one.place->covers(region, source.edge, middle);
  };
  for (const Condition& support : scene.supports())
    if (acts(support)) piece.components |= support.components;
  for (std::size_t l = 0; l < scene.loads().size(); ++l)
    if (acts(scene.loads()[l])) piece.loads.push_back(static_cast<int>(l) + 1);
  constexpr int both = 3;
  piece.held = piece.components == 0      ? HeldComponents::none
               : piece.components == both ? HeldComponents::both
                                          : HeldComponents::one;
  return piece;
}

// Distance up to which the error at a singular place affects the stress intensity factors of a crack, relative to the
// length of the element next to that place.
constexpr double reach_of_corners = 8;

bool is_near_crack(const Preparation& p, int region, const Point& x, double reach) {
  for (const PartedCrack& crack : p.cracks) {
    for (const CrackPart& part : crack.parts) {
      if (part.region == region && polyline_distance(part.points, x) < reach) return true;
    }
  }
  return false;
}

// Numbers of divisions at those singular ends of a panel that are close to a crack of the region; 0 at other ends. On
// edges with an element length that the host has chosen, elements are graded only towards these ends.
EndDivisions near_cracks(const Preparation& p, int region, const Panel& panel, EndDivisions divisions) {
  const std::vector<double>& stations = panel.stations;
  const double reach = reach_of_corners * panel.arc().length();
  const double first = reach * stations[1], last = reach * (1 - stations[stations.size() - 2]);
  if (divisions.start > 0 && !is_near_crack(p, region, panel.start, first)) divisions.start = 0;
  if (divisions.end > 0 && !is_near_crack(p, region, panel.end, last)) divisions.end = 0;
  return divisions;
}

// Length of the shortest element that grading makes, in geometric tolerances. After a few halvings of such an element,
// the places of its ends still differ in many digits.
constexpr double shortest_graded = 10;

// Grades elements towards places where stress is singular, and in bodies also towards jumps of tractions.
void grade_corners(const Preparation& p, int region, BoundaryPanels& panels) {
  const scene::Region& described = p.scene.region(region);
  const DivisionRule rule =
      is_body(described) ? divisions_for(p.options.number("error.wanted"), p.scene.material_of(region).elasticity)
                         : DivisionRule(usual_divisions);
  std::size_t first = 0;
  for (auto& loop : panels.loops) {
    std::vector<BoundaryPiece> pieces;
    pieces.reserve(loop.size());
    for (std::size_t k = 0; k < loop.size(); ++k)
      pieces.push_back(piece_of(p.scene, region, panels.sources[first + k], loop[k].arc()));
    const std::vector<EndDivisions> divisions = end_divisions(pieces, rule);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (pieces[k].held == HeldComponents::interface) continue;
      const bool is_chosen = described.has_own_mesh(panels.sources[first + k].edge);
      loop[k].stations = graded_stations(is_chosen ? near_cracks(p, region, loop[k], divisions[k]) : divisions[k],
                                         loop[k].stations, shortest_graded * p.tolerance / loop[k].arc().length());
    }
    first += loop.size();
  }
}

// Gives the free edges of a body the coarsest useful elements (CoarseSizes), except edges for which the host has chosen
// the elements.
void choose_sizes(const scene::Region& described, BoundaryPanels& panels) {
  const CoarseSizes sizes(panels.loops);
  int number = 0;
  for (auto& loop : panels.loops)
    for (Panel& panel : loop) {
      const PanelSource& source = panels.sources[static_cast<std::size_t>(number)];
      if (source.border == Border::free && !described.has_own_mesh(source.edge))
        panel.stations = sizes.stations(number);
      ++number;
    }
}

// Element ends on a piece of an edge, as fractions of the piece.
std::vector<double> stations_of(const Preparation& p, const MeshingRules& rules, int region, const PanelSource& source,
                                const Contact* contact, const Arc& piece, const std::vector<Point>& mouths) {
  if (source.border == Border::elements) return shared_stations(p.scene, region, source.edge, *contact, piece);
  const scene::Region& described = p.scene.region(region);
  if (source.border == Border::grid && !described.has_own_mesh(source.edge))
    return grid_stations(p, *contact, piece, rules.nodes_on_grids ? 2 : 1, mouths);
  const EdgeMesh mesh = described.edge_mesh(source.edge);
  return element_stations(piece.length(), mesh.element_length, mesh.grading, piece.sweep);
}

// Adds panels on an interface with a region that has points on its outline. There is one element for each chord between
// these points, unless the host has chosen the element length, which is possible on straight edges only.
void follow_outline(const Preparation& p, OutlinedRegion& other, PanelSource source, const Contact& contact,
                    const Arc& piece, const std::vector<Point>& mouths, BoundaryPanels& result) {
  const scene::Region& described = p.scene.region(contact.region + 1);
  const auto add = [&](const Panel& panel) {
    result.loops.back().push_back(panel);
    result.sources.push_back(source);
  };
  if (described.has_own_mesh(source.edge)) {
    require(piece.straight(), "edge ", source.edge, " of region ", contact.region + 1,
            " is round and an interface with the peridynamic region ", contact.other_region + 1,
            "; there its elements follow the material points: leave out bempd_set_edge_mesh() for it");
    const EdgeMesh mesh = described.edge_mesh(source.edge);
    source.tied = true;
    return add({piece.start, piece.end, element_stations(piece.length(), mesh.element_length, mesh.grading, 0), 0});
  }
  const std::vector<Point> points = points_of_neighbour(p, other, source, contact, piece, mouths);
  const std::size_t count = points.size() - 1;
  if (piece.straight()) {
    std::vector<double> stations;
    stations.reserve(points.size());
    for (const Point& at : points) stations.push_back((at - piece.start).norm() / piece.length());
    stations.back() = 1;
    return add({piece.start, piece.end, stations, 0});
  }
  const double from = source.from, step = (source.to - from) / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    source.from = from + step * static_cast<double>(k), source.to = source.from + step;
    add({points[k], points[k + 1], {0, 1}, 0});
  }
}

void mesh_edge(const Preparation& p, const MeshingRules& rules, int region, int edge, const std::vector<Point>& mouths,
               BoundaryPanels& result) {
  const scene::Region& described = p.scene.region(region);
  const Edge whole = described.edge(edge);
  const std::vector<double> breaks = all_breaks(p, region, edge, mouths);
  for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
    const Arc piece = whole.part(breaks[b], breaks[b + 1]);
    const Contact* contact = contact_at(p.arrangement, region, edge, 0.5 * (breaks[b] + breaks[b + 1]));
    const Border border = border_of(p, contact);
    if (OutlinedRegion* other = contact ? outlined_at(p, *contact) : nullptr) {
      const PanelSource source{edge, breaks[b], breaks[b + 1], border, contact->other_region + 1, false};
      follow_outline(p, *other, source, *contact, piece, mouths, result);
      continue;
    }
    if (border == Border::grid) require_grid_ends(p, *contact, piece, mouths);
    const bool tied = border == Border::grid && described.has_own_mesh(edge) && !rules.nodes_on_grids;
    const PanelSource source{edge, breaks[b], breaks[b + 1], border, contact ? contact->other_region + 1 : 0, tied};
    result.loops.back().push_back(
        {piece.start, piece.end, stations_of(p, rules, region, source, contact, piece, mouths), piece.sweep});
    result.sources.push_back(source);
  }
}

}  // namespace

std::vector<Point> panel_ends(const Preparation& preparation, int region) {
  std::vector<Point> places;
  const scene::Region& described = preparation.scene.region(region);
  for (int edge = 1; edge <= described.edge_count(); ++edge)
    for (const double fraction : all_breaks(preparation, region, edge, {}))
      places.push_back(described.edge(edge).at(fraction));
  return places;
}

BoundaryPanels mesh_edges(const Preparation& preparation, const MeshingRules& rules, int region,
                          const std::vector<Point>& mouths) {
  BoundaryPanels result;
  int edge = 0;
  for (const auto& loop : preparation.scene.region(region).outline().loops) {
    result.loops.emplace_back();
    for (std::size_t k = 0; k < loop.size(); ++k) mesh_edge(preparation, rules, region, ++edge, mouths, result);
  }
  if (const scene::Region& described = preparation.scene.region(region); is_body(described))
    choose_sizes(described, result);
  if (rules.grade_corners) grade_corners(preparation, region, result);
  return result;
}

void halve_elements(const Preparation& preparation, int region, BoundaryPanels& panels) {
  const scene::Scene& scene = preparation.scene;
  const scene::Region& described = scene.region(region);
  const int own = halvings_of(described);
  const auto* body = dynamic_cast<const BoundaryDescription*>(&described);
  std::size_t number = 0;
  for (auto& loop : panels.loops)
    for (Panel& panel : loop) {
      const PanelSource& source = panels.sources[number++];
      if (source.border == Border::grid && (!source.tied || (body && body->borders_patch(source.edge)))) continue;
      const bool is_shared = source.border == Border::elements;
      const int other = is_shared ? halvings_of(scene.region(source.other_region)) : own;
      panel.stations = halved(std::move(panel.stations), std::max(own, other));
    }
}

}  // namespace bempd::regions
