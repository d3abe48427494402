#include <algorithm>
#include <cmath>

#include "error.hpp"
#include "regions/boundary/boundary_part.hpp"
#include "regions/boundary/corner_grading.hpp"

namespace bempd::model {

namespace {

// The contact that a piece of an edge belongs to, or null. Breakpoints lie at the ends of all contacts.
const Contact* contact_at(const Arrangement& arrangement, int region, int edge, double fraction) {
  for (const Contact& contact : arrangement.contacts) {
    if (contact.region == region - 1 && contact.edge == edge - 1 && contact.from < fraction && fraction < contact.to) {
      return &contact;
    }
  }
  return nullptr;
}

Border border_of(const Scene& scene, const Contact* contact) {
  if (!contact) return Border::free;
  return scene.region(contact->other_region + 1).kind == RegionKind::peridynamics ? Border::peridynamics
                                                                                  : Border::boundary_elements;
}

// Fractions of an edge where supports or loads begin, end or act on a point.
std::vector<double> condition_breaks(const Scene& scene, int region, int edge, double tolerance) {
  std::vector<double> breaks;
  const Edge whole = scene.region(region).edge(edge);
  const auto collect = [&](const std::vector<Condition>& conditions) {
    for (const Condition& condition : conditions) {
      if (const auto* part = std::get_if<EdgePart>(&condition.place)) {
        if (part->region != region || part->edge != edge) continue;
        breaks.push_back(part->from);
        breaks.push_back(part->to);
      } else if (const Point& p = std::get<Point>(condition.place); distance(whole, p) <= tolerance) {
        breaks.push_back(closest_fraction(whole, p));
      }
    }
  };
  collect(scene.supports());
  collect(scene.loads());
  return breaks;
}

// Places where panels of an edge end, without those that its neighbours ask for.
std::vector<double> own_breaks(const Scene& scene, const Arrangement& arrangement, double tolerance, int region,
                               int edge) {
  std::vector<double> breaks = arrangement.breakpoints[region - 1][edge - 1];
  breaks.push_back(scene.region(region).edge(edge).joint());
  for (double fraction : condition_breaks(scene, region, edge, tolerance)) {
    // On a lattice interface the elements follow the lattice.
    if (border_of(scene, contact_at(arrangement, region, edge, fraction)) != Border::peridynamics) {
      breaks.push_back(fraction);
    }
  }
  return breaks;
}

std::vector<double> all_breaks(const Scene& scene, const Arrangement& arrangement, double tolerance, int region,
                               int edge) {
  std::vector<double> breaks = own_breaks(scene, arrangement, tolerance, region, edge);
  for (const Contact& contact : arrangement.contacts) {
    if (contact.region != region - 1 || contact.edge != edge - 1) continue;
    if (border_of(scene, &contact) != Border::boundary_elements) continue;
    const double span = contact.other_to - contact.other_from;
    for (double theirs : own_breaks(scene, arrangement, tolerance, contact.other_region + 1, contact.other_edge + 1)) {
      const double share = (theirs - contact.other_from) / span;
      if (share > 0 && share < 1) breaks.push_back(contact.from + share * (contact.to - contact.from));
    }
  }
  breaks.push_back(0);
  breaks.push_back(1);
  std::sort(breaks.begin(), breaks.end());
  const double close = tolerance / scene.region(region).edge(edge).length();
  std::vector<double> distinct{0.0};
  for (double fraction : breaks) {
    if (fraction - distinct.back() > close) distinct.push_back(fraction);
  }
  if (1 - distinct.back() <= close && distinct.size() > 1) distinct.pop_back();
  distinct.push_back(1);
  return distinct;
}

EdgeMesh mesh_of(const Region& region, int edge) {
  const auto found = region.edge_mesh.find(edge);
  return found != region.edge_mesh.end() ? found->second : EdgeMesh{region.element_length, 1.0};
}

void require_lattice_ends(const Scene& scene, int region, const Contact& contact, const Arc& piece, double tolerance) {
  const Region& lattice = scene.region(contact.other_region + 1);
  const double spacing = lattice.lattice.spacing;
  for (const Point& end : {piece.start, piece.end}) {
    const Point scaled = (end - lattice.lattice.origin) / spacing;
    const Point nearest = scaled.array().round();
    require((scaled - nearest).norm() * spacing <= 100 * tolerance, "the interface between region ", region,
            " and the peridynamic region ", contact.other_region + 1, " ends at (", end.x(), ", ", end.y(),
            "), which is not a lattice point; move that corner to a multiple of the spacing ", spacing,
            " from the peridynamic region's corner, such as (", lattice.lattice.origin.x() + spacing * nearest.x(),
            ", ", lattice.lattice.origin.y() + spacing * nearest.y(), ")");
  }
}

// Element ends on lattice points; in scheme `paper` every node is one, but for the last of an odd number of spacings.
std::vector<double> lattice_stations(const Scene& scene, const Contact& contact, const Arc& piece,
                                     const Formulation& formulation) {
  const double spacing = scene.region(contact.other_region + 1).lattice.spacing;
  const int count = static_cast<int>(std::lround(piece.length() / spacing)), step = formulation.paper ? 2 : 1;
  std::vector<double> stations;
  for (int i = 0; i < count; i += step) stations.push_back(static_cast<double>(i) / count);
  stations.push_back(1);
  return stations;
}

// Both sides of an interface must come to the same elements: the finer wish counts, seen from the lower region number.
std::vector<double> shared_stations(const Scene& scene, int region, int edge, const Contact& contact,
                                    const Arc& piece) {
  const int other = contact.other_region + 1;
  const EdgeMesh ours = mesh_of(scene.region(region), edge);
  const EdgeMesh theirs = mesh_of(scene.region(other), contact.other_edge + 1);
  const bool lower = region < other;
  const EdgeMesh& first = lower ? ours : theirs;
  const EdgeMesh& second = lower ? theirs : ours;
  const EdgeMesh& mesh = second.element_length < first.element_length ? second : first;
  return element_stations(piece.length(), mesh.element_length, mesh.grading, piece.sweep);
}

// Components of the displacement that supports hold on a piece of an edge.
Held held_on(const Scene& scene, int region, const PanelSource& source) {
  if (source.border != Border::free) return Held::interface;
  const double middle = 0.5 * (source.from + source.to);
  int components = 0;
  for (const Condition& support : scene.supports()) {
    const auto* part = std::get_if<EdgePart>(&support.place);
    if (!part || part->region != region || part->edge != source.edge) continue;
    if (part->from <= middle && middle <= part->to) components |= support.components;
  }
  constexpr int both = 3;
  return components == 0 ? Held::nothing : components == both ? Held::both_components : Held::one_component;
}

// Smaller elements towards singular places, where the host has not chosen the elements.
void grade_corners(const Scene& scene, int region, BoundaryPanels& panels) {
  std::size_t first = 0;
  for (auto& loop : panels.loops) {
    std::vector<BoundaryPiece> pieces;
    for (std::size_t p = 0; p < loop.size(); ++p)
      pieces.push_back({loop[p].arc(), held_on(scene, region, panels.sources[first + p])});
    const std::vector<SingularEnds> singular = singular_ends(pieces);
    for (std::size_t p = 0; p < loop.size(); ++p)
      if (pieces[p].held != Held::interface && !scene.region(region).has_own_mesh(panels.sources[first + p].edge))
        loop[p].stations = refined_towards(singular[p], loop[p].stations);
    first += loop.size();
  }
}

}  // namespace

BoundaryPanels mesh_edges(const Scene& scene, const Arrangement& arrangement, const Formulation& formulation,
                          double tolerance, int region_id) {
  const Region& region = scene.region(region_id);
  BoundaryPanels result;
  int edge = 0;
  for (const auto& loop : region.outline.loops) {
    result.loops.emplace_back();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      ++edge;
      const Edge whole = region.edge(edge);
      const std::vector<double> breaks = all_breaks(scene, arrangement, tolerance, region_id, edge);
      for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
        const Arc piece = whole.part(breaks[b], breaks[b + 1]);
        const Contact* contact = contact_at(arrangement, region_id, edge, 0.5 * (breaks[b] + breaks[b + 1]));
        const Border border = border_of(scene, contact);
        const EdgeMesh mesh = mesh_of(region, edge);
        const bool follows = border == Border::peridynamics && !region.has_own_mesh(edge);
        const bool tied = border == Border::peridynamics && !follows && !formulation.paper;
        if (border == Border::peridynamics) require_lattice_ends(scene, region_id, *contact, piece, tolerance);
        std::vector<double> stations =
            follows ? lattice_stations(scene, *contact, piece, formulation)
            : border == Border::boundary_elements
                ? shared_stations(scene, region_id, edge, *contact, piece)
                : element_stations(piece.length(), mesh.element_length, mesh.grading, piece.sweep);
        result.loops.back().push_back({piece.start, piece.end, std::move(stations), piece.sweep});
        result.sources.push_back(
            {edge, breaks[b], breaks[b + 1], border, contact ? contact->other_region + 1 : 0, tied});
      }
    }
  }
  if (formulation.grade_corners) grade_corners(scene, region_id, result);
  return result;
}

}  // namespace bempd::model
