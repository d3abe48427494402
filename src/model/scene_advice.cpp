#include "model/scene_advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "elasticity/griffith.hpp"
#include "error.hpp"
#include "geometry/outline.hpp"
#include "geometry/segment.hpp"
#include "pd/critical_stretch.hpp"
#include "regions/edge_nodes.hpp"

namespace bempd::model {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double fewest_cells = 10;    // least number of cells across a lattice that breaks
constexpr double fewest_horizons = 2;  // least ligament ahead of a tip in a lattice, in horizons
// Distance of a tip from an edge, as a share of the crack's length, below which a warning says that the tip ends right
// before the edge.
constexpr double share_before_edge = 0.01;
constexpr double largest_strain = 0.2;       // strain at growth above which numbers look like mixed units
constexpr double smallest_strain = 1e-7;     // strain at growth below which numbers look like mixed units
constexpr std::size_t most_alike = 3;        // number of warnings of one kind that are given
constexpr double initiation_number = 1.384;  // stress at initiation over sqrt(E' G0 / horizon), docs/theory.md

// Text of a number with three digits, which is enough for an estimate.
std::string about(double number) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(3);
  stream << number;
  return stream.str();
}

// Edge of a region that bounds the body, because no other region borders on the edge.
struct FreeEdge {
  int region, number;
  Edge geometry;
};

struct Ahead {
  double distance = unbounded;
  std::string what;
};

class Adviser {
 public:
  Adviser(const scene::Scene& scene, const regions::Discretization& d) : scene_(scene), d_(d) {
    for (const int id : scene.region_ids())
      for (int k = 1; k <= scene.region(id).edge_count(); ++k)
        if (!is_interface(id, k)) edges_.push_back({id, k, scene.region(id).edge(k)});
  }

  Advice run() {
    for (const auto& region : d_.regions) {
      tell_of_cells(*region);
      tell_of_body(*region);
    }
    for (std::size_t c = 0; c < scene_.cracks().size(); ++c) tell_of_crack(static_cast<int>(c) + 1);
    std::vector<int> materials;
    for (const int id : scene_.region_ids()) materials.push_back(scene_.region(id).material());
    std::sort(materials.begin(), materials.end());
    materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
    for (const int id : materials) tell_of_material(id);
    for (const std::vector<std::string>& alike : found_) {
      for (std::size_t i = 0; i < std::min(alike.size(), most_alike); ++i) {
        const bool more = i + 1 == most_alike && alike.size() > most_alike;
        advice_.warnings.push_back(alike[i] +
                                   (more ? text(" (", alike.size() - most_alike, " more are like this)") : ""));
      }
    }
    return std::move(advice_);
  }

 private:
  enum Kind { units, few_cells, short_crack, before_edge, short_ligament, kinds };

  void warn(Kind kind, std::string sentence) { found_[kind].push_back(std::move(sentence)); }

  bool is_interface(int region, int edge) const {
    return std::any_of(d_.arrangement.contacts.begin(), d_.arrangement.contacts.end(),
                       [&](const Contact& c) { return c.region + 1 == region && c.edge + 1 == edge; });
  }

  bool breaks(int region) const {
    const scene::Material& material = scene_.material_of(region);
    return material.fracture_energy > 0 || material.critical_stretch > 0;
  }

  // Tells which regions with bonds across their common edges are one body, and where the lattice of this body lies.
  void tell_of_body(const regions::Region& region) {
    const std::optional<regions::LatticeGrid> grid = region.lattice_grid();
    if (!grid || std::none_of(d_.arrangement.contacts.begin(), d_.arrangement.contacts.end(),
                              [&](const Contact& c) { return c.region + 1 == region.id(); }))
      return;
    const std::vector<int> body = regions::regions_of_body(d_, region.id());
    if (body.size() < 2 || body.front() != region.id()) return;
    std::string names;
    for (const int id : body) names += text(names.empty() ? "regions " : ", ", id);
    advice_.facts.push_back(names + text(" are one body; its lattice has a point at (", about(grid->origin.x()), ", ",
                                         about(grid->origin.y()), ")"));
  }

  // --- Cells

