#include <algorithm>
#include <optional>
#include <ranges>
#include <span>
#include <utility>

#include "crack/cannot_grow.hpp"
#include "geometry/outline.hpp"
#include "model/driven_growth.hpp"
#include "model/element_carrier.hpp"
#include "model/extension_end.hpp"
#include "model/model.hpp"

// Crack lines (cracks that grow in a lattice by steps of a spacing) that leave their lattice continue in the boundary
// elements behind it.
namespace bempd::model {

namespace {

// Distance of a crack's first tip with boundary elements behind its interface with the lattice, in spacings.
constexpr double into_elements = 1.5;

// Least distance, in spacings, from a crack's first tip with boundary elements straight ahead to the end of the region
// of these elements. With less room the crack line stops at the interface.
constexpr double room_in_elements = 0.5;

// Distance from the interface, in horizons, below which the stress points ahead of a crack line do not give the load on
// its tip; the line then continues in elements at once (docs/mixed_cracks.md). On an oblique path the distance is
// divided by the cosine of the angle to the interface's normal, which counts as at least least_cosine.
constexpr double near_elements = 2, least_cosine = 0.5;

// Whether an extension of a crack line ends at the border of a boundary element region.
bool ends_at_border(const scene::Scene& scene, const fracture::CrackExtension& e, double tolerance) {
  constexpr double closely = 0.25;  // share of the extension's length
  const Point from(e.from_x, e.from_y), to(e.x, e.y), ahead = to + closely * (to - from);
  const std::vector<int> ids = scene.region_ids();
  const auto any = [&](bool elements, const Point& place) {
    return std::any_of(ids.begin(), ids.end(), [&](int id) {
      return scene.region(id).has_elements() == elements && scene::contains(scene, id, place, tolerance);
    });
  };
  return any(false, from) && any(true, ahead);
}

// Place in boundary elements for the tip of a crack line that leaves its lattice straight ahead after the extension
// `e`. Empty if the line does not meet a straight interface with elements of the same material within `spacings` of its
// tip, or if there is too little room behind the interface.
std::optional<Point> tip_behind_border(const scene::Scene& scene, const fracture::CrackExtension& e, double spacings,
                                       double tolerance) {
  const Point from(e.from_x, e.from_y), to(e.x, e.y), along = (to - from).normalized();
  for (const int lattice : scene.region_ids()) {
    if (scene.region(lattice).has_elements() || !scene::contains(scene, lattice, from, tolerance)) continue;
    const double spacing = scene.region(lattice).resolution();
    const Edge way(from, to + spacings / least_cosine * spacing * along);
    double exit = 2, cosine = 1;
    bool straight = true;
    for (const Edge& edge : edges_of(scene.region(lattice).outline()))
      for (const Crossing& meeting : meeting_points(way, edge))
        if (meeting.fraction_a > 1e-9 && meeting.fraction_a < exit)
          exit = meeting.fraction_a, straight = edge.straight(),
          cosine = std::abs(cross(along, (edge.end - edge.start).normalized()));
    if (exit > 1 || !straight) continue;
    if ((way.at(exit) - to).dot(along) * std::max(cosine, least_cosine) > spacings * spacing + tolerance) continue;
    const Point behind = way.at(exit) + 0.1 * spacing * along, tip = way.at(exit) + into_elements * spacing * along;
    const Point far = tip + room_in_elements * spacing * along;
    for (const int id : scene.region_ids())
      if (scene.region(id).has_elements() && scene.material_of(id) == scene.material_of(lattice) &&
          scene::contains(scene, id, behind, tolerance) && scene::has_inside(scene, id, tip, tolerance) &&
          scene::contains(scene, id, far, tolerance))
        return tip;
  }
  return std::nullopt;
}

// Crack with the id of a tip in a list of cracks. A crack that began in the run is added if the list does not contain
// it; the ids of such cracks follow those of the scene. Cracks that stay in their lattices have no points in the list,
// because the run knows their paths.
scene::Crack& crack_of(const crack::TipId& tip, std::vector<scene::Crack>& cracks) {
  const auto number = static_cast<std::size_t>(tip.crack) - 1;
  if (number >= cracks.size()) cracks.resize(number + 1, scene::Crack{{}, 0, 0, true});
  return cracks[number];
}

// Removes the point at an end of a crack.
void shorten(scene::Crack& crack, int end) {
  crack.points.erase(end == 0 ? crack.points.begin() : crack.points.end() - 1);
  const bool at_start = end == 0 ? crack.grown_at_start > 0 : crack.grown_at_end == 0;
  --(at_start ? crack.grown_at_start : crack.grown_at_end);
}

// Ends a crack at the outline of the body, if the last step of the crack line went beyond the outline. Only for cracks
// that began in the run.
void end_at_outline(scene::Crack& crack, int end, const scene::Scene& scene, double tolerance) {
  const auto is_outside = [&](const Point& place) { return scene::region_at(scene, place, tolerance) == 0; };
  const auto next_to_end = [&] { return end == 0 ? crack.points[1] : crack.points.end()[-2]; };
  while (crack.points.size() > 2 && is_outside(next_to_end())) shorten(crack, end);
  Point& last = end == 0 ? crack.points.front() : crack.points.back();
  if (!is_outside(last)) return;
  const Edge way(next_to_end(), last);
  double exit = 1;
  for (const int id : scene.region_ids())
    for (const Edge& edge : edges_of(scene.region(id).outline()))
      for (const Crossing& meeting : meeting_points(way, edge))
        if (is_outside(way.at(meeting.fraction_a + 10 * tolerance / way.length())))
          exit = std::min(exit, meeting.fraction_a);
  last = way.at(exit);
}

}  // namespace

std::size_t known_extensions(const scene::Crack& crack, const crack::TipId& tip,
                             std::span<const fracture::CrackExtension> extensions) {
  for (std::size_t k = extensions.size(); k-- > 0;) {
    const fracture::CrackExtension& e = extensions[k];
    if (e.tip() == tip && std::ranges::find(crack.points, Point(e.x, e.y)) != crack.points.end()) return k + 1;
  }
  return 0;
}

void add_extensions(scene::Crack& crack, const crack::TipId& tip,
                    std::span<const fracture::CrackExtension> extensions) {
  for (const fracture::CrackExtension& e : extensions.subspan(known_extensions(crack, tip, extensions)))
    if (e.tip() == tip) extend(crack, e.end, {e.x, e.y});
}

scene::Crack& crack_with_line(std::vector<scene::Crack>& cracks, const crack::TipId& line,
                              std::span<const fracture::CrackExtension> extensions, const scene::Scene& scene,
                              double tolerance) {
  scene::Crack& crack = crack_of(line, cracks);
  if (!crack.points.empty()) {
    add_extensions(crack, line, extensions);
    return crack;
  }
  for (const fracture::CrackExtension& e : extensions) {
    if (e.crack != line.crack) continue;
    if (crack.points.empty()) crack.points.emplace_back(e.from_x, e.from_y);
    extend(crack, e.end, {e.x, e.y});
  }
  for (const int end : {0, 1}) end_at_outline(crack, end, scene, tolerance);
  return crack;
}

fracture::CrackExtension last_extension_of(const crack::TipId& tip,
                                           std::span<const fracture::CrackExtension> extensions) {
  const auto found =
      std::find_if(extensions.rbegin(), extensions.rend(), [&](const auto& e) { return e.tip() == tip; });
  return found == extensions.rend() ? fracture::CrackExtension{} : *found;
}

bool is_at_border(const fracture::CrackExtension& e, const scene::Scene& scene, const regions::Discretization& d) {
  return ends_at_border(scene, e, d.tolerance);
}

std::optional<Point> place_behind_border(const fracture::CrackExtension& e, const scene::Scene& scene,
                                         const regions::Discretization& d) {
  constexpr double far = 64;  // spacings; leaves_lattice() has checked the distance
  return tip_behind_border(scene, e, far, d.tolerance);
}

// Whether the tip of a crack line has reached a border with boundary elements, along which it would run if it stayed in
// its lattice, or is so close to the border that the line can continue in the elements.
bool leaves_lattice(const fracture::CrackExtension& e, const scene::Scene& scene, const regions::Discretization& d) {
  if (is_at_border(e, scene, d)) return true;
  double horizons = 0;  // largest horizon of the lattices, in spacings
  for (const auto& region : d.regions)
    if (const auto grid = region->lattice_grid()) horizons = std::max(horizons, grid->horizon / grid->spacing);
  return tip_behind_border(scene, e, near_elements * horizons, d.tolerance).has_value();
}

// Tips of crack lines that have reached a border since the last call.
std::vector<crack::TipId> ElementCarrier::lines_at_border() {
  std::vector<crack::TipId> lines;
  const std::vector<fracture::CrackExtension>& all = body().progress().extensions;
  for (; extensions_seen_ < all.size(); ++extensions_seen_) {
    const fracture::CrackExtension& e = all[extensions_seen_];
    if (!e.has_ended() && leaves_lattice(e, model_.scene(), model_.prepared().discretization)) lines.push_back(e.tip());
  }
  return lines;
}

// Continues crack lines that have come to a border in the boundary elements behind it. A line that cannot continue
// there is stopped if it is at the border; if it is only near, it grows on in its lattice. If the run ends, all these
// lines are stopped. Returns whether a line was stopped.
bool ElementCarrier::take_over_lines(bool run_ends) {
  if (!run_ends) follow_lines();
  std::vector<crack::TipId> lines = lines_at_border();
  if (lines.empty()) return false;
  body().sources().bring_up_to_date();
  if (!run_ends)
    std::erase_if(lines, [&](const crack::TipId& tip) {
      const auto is_there = [&] {
        return is_at_border(last_extension_of(tip, model_.cracks().extensions()), model_.scene(),
                            model_.prepared().discretization);
      };
      return cross_border(tip) || !is_there();
    });
  for (const crack::TipId& tip : lines) {
    body().events().stop_line(tip);
    say([&] {
      model_.reports().log(1, text("crack ", tip.crack,
                                   " has come to the border of its lattice, where it cannot go on into a boundary "
                                   "element region; give the peridynamic region more room there if it should"));
    });
  }
  return !lines.empty();
}

// Continues a crack line in the boundary elements behind its lattice; returns false if that is impossible.
bool ElementCarrier::cross_border(const crack::TipId& tip) {
  std::optional<Grown> next = continued_in_elements(tip, true);
  if (!next) return false;
  go_on_in(std::move(next->scene), next->growth);
  extensions_seen_ = model_.cracks().extensions().size();
  return true;
}

// Scene in which the crack follows the path of its crack line, whose bonds are broken already, and a piece behind the
// interface; empty if the line cannot continue behind the interface.
std::optional<Grown> ElementCarrier::continued_in_elements(const crack::TipId& tip, bool is_driven) {
  const std::vector<scene::Crack> before = model_.scene().cracks();
  const fracture::CrackExtension last = last_extension_of(tip, model_.cracks().extensions());
  const regions::Discretization& d = model_.prepared().discretization;
  const std::optional<Point> place = place_behind_border(last, model_.scene(), d);
  if (!place) return std::nullopt;
  std::vector<scene::Crack> longer = before;
  extend(crack_with_line(longer, tip, model_.cracks().extensions(), model_.scene(), d.tolerance), tip.end, *place);
  try {
    return grown(before, [&] { return continued_in_elements(last, *place, std::move(longer), is_driven); });
  } catch (const crack::CannotGrow&) {
    return std::nullopt;
  }
}

// Scene in which a crack line has continued to `place` in boundary elements, with this growth entered in the history.
Grown ElementCarrier::continued_in_elements(const crack::Extension& last, const Point& place,
                                            std::vector<scene::Crack> longer, bool is_driven) {
  const crack::TipId tip = last.tip();
  const auto number = static_cast<std::size_t>(tip.crack) - 1;
  const double load_factor = model_.load_factor();
  Grown next;
  next.scene = model_.growth().with_cracks(std::move(longer), on_way_);
  next.scene->evolution->events().stop_line(tip, crack::TipState::carried_on);
  next.tips = model_.cracks().tips_of(*next.scene, regions::TipDetail::factors);
  next.growth = {1, load_factor, 0, 0, {last}};
  fracture::CrackExtension& e = next.growth.extensions.front();
  const Point from(last.x, last.y);
  e.from_x = from.x(), e.from_y = from.y(), e.angle = 0, e.load_factor = load_factor;
  crack::arrive(e, place, (place - from).norm(), crack::TipState::grows);
  e.crack_length = length_of(model_.scene().cracks()[number]);
  e.released_energy = next.scene->evolution->growth().released();
  if (const regions::TipValues* found = crack::tip_in(next.tips, tip)) e.rate_after = found->energy_release_rate;
  const int region = next.scene->discretization.cracks[number].region_at(tip.end);
  const double thickness = model_.scene().material_of(region).elasticity.thickness;
  e.surface_energy = is_driven ? e.resistance * e.length * thickness : e.released_energy;
  next.growth.surface_energy = e.surface_energy;
  next.scene->evolution->growth().book(next.growth);
  return next;
}

}  // namespace bempd::model
