#include "regions/discretization.hpp"

#include <algorithm>

#include "cancellation.hpp"
#include "error.hpp"
#include "geometry/gaps.hpp"
#include "regions/interfaces.hpp"
#include "regions/outlined/common_bodies.hpp"
#include "regions/scheme.hpp"
#include "stopwatch.hpp"

namespace bempd::regions {

namespace {

// Warns of regions that lie closer together than a tenth of an element but do not touch; usually their coordinates were
// rounded. `Discretization::gap` keeps the sentence about the narrowest gap.
void warn_of_gaps(const scene::Scene& scene, const std::vector<Outline>& outlines, Discretization& d) {
  constexpr double share = 0.1;
  std::vector<double> reach;
  for (int id : scene.region_ids()) reach.push_back(share * scene.region(id).resolution());
  const std::vector<Gap> gaps = close_gaps(outlines, reach);
  if (gaps.empty()) return;
  const auto narrower = [](const Gap& a, const Gap& b) { return a.width < b.width; };
  const Gap& gap = *std::min_element(gaps.begin(), gaps.end(), narrower);
  const std::string others = gaps.size() > 1 ? text(" (and ", gaps.size() - 1, " more such pairs)") : "";
  const std::vector<int> ids = scene.region_ids();
  d.gap = text("regions ", ids[gap.region_a], " and ", ids[gap.region_b], " lie ", gap.width, " apart at (",
               gap.where.x(), ", ", gap.where.y(), "), less than a tenth of their elements", others,
               "; they are not bonded there, as places count as one up to ", d.tolerance,
               " only: let them share vertices if they belong together");
  d.warnings.push_back(d.gap);
}

// Renumbers the regions of an arrangement from indices of its outlines to region ids minus 1. These numbers differ if
// regions were removed.
void number_by_ids(Arrangement& arrangement, const scene::Scene& scene) {
  const std::vector<int> ids = scene.region_ids();
  if (static_cast<int>(ids.size()) == scene.region_count()) return;
  const auto number = [&](int& index) { index = ids[index] - 1; };
  for (Contact& contact : arrangement.contacts) number(contact.region), number(contact.other_region);
  if (arrangement.overlap) number(arrangement.overlap->region_a), number(arrangement.overlap->region_b);
  for (PointTouch& hinge : arrangement.hinges) {
    for (auto& group : hinge.groups) std::for_each(group.begin(), group.end(), number);
  }
  auto breakpoints = std::move(arrangement.breakpoints);
  arrangement.breakpoints.assign(static_cast<std::size_t>(scene.region_count()), {});
  for (std::size_t i = 0; i < ids.size(); ++i) arrangement.breakpoints[ids[i] - 1] = std::move(breakpoints[i]);
}

const std::unique_ptr<Region>& region_of(const Discretization& d, int id) {
  const auto reaches = [](const std::unique_ptr<Region>& region, int wanted) { return region->id() < wanted; };
  return *std::lower_bound(d.regions.begin(), d.regions.end(), id, reaches);
}

// Ties nodes of the region `leading.follower` to elements of the region `leader`.
void follow(Discretization& d, const LeadingElements& leading, int leader) {
  const PointBorders* follower = region_of(d, leading.follower)->point_borders();
  if (!follower)
    throw std::logic_error(text("region ", leading.follower, " cannot follow the elements of region ", leader));
  follower->follow(leading, leader, d.ties);
}

std::string names_of(const std::vector<int>& regions) {
  std::string names = regions.size() > 1 ? "regions " : "region ";
  for (std::size_t i = 0; i < regions.size(); ++i)
    names += (i == 0 ? "" : i + 1 == regions.size() ? " and " : ", ") + std::to_string(regions[i]);
  return names;
}

}  // namespace

const Region& Discretization::region(int id) const { return *region_of(*this, id); }

std::vector<coupling::DenseOperator> Discretization::dense_operators() const {
  std::vector<KnownOperator> known;
  for (const auto& region : regions) {
    check_cancelled();
    const RegionOperators* own = region->operators();
    if (!own) continue;
    for (coupling::DenseOperator& one : own->dense_operators(known)) known.push_back({own, std::move(one)});
  }
  std::vector<coupling::DenseOperator> operators;
  operators.reserve(known.size());
  for (KnownOperator& one : known) operators.push_back(std::move(one.dense));
  return operators;
}

std::string Discretization::regions_with(const std::vector<int>& nodes) const {
  std::vector<char> member(positions.size(), 0);
  for (int node : nodes) member[node] = 1;
  std::vector<int> ids;
  for (const auto& region : regions) {
    const std::vector<int>& own = region->nodes();
    if (std::any_of(own.begin(), own.end(), [&](int node) { return member[node] != 0; })) ids.push_back(region->id());
  }
  return names_of(ids);
}

RegionStatistics Discretization::statistics() const {
  RegionStatistics sum;
  for (const auto& region : regions) region->add_statistics(sum);
  return sum;
}

namespace {

// Discretization of a scene that has only the common edges and gaps of its regions. They are copied from `before` if
// that is not null, because both scenes have the same outlines.
Discretization arranged(const scene::Scene& scene, const Discretization* before) {
  Discretization d;
  d.tolerance = geometric_tolerance(scene.bounding_box());
  if (before) {
    d.arrangement = before->arrangement;
    if (!before->gap.empty()) d.warnings.push_back(d.gap = before->gap);
  } else {
    std::vector<Outline> outlines;
    for (int id : scene.region_ids()) outlines.push_back(scene.region(id).outline());
    d.arrangement = arrange(outlines);
    number_by_ids(d.arrangement, scene);
    warn_of_gaps(scene, outlines, d);
  }
  return d;
}

// Builds the regions of a scene, and their cracks, nodes, bonds and ties.
void build(Discretization& d, const Preparation& preparation) {
  const scene::Scene& scene = preparation.scene;
  for (int id : scene.region_ids()) {
    d.regions.push_back(scene.region(id).build(id, preparation));
    d.regions.back()->vary_toughness({scene.region(id).fracture_energies(), scene.material_of(id).fracture_energy});
  }
  d.cracks = parted_cracks(preparation, d.warnings);
  for (const auto& region : d.regions) {
    check_cancelled();
    const Stopwatch watch(region->seconds_preparing);
    region->mesh(preparation);
  }
  NodeRegistry registry(scene.bounding_box().min(), 10 * d.tolerance);
  Contributions contributions{registry, d.bonds, d.critical_stretch, d.warnings};
  for (const auto& region : d.regions) {
    check_cancelled();
    const Stopwatch watch(region->seconds_preparing);
    region->build(preparation, contributions);
  }
  for (const auto& region : d.regions) {
    if (const ElementBorders* borders = region->element_borders())
      for (const LeadingElements& leading : borders->leading_elements()) follow(d, leading, region->id());
  }
  d.positions = registry.positions();
}

// Discretizes the scene. Lattice regions with a neighbour of another outline get points on their outlines instead of
// following lattice rows, so that both are one body; the regions `on_rows` (ids, ascending) keep their rows. Throws
// CannotLeaveRows if no network of bonds can be built for such a body.
Discretization discretize(const scene::Scene& scene, const scene::Options& options, const Discretization* before,
                          const std::vector<int>& on_rows) {
  Discretization d = arranged(scene, before);
  const std::unique_ptr<Scheme> scheme = make_scheme(options);
  const Preparation preparation{scene,
                                options,
                                *scheme,
                                d.arrangement,
                                d.tolerance,
                                d.regions,
                                d.cracks,
                                d.off_rows,
                                before ? &before->regions : nullptr,
                                before ? &before->cracks : nullptr};
  require_compatible(preparation);
  d.off_rows = before ? before->off_rows : regions_leaving_rows(preparation);
  std::erase_if(d.off_rows, [&](int id) { return std::binary_search(on_rows.begin(), on_rows.end(), id); });
  build(d, preparation);
  return d;
}

}  // namespace

Discretization discretize(const scene::Scene& scene, const scene::Options& options, const Discretization* before) {
  std::vector<int> on_rows;
  std::vector<std::string> warnings;
  for (;;) {
    try {
      Discretization d = discretize(scene, options, before, on_rows);
      d.warnings.insert(d.warnings.end(), warnings.begin(), warnings.end());
      return d;
    } catch (const CannotLeaveRows& body) {
      on_rows.insert(on_rows.end(), body.regions.begin(), body.regions.end());
      std::sort(on_rows.begin(), on_rows.end());
      warnings.push_back(text("no network of positive bonds was found for ", names_of(body.regions),
                              " together: no bond crosses their common edges with lattice rows, and cracks across "
                              "these meet loads up to 22 % off; make parts at least three spacings wide, or one region "
                              "where cracks are expected"));
    }
  }
}

}  // namespace bempd::regions
