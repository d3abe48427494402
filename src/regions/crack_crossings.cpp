#include "regions/crack_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "error.hpp"
#include "regions/region.hpp"

namespace bempd::regions {

namespace {

// Largest distance along the crack from its crossing with an interface, on each side of the crossing, within which the
// crack is bent so that it passes half way between two material points [spacings].
constexpr double bent_reach = 3;

// Least length of crack on each side of a crossing with an interface [spacings]. Where the crack is bent, vertices of
// the described crack within this distance are left out, so that the bent crack is straight there.
constexpr double straight_reach = 1;

// Distance of two places in spacings below which the places differ by rounding only.
constexpr double rounding_of_places = 1e-6;

struct Middle {
  Point place;
  double spacing;
  int lattice;  // id of its region
};

// Finds the place half way between two neighbouring material points that is nearest to a crossing, on the interfaces of
// the region `boundary` with lattices. Of two equally near places the one on the right of the crack is taken. The
// result's spacing is 0 if no lattice borders on the region. Throws Error (argument) at curved interfaces.
Middle nearest_middle(const Preparation& p, int crack, int boundary, const CrackCrossing& crossing) {
  Middle nearest{Point::Zero(), 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (const Contact& contact : p.arrangement.contacts) {
    if (contact.other_region != boundary - 1) continue;
    const auto lattice = std::find_if(p.regions.begin(), p.regions.end(),
                                      [&](const auto& region) { return region->id() == contact.region + 1; });
    if (!(*lattice)->bonds()) continue;
    const std::vector<Point> points = (*lattice)->point_borders()->interface_points(p, contact);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Point middle = 0.5 * (points[i] + points[i + 1]);
      const double spacing = (points[i + 1] - points[i]).norm(), gap = (middle - crossing.place).norm();
      const bool as_near = std::abs(gap - least) <= rounding_of_places * spacing;
      const bool on_right = cross(crossing.direction, Point(middle - crossing.place)) < 0;
      if (as_near ? !on_right : gap > least) continue;
      least = gap;
      nearest = {middle, spacing, (*lattice)->id()};
      const Edge edge = p.scene.region(contact.region + 1).edge(contact.edge + 1);
      require(edge.straight() || gap > spacing, "crack ", crack, " crosses the interface of the regions ", boundary,
              " and ", nearest.lattice, " at (", crossing.place.x(), ", ", crossing.place.y(),
              "), which is curved; interfaces between elements and material points that cracks cross have to be "
              "straight there");
    }
  }
  return nearest;
}

struct Vertex {
  double way;
  Point place;
  char grown;  // whether growth has added the segment that begins here
};

class Bending {
 public:
  Bending(const scene::Crack& crack, double same) : same_(same) {
    double way = 0;
    const auto count = static_cast<int>(crack.points.size());
    for (int i = 0; i < count; ++i) {
      if (i > 0) way += (crack.points[i] - crack.points[i - 1]).norm();
      const bool grown = i < crack.grown_at_start || i >= count - 1 - crack.grown_at_end;
      vertices_.push_back({way, crack.points[static_cast<std::size_t>(i)], static_cast<char>(grown)});
    }
  }

  double length() const { return vertices_.back().way; }

  // Moves the crack's point at the crossing `c` to c.place. The crack is bent on a stretch between the distances `low`
  // and `high` along it; it runs straight from the start of this stretch to the crossing, and on to the end of the
  // stretch.
  void bend(const CrackCrossing& c, double low, double high) {
    const Vertex at = at_way(c.way);
    double from = c.way, to = c.way;
    if (c.spacing > 0 && (at.place - c.place).norm() > rounding_of_places * c.spacing) {
      from = std::max(low, c.way - bent_reach * c.spacing), to = std::min(high, c.way + bent_reach * c.spacing);
      for (const Vertex& v : vertices_) {
        if (v.way <= c.way - straight_reach * c.spacing) from = std::max(from, v.way);
        if (v.way >= c.way + straight_reach * c.spacing) to = std::min(to, v.way);
      }
    }
    std::vector<Vertex> bent;
    const double same = c.spacing > 0 ? rounding_of_places * c.spacing : same_;
    for (const Vertex& v : vertices_)
      if (v.way < from - same) bent.push_back(v);
    if (from < c.way) bent.push_back(at_way(from));
    bent.push_back({c.way, c.place, at.grown});
    if (to > c.way) bent.push_back(at_way(to));
    for (const Vertex& v : vertices_)
      if (v.way > to + same) bent.push_back(v);
    vertices_ = std::move(bent);
  }

  const std::vector<Vertex>& vertices() const { return vertices_; }

 private:
  Vertex at_way(double way) const {
    std::size_t i = 0;
    while (i + 2 < vertices_.size() && way >= vertices_[i + 1].way) ++i;
    const Vertex &a = vertices_[i], &b = vertices_[i + 1];
    const double part = std::min(1.0, (way - a.way) / (b.way - a.way));
    return {way, Segment{a.place, b.place}.at(part), a.grown};
  }

