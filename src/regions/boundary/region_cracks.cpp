#include "regions/boundary/region_cracks.hpp"

#include <algorithm>

#include "error.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/crack_crossings.hpp"
#include "regions/memory_limit.hpp"

namespace bempd::regions {

namespace {

// Memory estimate of an operator with cracks: bytes per square of the number of elements, for the matrices that exist
// at the same time while it is built. Measured with 400 to 900 elements.
constexpr double bytes_per_square_with_cracks = 600;

// Number of elements from which on preparing takes seconds, so that a warning is given.
constexpr double elements_to_warn_of = 500;

// Ratio of a gap's width to the crack's length below which the warning names the gap as the reason.
constexpr double narrow_gap = 0.03;

// Calls visit(crack, its id, part) for all parts of cracks that have elements in the region.
template <class Visit>
void for_each_part(const Preparation& p, int region, const Visit& visit) {
  for (std::size_t c = 0; c < p.cracks.size(); ++c)
    for (const CrackPart& part : p.cracks[c].parts)
      if (part.region == region) visit(p.cracks[c].crack, static_cast<int>(c) + 1, part);
}

// Distances along a grown crack at which the part that the host described begins and ends.
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

// Largest length of an element at a mouth that is shared with another boundary element region, relative to the distance
// from the mouth to the crack's next bend or end in that region.
constexpr double longest_element_at_mouth = 0.5;

std::vector<bem::MouthOnRow> short_elements_at(const Preparation& p, int region, std::vector<bem::MouthOnRow> mouths) {
  for_each_part(p, region, [&](const scene::Crack&, int, const CrackPart& part) {
    if (part.reach_before > 0) mouths.push_back({part.points.front(), longest_element_at_mouth * part.reach_before});
    if (part.reach_behind > 0) mouths.push_back({part.points.back(), longest_element_at_mouth * part.reach_behind});
  });
  return mouths;
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
             short_elements_at(p, region, rows_)),
      stations_(halved_stations()) {
  const std::vector<SharedMouth> shared = shared_mouths(p.cracks);
  for (const Point& mouth : mouths()) {
    const auto is_at = [&](const SharedMouth& one) { return (one.place - mouth).norm() <= 8 * tolerance_; };
    if (is_on_row(mouth) || std::any_of(shared.begin(), shared.end(), is_at)) {
      continue_elsewhere_ = true;
      continue;
    }
    for (const auto& other : p.regions)
      require(other->id() == region || !scene::contains(p.scene, other->id(), mouth, p.tolerance), "a crack in region ",
              region, " reaches the interface with region ", other->id(), " at (", mouth.x(), ", ", mouth.y(),
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

double RegionCracks::elements_on_cracks() const {
  std::size_t count = 0;
  for (const std::vector<double>& line : stations_) count += line.size() - 1;
  return static_cast<double>(count);
}

double RegionCracks::memory_of(double elements) { return bytes_per_square_with_cracks * elements * elements; }

void RegionCracks::require_memory(const BoundaryMesh& boundary, const scene::Options& options) const {
  const double elements = static_cast<double>(boundary.elements.size()) + elements_on_cracks();
  if (elements < elements_to_warn_of) return;
  const bem::NarrowGap gap = sizes_.narrowest_gap();
  require_memory_for(memory_of(elements),
                     text(elements, " elements on the boundary and the cracks of region ", region_),
                     (gap.line < 0 ? text("") : gap_sentence(gap) + ", which takes short elements: widen that gap, ") +
                         "choose longer elements or fewer cracks",
                     options);
}

void RegionCracks::warn_of_gap(const BoundaryMesh& boundary, std::vector<std::string>& warnings) const {
  const double elements = static_cast<double>(boundary.elements.size()) + elements_on_cracks();
  if (elements < elements_to_warn_of) return;
  const bem::NarrowGap gap = sizes_.narrowest_gap();
  if (gap.line < 0 || gap.width > narrow_gap * lines_.lines[gap.line].length()) return;
  warnings.push_back(text("region ", region_, " has ", elements,
                          " elements on its boundary and cracks, for which preparing takes about ",
                          bytes_per_square_with_cracks * elements * elements / 1e9, " GB: ", gap_sentence(gap),
                          ", and elements along a gap are at most twice as long as it is wide; widen or close the gap "
                          "if it does not matter"));
}

std::unique_ptr<RegionCracks> cracks_of(const Preparation& p, int region) {
  const auto has_part = [&](const PartedCrack& crack) { return crack.has_elements_in(region); };
  if (std::none_of(p.cracks.begin(), p.cracks.end(), has_part)) return nullptr;
  return std::make_unique<RegionCracks>(p, region);
}

}  // namespace bempd::regions
