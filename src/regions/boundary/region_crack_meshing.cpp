#include <algorithm>

#include "geometry/halving.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/boundary/region_cracks.hpp"

// Elements on the cracks of a region, and elements on the region's boundary near cracks.
namespace bempd::regions {

namespace {

// Merges the elements on a crack line (piece of a crack between tips, mouths and places where cracks meet) in pairs,
// `times` times. The ends and bends of the line stay ends of elements, and the element at a tip stays as it is.
std::vector<double> merged(const std::vector<double>& stations, const CrackLine& line, int times) {
  std::vector<double> bends{0.0};
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    bends.push_back(bends.back() + (line.points[i + 1] - line.points[i]).norm());
  std::vector<double> keep{stations.front()}, result;
  if (line.joints[0] < 0) keep.push_back(stations[1]);
  const double close = 1e-12 * bends.back();
  for (const double bend : bends) {
    const auto at = std::lower_bound(stations.begin(), stations.end(), bend - close);
    if (at != stations.end()) keep.push_back(*at);
  }
  if (line.joints[1] < 0) keep.push_back(stations[stations.size() - 2]);
  std::sort(keep.begin(), keep.end());
  keep.erase(std::unique(keep.begin(), keep.end()), keep.end());
  for (std::size_t k = 0; k + 1 < keep.size(); ++k) {
    const auto from = std::lower_bound(stations.begin(), stations.end(), keep[k]);
    const auto to = std::upper_bound(stations.begin(), stations.end(), keep[k + 1]);
    const std::vector<double> part = halved({from, to}, -times);
    result.insert(result.end(), part.begin(), part.end() - 1);
  }
  result.push_back(stations.back());
  return result;
}

}  // namespace

// Grading of the elements on cracks. In bodies it is half as fine as in other regions, because the elements of bodies
// are halved at least once.
bem::CrackGrading RegionCracks::grading(const scene::Region& region) {
  bem::CrackGrading grading;
  if (is_body(region)) grading.elements_per_line /= 2, grading.elements_per_growth /= 2;
  return grading;
}

// Ends of the elements on each crack line. Elements are halved or merged as often as those of the region, but not
// merged at tips. A line that ends between two material points of a lattice keeps its elements, of which the one at the
// lattice is as long as the spacing.
std::vector<std::vector<double>> RegionCracks::halved_stations() const {
  std::vector<std::vector<double>> all = sizes_.stations();
  for (std::size_t l = 0; l < all.size(); ++l) {
    const CrackLine& line = lines_.lines[l];
    const auto on_row = [&](int joint) { return joint >= 0 && is_on_row(lines_.joints[joint].place); };
    if (on_row(line.joints[0]) || on_row(line.joints[1])) continue;
    all[l] = halvings_ < 0 ? merged(all[l], line, -halvings_) : halved(all[l], halvings_);
  }
  return all;
}

std::unique_ptr<MeshedCracks> RegionCracks::mesh(BoundaryMesh& boundary) const {
  return std::make_unique<MeshedCracks>(CracksToMesh{paths_, extents_, lines_, stations_}, boundary, tolerance_);
}

std::unique_ptr<MeshedCracks> RegionCracks::mesh(const std::vector<int>& lines, BoundaryMesh& boundary) const {
  CracksToMesh own{paths_, extents_, {}, {}};
  std::vector<int> joint_of(lines_.joints.size(), -1);
  for (const int l : lines) {
    CrackLine line = lines_.lines[static_cast<std::size_t>(l)];
    for (int& joint : line.joints) {
      if (joint < 0) continue;
      int& number = joint_of[static_cast<std::size_t>(joint)];
      if (number < 0) {
        number = static_cast<int>(own.lines.joints.size());
        own.lines.joints.push_back(lines_.joints[static_cast<std::size_t>(joint)]);
      }
      joint = number;
    }
    own.lines.lines.push_back(std::move(line));
    own.stations.push_back(stations_[static_cast<std::size_t>(l)]);
  }
  return std::make_unique<MeshedCracks>(std::move(own), boundary, tolerance_);
}

std::vector<Stations> RegionCracks::places() const {
  std::vector<Stations> all;
  for (std::size_t l = 0; l < stations_.size(); ++l) {
    const std::vector<Point>& points = lines_.lines[l].points;
    all.emplace_back();
    std::size_t segment = 0;
    double before = 0;
    for (const double way : stations_[l]) {
      const auto length = [&] { return (points[segment + 1] - points[segment]).norm(); };
      while (segment + 2 < points.size() && way > before + length()) before += length(), ++segment;
      all.back().push_back(Segment{points[segment], points[segment + 1]}.at(std::min(1.0, (way - before) / length())));
    }
  }
  return all;
}

void refine_at_cracks(const Preparation& p, const RegionCracks* own, BoundaryPanels& panels) {
  if (std::none_of(p.cracks.begin(), p.cracks.end(), [](const auto& crack) { return crack.has_elements(); })) return;
  std::size_t number = 0;
  for (auto& loop : panels.loops) {
    for (Panel& panel : loop) {
      const PanelSource& source = panels.sources[number++];
      const bool at_mouth = own && (own->is_on_row(panel.start) || own->is_on_row(panel.end));
      if (source.border == Border::grid && !(source.tied && at_mouth)) continue;
      // Regions on an interface get the same elements if each of them refines for the cracks of the region with the
      // lower id first.
      const auto other = source.border == Border::elements ? cracks_of(p, source.other_region) : nullptr;
      std::array<const RegionCracks*, 2> both{own, other.get()};
      if (own && other && other->region() < own->region()) std::swap(both[0], both[1]);
      for (const RegionCracks* cracks : both)
        if (cracks) panel.stations = cracks->sizes().refined(panel.arc(), panel.stations);
    }
  }
}

}  // namespace bempd::regions
