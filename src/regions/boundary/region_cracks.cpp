#include "regions/boundary/region_cracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "geometry/turning.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/crack_crossings.hpp"
#include "regions/memory_limit.hpp"

namespace bempd::regions {

namespace {

// Memory estimate: bytes per square of the number of elements, for the matrices that exist at the same time while an
// operator with cracks is built. Measured with 400 to 900 elements.
constexpr double bytes_per_square_with_cracks = 600;

// Limits for a warning: number of elements from which on preparing takes seconds, and ratio of a gap's width to the
// crack's length below which the gap is given as the reason.
constexpr double elements_to_tell_of = 500, narrow_gap = 0.03;

// Calls visit(crack, its id, part) for all parts of cracks that have elements in the region.
template <class Visit>
void for_each_part(const Preparation& p, int region, const Visit& visit) {
  for (std::size_t c = 0; c < p.cracks.size(); ++c)
    for (const CrackPart& part : p.cracks[c].parts)
      if (part.region == region) visit(p.cracks[c].crack, static_cast<int>(c) + 1, part);
}

// Distances along a grown crack at which the crack as described by the host begins and ends.
std::pair<double, double> described_part(const scene::Crack& crack) {
  const auto first = crack.points.begin();
  return {polyline_length({first, first + crack.grown_at_start + 1}),
          polyline_length({first, crack.points.end() - crack.grown_at_end})};
}

std::vector<CrackPath> paths_in(const Preparation& p, int region) {
  std::vector<CrackPath> paths;
  for_each_part(p, region, [&](const scene::Crack& crack, int number, const CrackPart& part) {
    const auto [from, to] = described_part(crack);
    const bool goes_on = part.reach_before > 0 || part.reach_behind > 0;
    paths.push_back({number, part.points, part.grown_at_start, part.grown_at_end, goes_on ? to - from : 0});
  });
  return paths;
}

std::vector<CrackExtent> extents_in(const Preparation& p, int region) {
  std::vector<CrackExtent> extents;
  for_each_part(p, region, [&](const scene::Crack& crack, int, const CrackPart& part) {
    const auto [from, to] = described_part(crack);
    extents.push_back({part.start, polyline_length(crack.points), from, to - from});
  });
  return extents;
}

std::vector<bem::MouthOnRow> mouths_on_rows(const Preparation& p, int region) {
  std::vector<bem::MouthOnRow> mouths;
  for_each_part(p, region, [&](const scene::Crack&, int, const CrackPart& part) {
    if (part.spacing_before > 0) mouths.push_back({part.points.front(), part.spacing_before});
    if (part.spacing_behind > 0) mouths.push_back({part.points.back(), part.spacing_behind});
  });
  return mouths;
}

// Largest length of elements at a mouth shared with another boundary element region, over the crack's distance from the
// mouth to its next bend or end there.
constexpr double longest_before_end = 0.5;

std::vector<bem::MouthOnRow> short_elements_at(const Preparation& p, int region, std::vector<bem::MouthOnRow> mouths) {
  for_each_part(p, region, [&](const scene::Crack&, int, const CrackPart& part) {
    if (part.reach_before > 0) mouths.push_back({part.points.front(), longest_before_end * part.reach_before});
    if (part.reach_behind > 0) mouths.push_back({part.points.back(), longest_before_end * part.reach_behind});
  });
  return mouths;
}

// Values of an element's three shape functions at a fraction `part` of its length; `tip`: the end that is a crack tip.
std::array<double, 3> shape_at(bem::TipEnd tip, double part) {
  if (tip == bem::TipEnd::none) return bem::ElementGeometry{}.shape(2 * part - 1);
  bem::ElementGeometry geometry{};
  geometry.tip = tip;
  return geometry.shape(tip == bem::TipEnd::start ? 2 * std::sqrt(part) - 1 : 1 - 2 * std::sqrt(1 - part));
}

}  // namespace

RegionCracks::RegionCracks(const Preparation& p, int region)
    : region_(region),
      halvings_(halvings_of(p.scene.region(region))),
      tolerance_(p.tolerance),
      paths_(paths_in(p, region)),
      extents_(extents_in(p, region)),
      edges_(edges_of(p.scene.region(region).outline())),
      lines_(crack_lines(paths_, edges_, p.tolerance)),
      rows_(mouths_on_rows(p, region)),
      sizes_(lines_, edges_, p.tolerance, grading(p.scene.region(region)), panel_ends(p, region),
             short_elements_at(p, region, rows_)) {
  const std::vector<SharedMouth> shared = shared_mouths(p.cracks);
  for (const Point& mouth : mouths()) {
    const auto is_at = [&](const SharedMouth& one) { return (one.place - mouth).norm() <= 8 * tolerance_; };
    if (is_on_row(mouth) || std::any_of(shared.begin(), shared.end(), is_at)) continue;
    for (const auto& other : p.regions)
      require(other->id() == region ||
                  locate(p.scene.region(other->id()).outline(), mouth, p.tolerance) == Location::outside,
              "a crack in region ", region, " reaches the interface with region ", other->id(), " at (", mouth.x(),
              ", ", mouth.y(),
              "); end it at a free edge or inside, or behind the interface if both regions are of one material");
  }
}

bool RegionCracks::is_on_row(const Point& mouth) const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [&](const auto& row) { return (row.place - mouth).norm() <= 8 * tolerance_; });
}

