#include "regions/singular_places.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "cancellation.hpp"
#include "regions/meeting_wedges.hpp"

namespace bempd::regions {

namespace {

// Candidates for singular places: vertices of outlines, ends of supports, and the points of cracks with elements.
std::vector<Point> candidates(const scene::Scene& scene, const Discretization& d) {
  std::vector<Point> places;
  for (int id : scene.region_ids()) {
    int number = 0;
    for (const Edge& edge : edges_of(scene.region(id).outline())) {
      places.push_back(edge.start);
      ++number;
      for (const scene::Condition& support : scene.supports()) {
        if (support.removed()) continue;
        for (double fraction : support.place->breaks_on(scene, id, number, d.tolerance))
          places.push_back(edge.at(fraction));
      }
    }
  }
  for (const PartedCrack& crack : d.cracks)
    for (const CrackPart& part : crack.parts)
      if (part.region > 0) places.insert(places.end(), part.points.begin(), part.points.end());
  return places;
}

// Places without duplicates (closer than `tolerance`), in the order of their first occurrence.
std::vector<Point> distinct(const std::vector<Point>& places, double tolerance) {
  NodeRegistry known(places.front(), tolerance);
  std::vector<Point> once;
  int caller = 0;
  for (const Point& place : places)
    if (known.add_shared(place, ++caller) == static_cast<int>(once.size())) once.push_back(place);
  return once;
}

// Cache of singular exponents by wedge. Equal wedges occur often, such as in rows of holes or layers.
class KnownExponents {
 public:
  std::optional<std::complex<double>> of(const Wedge& wedge) {
    constexpr double digits = 1e9;
    std::vector<double> key{std::round(digits * wedge.angle), wedge.closed ? 1.0 : 0.0};
    for (const WedgeSector& sector : wedge.sectors) {
      const PlaneElasticity& e = sector.elasticity;
      key.insert(key.end(), {std::round(digits * sector.opening), e.young_modulus, e.poisson_ratio, e.thickness});
    }
    for (const int held : wedge.held) key.push_back(held);
    // The wedge's direction matters only if a support on one of its sides holds a single displacement component.
    const auto is_single = [](int held) { return held == 1 || held == 2; };
    if (std::none_of(wedge.held.begin(), wedge.held.end(), is_single)) key.front() = 0;
    const auto found = known_.find(key);
    return found != known_.end() ? found->second : known_.emplace(key, singular_exponent(wedge)).first->second;
  }

 private:
  std::map<std::vector<double>, std::optional<std::complex<double>>> known_;
};

SingularKind kind_of(const MeetingWedge& meeting) {
  if (meeting.at_crack) return SingularKind::crack;
  const std::vector<WedgeSector>& sectors = meeting.wedge.sectors;
  const bool alike = std::all_of(sectors.begin(), sectors.end(), [&](const WedgeSector& sector) {
    return sector.elasticity == sectors.front().elasticity;
  });
  return alike ? SingularKind::corner : SingularKind::interface;
}

// Adds the single points at which a force acts or a support holds, unless supports on edges at the point hold the same
// displacement components.
void add_points(const scene::Scene& scene, const Discretization& d, const WedgeFinder& finder,
                std::vector<SingularPlace>& found) {
  const auto add = [&](const scene::Condition& condition) {
    const auto place = condition.removed() ? std::nullopt : condition.place->point();
    if (!place) return;
    int held = 0;
    for (const MeetingWedge& meeting : finder.wedges_at(*place))
      for (const int components : meeting.wedge.held) held |= components;
    if ((condition.components & ~held) == 0) return;
    const SingularPlace point{SingularKind::point, scene::region_at(scene, *place, 8 * d.tolerance), *place, 0};
    const auto same = std::find_if(found.begin(), found.end(), [&](const SingularPlace& other) {
      return (other.place - *place).norm() <= 8 * d.tolerance;
    });
    if (same == found.end())
      found.push_back(point);
    else
      *same = point;
  };
  std::for_each(scene.supports().begin(), scene.supports().end(), add);
  std::for_each(scene.loads().begin(), scene.loads().end(), add);
}

}  // namespace

std::vector<SingularPlace> singular_places(const scene::Scene& scene, const Discretization& d) {
  const WedgeFinder finder(scene, d);
  KnownExponents exponents;
  std::vector<SingularPlace> found;
  for (const Point& place : distinct(candidates(scene, d), 8 * d.tolerance)) {
    check_cancelled();
    std::optional<SingularPlace> worst;
    for (const MeetingWedge& meeting : finder.wedges_at(place)) {
      const auto exponent = exponents.of(meeting.wedge);
      if (exponent && (!worst || exponent->real() < worst->exponent.real()))
        worst = SingularPlace{kind_of(meeting), meeting.region, place, *exponent};
    }
    if (worst) found.push_back(*worst);
  }
  add_points(scene, d, finder, found);
  return found;
}

}  // namespace bempd::regions
