#include "regions/meeting_wedges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/segment.hpp"

namespace bempd::regions {

namespace {

constexpr double whole_turn = 2 * std::numbers::pi;
// Angle [rad] between two rays below which they count as the same.
constexpr double same_angle = 1e-6;

double angle_of(const Point& direction) { return std::atan2(direction.y(), direction.x()); }

// Angle from the direction `from` counter-clockwise to the direction `to`, in (0, 2 pi]. Equal directions, up to
// rounding, are a full turn apart.
double turn_between(double from, double to) {
  const double turn = std::remainder(to - from, whole_turn);
  if (std::abs(turn) < same_angle) return whole_turn;
  return turn > 0 ? turn : turn + whole_turn;
}

bool same_ray(double a, double b) { return std::abs(std::remainder(a - b, whole_turn)) < same_angle; }

}  // namespace

WedgeFinder::WedgeFinder(const scene::Scene& scene, const Discretization& d) : scene_(scene), d_(d) {
  std::vector<Box> boxes;
  for (int id : scene.region_ids()) {
    int number = 0;
    for (const Edge& edge : edges_of(scene.region(id).outline())) {
      edges_.push_back({id, ++number, edge});
      boxes.push_back(bounding_box(edge));
    }
  }
  tree_ = BoxTree(boxes);
}

int WedgeFinder::held_on(const OutlineEdge& edge, double fraction) const {
  int components = 0;
  for (const scene::Condition& support : scene_.supports())
    if (!support.removed() && support.place->covers(edge.region, edge.number, fraction))
      components |= support.components;
  return components;
}

WedgeFinder::Sector WedgeFinder::between(int region, const Point& place, const Ray& from, const Ray& to) const {
  Sector sector{region, from, to, turn_between(from.angle, to.angle)};
  if (sector.opening < whole_turn || from.crack) return sector;
  // A sector of a full turn between edges may be the tip of a cusp: of a cusp of the body, whose angle is 0, or of a
  // notch in the body. Whether the point opposite to the cusp lies in the body decides.
  constexpr double beside = 1e-3;
  const Outline& outline = scene_.region(region).outline();
  const Point opposite(-std::cos(from.angle), -std::sin(from.angle));
  const double reach = beside * bounding_box(outline).diagonal().norm();
  if (locate(outline, place + reach * opposite, d_.tolerance) == Location::outside) sector.opening = 0;
  return sector;
}

void WedgeFinder::add_sectors_of_outlines(const Point& place, std::vector<Sector>& sectors) const {
  const double near = 8 * d_.tolerance;
  const Box around(place - Point::Constant(2 * near), place + Point::Constant(2 * near));
  // Rays from the place along edges, by region: first those along edges that start at the place or pass through it,
  // then those along edges that end there or pass through it.
  std::map<int, std::pair<std::vector<Ray>, std::vector<Ray>>> rays;
  for (const int k : tree_.meeting(around)) {
    const OutlineEdge& edge = edges_[k];
    if (distance(edge.edge, place) > near) continue;
    const double at = closest_fraction(edge.edge, place), beside = std::max(1e-7, 4 * near / edge.edge.length());
    auto& [away, towards] = rays[edge.region];
    if ((edge.edge.end - place).norm() > near)
      away.push_back({angle_of(edge.edge.tangent(at)), held_on(edge, std::min(1.0, at + beside))});
    if ((edge.edge.start - place).norm() > near)
      towards.push_back({angle_of(-edge.edge.tangent(at)), held_on(edge, std::max(0.0, at - beside))});
  }
  for (const auto& [region, both] : rays) {
    for (const Ray& from : both.first) {
      // The sector of the body ends at the ray `to` that comes first counter-clockwise, because the body lies on the
      // left of its edges.
      const Ray* next = nullptr;
      for (const Ray& to : both.second)
        if (!next || turn_between(from.angle, to.angle) < turn_between(from.angle, next->angle)) next = &to;
      if (!next) continue;
      const Sector sector = between(region, place, from, *next);
      if (sector.opening > 0) sectors.push_back(sector);
    }
  }
}

void WedgeFinder::cut_by_cracks(const Point& place, std::vector<Sector>& sectors) const {
  const double near = 8 * d_.tolerance;
  std::map<int, std::vector<Ray>> rays;
  for (const PartedCrack& crack : d_.cracks) {
    for (const CrackPart& part : crack.parts) {
      for (std::size_t k = 0; k + 1 < part.points.size(); ++k) {
        const Segment piece{part.points[k], part.points[k + 1]};
        if (!crack.has_elements() || distance(piece, place) > near) continue;
        const int region = part.region > 0 ? part.region : scene::region_at(scene_, piece.at(0.5), d_.tolerance);
        for (const Point& end : {piece.start, piece.end})
          if ((end - place).norm() > near) rays[region].push_back({angle_of(end - place), 0, true});
      }
    }
  }
  for (auto& [region, cracks] : rays) {
    const auto is_of_region = [id = region](const Sector& sector) { return sector.region == id; };
    if (std::none_of(sectors.begin(), sectors.end(), is_of_region)) {
      // No edge of the region meets the place, so the first sector is a full turn that begins and ends at the ray of
      // one crack.
      sectors.push_back({region, cracks.back(), cracks.back(), whole_turn});
      cracks.pop_back();
    }
    for (const Ray& crack : cracks) {
      const auto holds = [&](const Sector& s) {
        const double turn = turn_between(s.from.angle, crack.angle);
        return is_of_region(s) && turn > same_angle && turn < s.opening - same_angle;
      };
      const auto cut = std::find_if(sectors.begin(), sectors.end(), holds);
      if (cut == sectors.end()) continue;  // the ray lies on another ray
      const Sector whole = *cut;
      const double turn = turn_between(whole.from.angle, crack.angle);
      *cut = {region, whole.from, crack, turn};
      sectors.push_back({region, crack, whole.to, whole.opening - turn});
    }
  }
}

std::vector<MeetingWedge> WedgeFinder::wedges_at(const Point& place) const {
  std::vector<Sector> sectors;
  add_sectors_of_outlines(place, sectors);
  cut_by_cracks(place, sectors);
  const auto follows = [](const Sector& before, const Sector& after) {
    return before.region != after.region && same_ray(before.to.angle, after.from.angle);
  };
  std::vector<char> taken(sectors.size(), 0);
  std::vector<MeetingWedge> wedges;
  const auto collect = [&](std::size_t first) {
    MeetingWedge found{{sectors[first].from.angle, {}, {sectors[first].from.held}, false},
                       sectors[first].region,
                       sectors[first].from.crack};
    for (std::size_t k = first; k < sectors.size();) {
      taken[k] = 1;
      found.wedge.sectors.push_back({sectors[k].opening, scene_.material_of(sectors[k].region).elasticity});
      found.at_crack = found.at_crack || sectors[k].to.crack;
      std::size_t next = sectors.size();
      for (std::size_t other = 0; other < sectors.size(); ++other)
        if (follows(sectors[k], sectors[other])) next = other;
      int held = sectors[k].to.held;
      if (next < sectors.size()) held |= sectors[next].from.held;
      if (next == first) {
        found.wedge.closed = true;
        found.wedge.held.front() |= held;
        break;
      }
      found.wedge.held.push_back(held);
      if (next < sectors.size() && taken[next]) break;
      k = next;
    }
    wedges.push_back(std::move(found));
  };
  // Wedges whose first sector begins at a free side are collected first, then closed rings of sectors, which have no
  // first sector.
  for (const bool rings : {false, true}) {
    for (std::size_t k = 0; k < sectors.size(); ++k) {
      const bool begins = std::none_of(sectors.begin(), sectors.end(),
                                       [&](const Sector& before) { return follows(before, sectors[k]); });
      if (!taken[k] && begins != rings) collect(k);
    }
  }
  return wedges;
}

}  // namespace bempd::regions