  // Warns of a lattice with few cells across its narrower direction. A direction in which another region continues the
  // body is not counted.
  void tell_of_cells(const regions::Region& region) {
    const std::optional<regions::LatticeGrid> grid = region.lattice_grid();
    if (!grid || !breaks(region.id())) return;
    double narrowest = unbounded;
    for (const double angle : {grid->angle, grid->angle + std::numbers::pi / 2}) {
      const Point axis(std::cos(angle), std::sin(angle));
      if (goes_on_along(region.id(), axis)) continue;
      double low = unbounded, high = -unbounded;
      for (const Edge& edge : edges_of(scene_.region(region.id()).outline())) {
        for (const double fraction : {0.0, 0.5}) {
          const double along = axis.dot(edge.at(fraction));
          low = std::min(low, along), high = std::max(high, along);
        }
      }
      narrowest = std::min(narrowest, high - low);
    }
    const double cells = narrowest / grid->spacing;
    if (!(cells < fewest_cells - 1e-6)) return;
    warn(few_cells, text("region ", region.id(), " is ", about(cells), " cells wide, fewer than ", fewest_cells,
                         ": the loads at which it breaks depend on the lattice; choose the ", "spacing ",
                         about(narrowest / fewest_cells), " or a smaller one"));
  }

  bool goes_on_along(int region, const Point& axis) const {
    return std::any_of(d_.arrangement.contacts.begin(), d_.arrangement.contacts.end(), [&](const Contact& c) {
      if (c.region + 1 != region) return false;
      const Point along = scene_.region(region).edge(c.edge + 1).direction();
      return std::abs(axis.dot(along)) < 0.5 * along.norm();
    });
  }

  // --- Cracks

  void tell_of_crack(int id) {
    const std::vector<Point>& points = scene_.crack(id).points;
    if (points.size() < 2) return;
    const double length = polyline_length(points);
    const std::optional<regions::LatticeGrid> at_end = lattice_at(points.back()), at_start = lattice_at(points.front());
    for (const auto& grid : {at_start, at_end}) {
      if (!grid || length >= grid->spacing) continue;
      warn(short_crack, text("crack ", id, " is ", length, " long, shorter than the spacing ", grid->spacing,
                             " of its lattice, which does not feel it as a crack: choose a smaller spacing, "
                             "or boundary elements"));
      return;
    }
    tell_of_tip(id, points.front(), (points[0] - points[1]).normalized(), length);
    tell_of_tip(id, points.back(), (points.back() - points.end()[-2]).normalized(), length);
  }

  std::optional<regions::LatticeGrid> lattice_at(const Point& place) const {
    for (const auto& region : d_.regions)
      if (const auto grid = region->lattice_grid(); grid && is_inside(region->id(), place)) return grid;
    return std::nullopt;
  }

  bool is_inside(int region, const Point& place) const {
    return scene::has_inside(scene_, region, place, d_.tolerance);
  }

  void tell_of_tip(int crack, const Point& tip, const Point& direction, double length) {
    const bool in_body = std::any_of(d_.regions.begin(), d_.regions.end(),
                                     [&](const auto& region) { return is_inside(region->id(), tip); });
    if (!in_body || touches_another(crack, tip)) return;
    const std::optional<regions::LatticeGrid> grid = lattice_at(tip);
    const Ahead nearest = nearest_edge(tip);
    const std::string where = text("crack ", crack, " ends at ", "(", tip.x(), ", ", tip.y(), "), ");
    if (nearest.distance < (grid ? grid->spacing : share_before_edge * length)) {
      warn(before_edge, text(where, about(nearest.distance), " before ", nearest.what,
                             grid ? ", less than a spacing" : ", less than a hundredth of its length",
                             ": let it end on the edge if it should reach it"));
      return;
    }
    if (!grid) return;
    const Ahead ahead = first_ahead(crack, tip, direction);
    if (ahead.distance >= fewest_horizons * grid->horizon) return;
    warn(short_ligament,
         text(where, about(ahead.distance / grid->spacing), " cells before ", ahead.what,
              ", less than two horizons: the load at which it grows is inaccurate; choose the spacing ",
              about(grid->spacing * ahead.distance / (fewest_horizons * grid->horizon)), " or a smaller one"));
  }

  bool touches_another(int crack, const Point& tip) const {
    const std::vector<scene::Crack>& cracks = scene_.cracks();
    for (std::size_t c = 0; c < cracks.size(); ++c)
      if (static_cast<int>(c) + 1 != crack && polyline_distance(cracks[c].points, tip) <= d_.tolerance) return true;
    return false;
  }

