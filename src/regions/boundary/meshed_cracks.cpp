#include "regions/boundary/meshed_cracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bem/element_geometry.hpp"
#include "geometry/segment.hpp"

namespace bempd::regions {

namespace {

// Values of the three shape functions of an element at the fraction `part` of its length. `tip` is the end of the
// element that is a crack tip.
std::array<double, 3> shape_at(bem::TipEnd tip, double part) {
  if (tip == bem::TipEnd::none) return bem::ElementGeometry{}.shape(2 * part - 1);
  bem::ElementGeometry geometry{};
  geometry.tip = tip;
  return geometry.shape(tip == bem::TipEnd::start ? 2 * std::sqrt(part) - 1 : 1 - 2 * std::sqrt(1 - part));
}

}  // namespace

MeshedCracks::MeshedCracks(CracksToMesh cracks, BoundaryMesh& boundary, double tolerance)
    : tolerance_(tolerance),
      paths_(std::move(cracks.paths)),
      extents_(std::move(cracks.extents)),
      lines_(std::move(cracks.lines)),
      mesh_(bem::mesh_cracks(lines_, cracks.stations, boundary, tolerance)) {
  for (const bem::CutElement& e : mesh_.cuts)
    cut_places_.push_back({boundary.nodes[e.left[0]], boundary.nodes[e.left[1]], boundary.nodes[e.left[2]]});
}

std::vector<int> MeshedCracks::ids() const {
  std::vector<int> found;
  for (const CrackLine& line : lines_.lines) found.push_back(paths_[line.crack].id);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool MeshedCracks::has(int crack) const {
  return std::any_of(lines_.lines.begin(), lines_.lines.end(),
                     [&](const CrackLine& line) { return paths_[line.crack].id == crack; });
}

double MeshedCracks::fraction_at(int l, const Point& x) const {
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

bem::FaceTraction MeshedCracks::traction(const std::vector<CrackLoad>& loads, double constant,
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

bool MeshedCracks::has_inside(int crack) const {
  return std::any_of(mesh_.elements.begin(), mesh_.elements.end(),
                     [&](const bem::CrackElement& e) { return paths_[lines_.lines[e.line].crack].id == crack; });
}

// Openings at the three nodes of an element on a crack.
std::array<Point, 3> MeshedCracks::openings_on(const bem::CrackElement& e, const bem::CrackedState& state) {
  std::array<Point, 3> openings;
  for (int k = 0; k < 3; ++k) openings[k] = state.openings.segment<2>(2 * e.nodes[k]);
  return openings;
}

std::array<Point, 3> MeshedCracks::openings_on(const bem::CutElement& e, const bem::CrackedState& state) {
  std::array<Point, 3> openings;
  for (int k = 0; k < 3; ++k)
    openings[k] = state.displacements.segment<2>(2 * e.left[k]) - state.displacements.segment<2>(2 * e.right[k]);
  return openings;
}

std::vector<MeshedCracks::Opened> MeshedCracks::opened(const bem::CrackedState& state) const {
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

Point MeshedCracks::opening_at(int crack, double fraction, const bem::CrackedState& state) const {
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

std::vector<CrackPicture> MeshedCracks::pictures(const bem::CrackedState& state) const {
  std::vector<CrackPicture> all;
  std::vector<int> number(paths_.size(), -1);
  for (std::size_t path = 0; path < paths_.size(); ++path) {
    if (!has(paths_[path].id)) continue;
    number[path] = static_cast<int>(all.size());
    all.push_back({paths_[path].id, {}, {}, {}});
  }
  for (const Opened& e : opened(state)) {
    CrackPicture& picture = all[number[lines_.lines[e.line].crack]];
    picture.places.insert(picture.places.end(), e.places.begin(), e.places.end());
    picture.openings.insert(picture.openings.end(), e.openings.begin(), e.openings.end());
  }
  return all;
}

std::optional<Overlap> MeshedCracks::overlap(const bem::CrackedState& state) const {
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
  // An overlap within rounding is not reported. It occurs where faces slide on each other.
  if (worst.depth <= 1e-9 * largest) return std::nullopt;
  return worst;
}

}  // namespace bempd::regions