std::vector<Point> RegionCracks::mouths() const {
  std::vector<Point> places;
  for (const CrackJoint& joint : lines_.joints)
    if (joint.mouth) places.push_back(joint.place);
  return places;
}

std::string RegionCracks::gap_sentence(const bem::NarrowGap& gap) const {
  const auto name = [&](int line) { return text("crack ", paths_[lines_.lines[line].crack].id); };
  return text(name(gap.line), " lies ", gap.width, " from ", gap.other < 0 ? text("the boundary") : name(gap.other),
              " at (", gap.place.x(), ", ", gap.place.y(), ")");
}

double RegionCracks::memory_of(double elements) { return bytes_per_square_with_cracks * elements * elements; }

void RegionCracks::require_memory(const BoundaryMesh& boundary, const scene::Options& options) const {
  const double elements = static_cast<double>(boundary.elements.size() + mesh_.elements.size());
  if (elements < elements_to_tell_of) return;
  const bem::NarrowGap gap = sizes_.narrowest_gap();
  require_memory_for(memory_of(elements),
                     text(elements, " elements on the boundary and the cracks of region ", region_),
                     (gap.line < 0 ? text("") : gap_sentence(gap) + ", which takes short elements: widen that gap, ") +
                         "choose longer elements or fewer cracks",
                     options);
}

void RegionCracks::warn_of_gap(const BoundaryMesh& boundary, std::vector<std::string>& warnings) const {
  const double elements = static_cast<double>(boundary.elements.size() + mesh_.elements.size());
  if (elements < elements_to_tell_of) return;
  const bem::NarrowGap gap = sizes_.narrowest_gap();
  if (gap.line < 0 || gap.width > narrow_gap * lines_.lines[gap.line].length()) return;
  warnings.push_back(text("region ", region_, " has ", elements,
                          " elements on its boundary and cracks, for which preparing takes about ",
                          bytes_per_square_with_cracks * elements * elements / 1e9, " GB: ", gap_sentence(gap),
                          ", and elements along a gap are at most twice as long as it is wide; widen or close the gap "
                          "if it does not matter"));
}

bool RegionCracks::has(int crack) const {
  return std::any_of(paths_.begin(), paths_.end(), [&](const CrackPath& path) { return path.id == crack; });
}

double RegionCracks::fraction_at(int l, const Point& x) const {
  const CrackLine& line = lines_.lines[l];
  double way = 0, before = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Segment segment{line.points[i], line.points[i + 1]};
    const double along = closest_fraction(segment, x), gap = (segment.at(along) - x).norm();
    if (gap < least) least = gap, way = before + along * segment.length();
    before += segment.length();
  }
  const CrackExtent& extent = extents_[line.crack];
  return std::clamp((extent.start + line.start + way - extent.given_from) / extent.given_length, 0.0, 1.0);
}

bem::FaceTraction RegionCracks::traction(const std::vector<CrackLoad>& loads, double constant,
                                         double proportional) const {
  std::vector<CrackLoad> own;
  for (const CrackLoad& load : loads)
    if (has(load.crack)) own.push_back(load);
  if (own.empty()) return {};
  return [this, own, constant, proportional](int line, const Point& x, const Point& normal) -> Point {
    const double fraction = fraction_at(line, x);
    Point sum = Point::Zero();
    for (const CrackLoad& load : own) {
      if (load.crack != paths_[lines_.lines[line].crack].id) continue;
      const auto values = load.values(fraction);
      const Point both = constant * values[0] + proportional * values[1];
      sum += -both.x() * normal + both.y() * left_of(normal);
    }
    return sum;
  };
}