  Ahead nearest_edge(const Point& tip) const {
    Ahead nearest;
    for (const FreeEdge& edge : edges_)
      if (const double away = distance(edge.geometry, tip); away < nearest.distance)
        nearest = {away, text("edge ", edge.number, " of region ", edge.region)};
    return nearest;
  }

  // First edge of the body or other crack straight ahead of a tip, with its distance from the tip.
  Ahead first_ahead(int crack, const Point& tip, const Point& direction) const {
    Ahead first;
    const double farthest = 2 * scene_.bounding_box().diagonal().norm();
    const Edge ray(tip, tip + farthest * direction);
    const auto meet = [&](const Edge& other, const auto&... name) {
      for (const Crossing& crossing : meeting_points(ray, other))
        if (const double away = crossing.fraction_a * farthest; away > d_.tolerance && away < first.distance)
          first = {away, text(name...)};
    };
    for (const FreeEdge& edge : edges_) meet(edge.geometry, "edge ", edge.number, " of region ", edge.region);
    for (std::size_t c = 0; c < scene_.cracks().size(); ++c) {
      const std::vector<Point>& points = scene_.cracks()[c].points;
      for (std::size_t i = 0; i + 1 < points.size() && static_cast<int>(c) + 1 != crack; ++i)
        meet(Edge(points[i], points[i + 1]), "crack ", c + 1);
    }
    return first;
  }

  // --- Materials

  // Adds a sentence about a material that breaks, for its lattice with the smallest horizon and its longest crack,
  // because the material breaks there at the lowest strain.
  void tell_of_material(int id) {
    const scene::Material& material = scene_.material(id);
    int lattice = 0, longest = 0;
    double horizon = unbounded, length = 0;
    for (const auto& region : d_.regions) {
      if (scene_.region(region->id()).material() != id) continue;
      if (const auto grid = region->lattice_grid(); grid && grid->horizon < horizon)
        horizon = grid->horizon, lattice = region->id();
      for (std::size_t c = 0; c < scene_.cracks().size(); ++c) {
        const std::vector<Point>& points = scene_.cracks()[c].points;
        if (points.size() < 2 || polyline_length(points) <= length) continue;
        if (is_inside(region->id(), points.front()) || is_inside(region->id(), points.back()))
          longest = static_cast<int>(c) + 1, length = polyline_length(points);
      }
    }
    const double modulus = plane_modulus(material.elasticity);
    double energy = material.fracture_energy;
    if (lattice > 0 && material.critical_stretch > 0)
      energy = pd::fracture_energy(material.critical_stretch, material.elasticity, horizon);
    if (!(energy > 0) || (lattice == 0 && longest == 0)) return;
    double strain = unbounded;
    std::string fact = text("material ", id, ": K_IC = sqrt(E' G0) = ", about(std::sqrt(modulus * energy)));
    if (lattice > 0) {
      strain = initiation_number * std::sqrt(energy / modulus / horizon);
      fact += text("; sound places of region ", lattice, " break at a strain of about ", about(strain),
                   ", a stress f_t = ", about(strain * modulus),
                   ", internal length E' G0 / f_t^2 = ", about(horizon / (initiation_number * initiation_number)));
    }
    if (longest > 0) {
      const double griffith = std::sqrt(energy / modulus / (std::numbers::pi * length));
      fact += text("; crack ", longest, " grows at a strain of the order of ", about(griffith));
      strain = std::min(strain, griffith);
    }
    advice_.facts.push_back(fact);
    if (strain <= largest_strain && strain >= smallest_strain) return;
    warn(units, text("material ", id, " begins to break at a strain of about ", about(strain), " (young_modulus ",
                     material.elasticity.young_modulus, ", ",
                     material.fracture_energy > 0 ? "fracture_energy " : "critical_stretch ",
                     std::max(material.fracture_energy, material.critical_stretch),
                     "), which looks like mixed units: take Pa, J/m^2 and m, or MPa, N/mm and mm"));
  }

  const scene::Scene& scene_;
  const regions::Discretization& d_;
  std::vector<FreeEdge> edges_;
  std::array<std::vector<std::string>, kinds> found_;
  Advice advice_;
};

}  // namespace

Advice advice_on(const scene::Scene& scene, const regions::Discretization& d) { return Adviser(scene, d).run(); }

}  // namespace bempd::model
