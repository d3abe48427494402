#include "regions/boundary/region_cracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"
#include "geometry/turning.hpp"
#include "linalg/disjoint_sets.hpp"
#include "regions/memory_limit.hpp"

namespace bempd::regions {

namespace {

// Of the matrices that exist at the same time while an operator with cracks is built: measured with 400 to 900
// elements.
constexpr double bytes_per_square_with_cracks = 600;

// From here on preparing takes seconds. Gaps below this share of a crack's length are then the reason.
constexpr double elements_to_tell_of = 500, narrow_gap = 0.03;

std::vector<CrackPath> paths_in(const Preparation& p, int region) {
  std::vector<CrackPath> paths;
  for (std::size_t c = 0; c < p.crack_regions.size(); ++c)
    if (const scene::Crack& crack = p.scene.cracks()[c]; p.crack_regions[c] == region)
      paths.push_back({static_cast<int>(c) + 1, crack.points, crack.grown_at_start, crack.grown_at_end});
  return paths;
}

double way_to(const CrackPath& path, int point) {
  double sum = 0;
  for (int i = 0; i < point; ++i) sum += (path.points[i + 1] - path.points[i]).norm();
  return sum;
}

// Values of the element's functions at a part of its length.
std::array<double, 3> shape_at(const bem::CrackElement& element, double part) {
  if (element.tip == bem::TipEnd::none) return bem::ElementGeometry{}.shape(2 * part - 1);
  bem::ElementGeometry geometry{};
  geometry.tip = element.tip;
  return geometry.shape(element.tip == bem::TipEnd::start ? 2 * std::sqrt(part) - 1 : 1 - 2 * std::sqrt(1 - part));
}

}  // namespace

RegionCracks::RegionCracks(const Preparation& p, int region)
    : region_(region),
      tolerance_(p.tolerance),
      paths_(paths_in(p, region)),
      edges_(edges_of(p.scene.region(region).outline())),
      lines_(crack_lines(paths_, edges_, p.tolerance)),
      sizes_(lines_, edges_, p.tolerance, {}, panel_ends(p, region)) {
  for (const Point& mouth : mouths()) {
    for (const auto& other : p.regions)
      require(other->id() == region ||
                  locate(p.scene.region(other->id()).outline(), mouth, p.tolerance) == Location::outside,
              "a crack in region ", region, " reaches the interface with region ", other->id(), " at (", mouth.x(),
              ", ", mouth.y(), "); end it at a free edge or inside");
  }
  require_one_piece(p, region);
}

// Lines that close a ring, the boundary's loops counting as places, cut the body into pieces.
void RegionCracks::require_one_piece(const Preparation& p, int region) const {
  const Outline& outline = p.scene.region(region).outline();
  const int joints = static_cast<int>(lines_.joints.size());
  linalg::DisjointSets joined(joints + static_cast<int>(outline.loops.size()));
  for (int j = 0; j < joints; ++j) {
    if (!lines_.joints[j].mouth) continue;
    std::size_t edge = 0;
    for (std::size_t loop = 0; loop < outline.loops.size(); ++loop)
      for (std::size_t k = 0; k < outline.loops[loop].size(); ++k, ++edge)
        if (distance(edges_[edge], lines_.joints[j].place) <= 8 * tolerance_)
          joined.join(j, joints + static_cast<int>(loop));
  }
  for (const CrackLine& line : lines_.lines) {
    if (line.joints[0] < 0 || line.joints[1] < 0) continue;
    require(joined.find(line.joints[0]) != joined.find(line.joints[1]), "crack ", paths_[line.crack].id,
            " completes a cut through region ", region, " near (", line.points.front().x(), ", ",
            line.points.front().y(), "); leave a ligament, or describe the pieces as regions of their own");
    joined.join(line.joints[0], line.joints[1]);
  }
}

std::vector<Point> RegionCracks::mouths() const {
  std::vector<Point> places;
  for (const CrackJoint& joint : lines_.joints)
    if (joint.mouth) places.push_back(joint.place);
  return places;
}

void RegionCracks::mesh(BoundaryMesh& boundary) {
  mesh_ = bem::mesh_cracks(lines_, sizes_.stations(), boundary, tolerance_);
}

std::string RegionCracks::gap_sentence(const bem::NarrowGap& gap) const {
  const auto name = [&](int line) { return text("crack ", paths_[lines_.lines[line].crack].id); };
  return text(name(gap.line), " lies ", gap.width, " from ", gap.other < 0 ? text("the boundary") : name(gap.other),
              " at (", gap.place.x(), ", ", gap.place.y(), ")");
}

void RegionCracks::require_memory(const BoundaryMesh& boundary, const scene::Options& options) const {
  const double elements = static_cast<double>(boundary.elements.size() + mesh_.elements.size());
  if (elements < elements_to_tell_of) return;
  const bem::NarrowGap gap = sizes_.narrowest_gap();
  require_memory_for(bytes_per_square_with_cracks * elements * elements,
                     text(elements, " elements on the boundary and the cracks of region ", region_),
                     (gap.line < 0 ? text("") : gap_sentence(gap) + ", which takes short elements: widen that gap, ") +
                         "choose longer elements or fewer cracks",
                     options);
}

void RegionCracks::tell_of_gap(const BoundaryMesh& boundary, std::vector<std::string>& warnings) const {
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

double RegionCracks::length_of(int path) const { return way_to(paths_[path], paths_[path].segments()); }

double RegionCracks::fraction_at(int l, const Point& x) const {
  const CrackLine& line = lines_.lines[l];
  double way = 0, before = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Segment segment{line.points[i], line.points[i + 1]};
    const double along = closest_fraction(segment, x), gap = (segment.at(along) - x).norm();
    if (gap < least) least = gap, way = before + along * segment.length();
    before += segment.length();
  }
  const CrackPath& path = paths_[line.crack];
  const double start = way_to(path, path.grown_at_start),
               length = way_to(path, path.segments() - path.grown_at_end) - start;
  return std::clamp((line.start + way - start) / length, 0.0, 1.0);
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

Point RegionCracks::opening_at(int crack, double fraction, const Eigen::VectorXd& openings) const {
  Point found = Point::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (const bem::CrackElement& e : mesh_.elements) {
    const CrackLine& line = lines_.lines[e.line];
    if (paths_[line.crack].id != crack) continue;
    const double way = fraction * length_of(line.crack) - line.start;
    const double part = std::clamp((way - e.from) / (e.to - e.from), 0.0, 1.0);
    const double off = std::abs(way - (e.from + part * (e.to - e.from)));
    if (off >= least) continue;
    least = off;
    const auto shape = shape_at(e, part);
    Point opening = Point::Zero();
    for (int k = 0; k < 3; ++k) opening += shape[k] * openings.segment<2>(2 * e.nodes[k]);
    const Point along = (mesh_.nodes[e.nodes[2]] - mesh_.nodes[e.nodes[0]]).normalized();
    found = {opening.dot(along), opening.dot(left_of(along))};
  }
  return found;
}

std::vector<CrackPicture> RegionCracks::pictures(const Eigen::VectorXd& openings) const {
  std::vector<CrackPicture> all;
  for (const CrackPath& path : paths_) all.push_back({path.id, {}, {}, {}});
  for (const bem::CrackElement& e : mesh_.elements) {
    CrackPicture& picture = all[lines_.lines[e.line].crack];
    for (const int n : e.nodes) {
      picture.places.push_back(mesh_.nodes[n]);
      picture.openings.emplace_back(openings.segment<2>(2 * n));
    }
  }
  return all;
}

std::optional<Overlap> RegionCracks::overlap(const Eigen::VectorXd& openings) const {
  Overlap worst{0, Point::Zero(), 0};
  for (const bem::CrackElement& e : mesh_.elements) {
    const Point left = left_of((mesh_.nodes[e.nodes[2]] - mesh_.nodes[e.nodes[0]]).normalized());
    for (const int n : e.nodes) {
      const double depth = -left.dot(openings.segment<2>(2 * n));
      if (depth > worst.depth) worst = {paths_[lines_.lines[e.line].crack].id, mesh_.nodes[n], depth};
    }
  }
  // Faces that slide on each other part by rounding.
  if (worst.depth <= 1e-9 * openings.cwiseAbs().maxCoeff()) return std::nullopt;
  return worst;
}

std::unique_ptr<RegionCracks> cracks_of(const Preparation& p, int region) {
  if (std::find(p.crack_regions.begin(), p.crack_regions.end(), region) == p.crack_regions.end()) return nullptr;
  return std::make_unique<RegionCracks>(p, region);
}

void refine_at_cracks(const Preparation& p, const RegionCracks* own, BoundaryPanels& panels) {
  if (std::all_of(p.crack_regions.begin(), p.crack_regions.end(), [](int id) { return id == 0; })) return;
  std::size_t number = 0;
  for (auto& loop : panels.loops) {
    for (Panel& panel : loop) {
      const PanelSource& source = panels.sources[number++];
      if (source.border == Border::grid) continue;
      if (own) panel.stations = own->sizes().refined(panel.arc(), panel.stations);
      if (source.border != Border::elements) continue;
      if (const auto other = cracks_of(p, source.other_region))
        panel.stations = other->sizes().refined(panel.arc(), panel.stations);
    }
  }
}

}  // namespace bempd::regions