bool RegionCracks::has_inside(int crack) const {
  return std::any_of(mesh_.elements.begin(), mesh_.elements.end(),
                     [&](const bem::CrackElement& e) { return paths_[lines_.lines[e.line].crack].id == crack; });
}

// Openings at the three nodes of an element on a crack.
std::array<Point, 3> RegionCracks::openings_on(const bem::CrackElement& e, const bem::CrackedState& state) {
  std::array<Point, 3> openings;
  for (int k = 0; k < 3; ++k) openings[k] = state.openings.segment<2>(2 * e.nodes[k]);
  return openings;
}

std::array<Point, 3> RegionCracks::openings_on(const bem::CutElement& e, const bem::CrackedState& state) {
  std::array<Point, 3> openings;
  for (int k = 0; k < 3; ++k)
    openings[k] = state.displacements.segment<2>(2 * e.left[k]) - state.displacements.segment<2>(2 * e.right[k]);
  return openings;
}

std::vector<RegionCracks::Opened> RegionCracks::opened(const bem::CrackedState& state) const {
  std::vector<Opened> all;
  for (const bem::CrackElement& e : mesh_.elements)
    all.push_back({e.line,
                   e.from,
                   e.to,
                   e.tip,
                   {mesh_.nodes[e.nodes[0]], mesh_.nodes[e.nodes[1]], mesh_.nodes[e.nodes[2]]},
                   openings_on(e, state)});
  for (std::size_t c = 0; c < mesh_.cuts.size(); ++c)
    all.push_back({mesh_.cuts[c].line, mesh_.cuts[c].from, mesh_.cuts[c].to, bem::TipEnd::none, cut_places_[c],
                   openings_on(mesh_.cuts[c], state)});
  return all;
}

Point RegionCracks::opening_at(int crack, double fraction, const bem::CrackedState& state) const {
  Point found = Point::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const Opened& e : opened(state)) {
    const CrackLine& line = lines_.lines[e.line];
    if (paths_[line.crack].id != crack) continue;
    const CrackExtent& extent = extents_[line.crack];
    const double way = fraction * extent.length - extent.start - line.start;
    const double part = std::clamp((way - e.from) / (e.to - e.from), 0.0, 1.0);
    const double off = std::abs(way - (e.from + part * (e.to - e.from)));
    if (off >= least) continue;
    least = off;
    const auto shape = shape_at(e.tip, part);
    Point opening = Point::Zero();
    for (int k = 0; k < 3; ++k) opening += shape[k] * e.openings[k];
    const Point along = (e.places[2] - e.places[0]).normalized();
    found = {opening.dot(along), opening.dot(left_of(along))};
  }
  return found;
}

std::vector<CrackPicture> RegionCracks::pictures(const bem::CrackedState& state) const {
  std::vector<CrackPicture> all;
  for (const CrackPath& path : paths_) all.push_back({path.id, {}, {}, {}});
  for (const Opened& e : opened(state)) {
    CrackPicture& picture = all[lines_.lines[e.line].crack];
    picture.places.insert(picture.places.end(), e.places.begin(), e.places.end());
    picture.openings.insert(picture.openings.end(), e.openings.begin(), e.openings.end());
  }
  return all;
}

std::optional<Overlap> RegionCracks::overlap(const bem::CrackedState& state) const {
  Overlap worst{0, Point::Zero(), 0};
  double largest = 0;
  for (const Opened& e : opened(state)) {
    const Point left = left_of((e.places[2] - e.places[0]).normalized());
    for (int k = 0; k < 3; ++k) {
      largest = std::max(largest, e.openings[k].cwiseAbs().maxCoeff());
      const double depth = -left.dot(e.openings[k]);
      if (depth > worst.depth) worst = {paths_[lines_.lines[e.line].crack].id, e.places[k], depth};
    }
  }
  // An overlap within rounding is not reported; it occurs where faces slide on each other.
  if (worst.depth <= 1e-9 * largest) return std::nullopt;
  return worst;
}

std::unique_ptr<RegionCracks> cracks_of(const Preparation& p, int region) {
  const auto has_part = [&](const PartedCrack& crack) { return crack.has_elements_in(region); };
  if (std::none_of(p.cracks.begin(), p.cracks.end(), has_part)) return nullptr;
  return std::make_unique<RegionCracks>(p, region);
}

}  // namespace bempd::regions