  double same_;
  std::vector<Vertex> vertices_;
};

// Throws Error (argument) if a crack cannot cross the interface of two boundary element regions at `c`. Both regions
// need the same material, because they share nodes on both faces of the crack, and because the stress field of a crack
// mouth at the interface of two materials is not known. No peridynamic region may touch the place.
void require_one_body(const Preparation& p, int crack, const CrackCrossing& c) {
  const auto about = [&] {
    return text("crack ", crack, " crosses the interface of the regions ", c.before, " and ", c.after, " at (",
                c.place.x(), ", ", c.place.y(), ")");
  };
  require(p.scene.material_of(c.before) == p.scene.material_of(c.after), about(),
          ", which are of two materials; cracks go on in boundary elements of one material only: let it end before the "
          "interface");
  for (const auto& region : p.regions)
    require(!region->bonds() || !scene::contains(p.scene, region->id(), c.place, p.tolerance), about(),
            ", where the peridynamic region ", region->id(), " has a corner; let it pass that corner by");
}

}  // namespace

void move_between_rows(const Preparation& p, int crack, std::vector<CrackCrossing>& crossings, double length,
                       std::vector<std::string>& warnings) {
  double before = 0;  // distance along the crack of the crossing before
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    CrackCrossing& c = crossings[k];
    if (c.among_elements()) {
      require_one_body(p, crack, c);
      before = c.way;
      continue;
    }
    const Middle middle = nearest_middle(p, crack, std::max(c.before, c.after), c);
    const double behind = (k + 1 < crossings.size() ? crossings[k + 1].way : length) - c.way;
    require(middle.spacing > 0 && std::min(c.way - before, behind) >= straight_reach * middle.spacing, "crack ", crack,
            " crosses the interface of the regions ", std::max(c.before, c.after), " and ", middle.lattice, " at (",
            c.place.x(), ", ", c.place.y(), ") and runs less than a spacing (", middle.spacing,
            ") on one side of it; let it end before the interface, or farther behind it");
    before = c.way;
    const double shift = (middle.place - c.place).norm() / middle.spacing;
    if (shift > rounding_of_places)
      warnings.push_back(text("crack ", crack, " crosses the interface of the regions ", std::max(c.before, c.after),
                              " and ", middle.lattice, " at (", c.place.x(), ", ", c.place.y(), "), ", shift,
                              " spacings beside the middle between two material points; it is bent to that, (",
                              middle.place.x(), ", ", middle.place.y(), ")"));
    c.place = middle.place, c.spacing = middle.spacing;
  }
}

MovedCrack bent_to(const scene::Crack& crack, const std::vector<CrackCrossing>& crossings, double same) {
  Bending bending(crack, same);
  const double length = bending.length();
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    const double way = crossings[k].way;
    bending.bend(crossings[k], k == 0 ? 0 : 0.5 * (crossings[k - 1].way + way),
                 k + 1 == crossings.size() ? length : 0.5 * (way + crossings[k + 1].way));
  }
  MovedCrack bent;
  for (const auto& v : bending.vertices()) {
    const bool crosses = bent.crossings.size() < crossings.size() && crossings[bent.crossings.size()].place == v.place;
    if (crosses) bent.crossings.push_back(bent.points.size());
    bent.points.push_back(v.place);
    bent.grown.push_back(v.grown);
  }
  bent.grown.pop_back();
  return bent;
}

std::pair<int, int> MovedCrack::grown_at_ends(std::size_t from, std::size_t to) const {
  std::size_t first = from, last = to;
  while (first < to && grown[first]) ++first;
  while (last > first && grown[last - 1]) --last;
  return {static_cast<int>(first - from), static_cast<int>(to - last)};
}

scene::Crack MovedCrack::crack() const {
  const auto [at_start, at_end] = grown_at_ends(0, points.size() - 1);
  return {points, at_start, at_end};
}

int SharedMouth::side_of(const Point& x) const {
  const Point ahead = behind - place;
  const auto turn = [&](const Point& direction) {
    const double angle = std::atan2(cross(ahead, direction), ahead.dot(direction));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  };
  return turn(x - place) < turn(before - place) ? 1 : -1;
}

std::vector<SharedMouth> shared_mouths(const std::vector<PartedCrack>& cracks) {
  std::vector<SharedMouth> mouths;
  for (const PartedCrack& crack : cracks) {
    for (std::size_t k = 1; k < crack.parts.size(); ++k) {
      const CrackPart &before = crack.parts[k - 1], &behind = crack.parts[k];
      if (before.region > 0 && behind.region > 0)
        mouths.push_back({behind.points.front(), before.points.end()[-2], behind.points[1]});
    }
  }
  return mouths;
}

void require_mouths_apart(const std::vector<PartedCrack>& cracks, double tolerance) {
  struct Mouth {
    std::size_t crack;
    Point place;
  };
  std::vector<Mouth> mouths;
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    for (std::size_t k = 1; k < cracks[c].parts.size(); ++k) {
      const Point& place = cracks[c].parts[k].points.front();
      for (const Mouth& other : mouths)
        require((other.place - place).norm() > 8 * tolerance, "cracks ", other.crack + 1, " and ", c + 1,
                " cross an interface ",
                cracks[c].parts[k - 1].spacing_behind > 0 ? "between the same two material points" : "in one place",
                ", at (", place.x(), ", ", place.y(), "); move them apart, or choose a smaller spacing");
      mouths.push_back({c, place});
    }
  }
}

}  // namespace bempd::regions
