#include "model/discretization.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "coupling/interface_trace.hpp"
#include "error.hpp"
#include "geometry/gaps.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

// An arc above an edge of a lattice leaves a gap, or overlaps: what was meant is an interface, and those are straight.
void require_straight_interfaces(const Scene& scene, double tolerance) {
  for (std::size_t r = 0; r < scene.regions().size(); ++r) {
    for (const auto& [number, edge] : scene.regions()[r].outline.curved) {
      for (std::size_t other = 0; other < scene.regions().size(); ++other) {
        if (scene.regions()[other].kind != RegionKind::peridynamics) continue;
        const Outline& lattice = scene.regions()[other].outline;
        const auto touches = [&](const Point& p) { return locate(lattice, p, tolerance) == Location::on_boundary; };
        const bool above = touches(edge.start) && touches(edge.end) && touches(Segment{edge.start, edge.end}.at(0.5));
        require(!above, "edge ", number + 1, " of region ", r + 1,
                " is curved, and its chord lies on the boundary of the peridynamic region ", other + 1,
                "; interfaces with peridynamic regions must be straight");
      }
    }
  }
}

void require_compatible(const Scene& scene, const Arrangement& arrangement, const Formulation& formulation) {
  if (const auto& overlap = arrangement.overlap) {
    require(false, "regions ", overlap->region_a + 1, " and ", overlap->region_b + 1, " overlap near (",
            overlap->where.x(), ", ", overlap->where.y(), "); regions may only share boundaries");
  }
  for (const PointTouch& hinge : arrangement.hinges) {
    require(false, "regions ", hinge.groups[0].front() + 1, " and ", hinge.groups[1].front() + 1, " touch only at (",
            hinge.where.x(), ", ", hinge.where.y(),
            "), which would be a hinge; let them share a piece of boundary or keep them apart");
  }
  for (const Contact& contact : arrangement.contacts) {
    const Region& a = scene.region(contact.region + 1);
    const Region& b = scene.region(contact.other_region + 1);
    if (a.kind != RegionKind::peridynamics || b.kind != RegionKind::peridynamics) continue;
    require(!formulation.paper, "peridynamic regions ", contact.region + 1, " and ", contact.other_region + 1,
            " touch; scheme paper couples peridynamic regions to boundary elements only: make them one region");
    const double spacing = a.lattice.spacing;
    const Point offset = (b.lattice.origin - a.lattice.origin) / spacing;
    const Point rounded = offset.array().round();
    require(std::abs(b.lattice.spacing / spacing - 1) < 1e-9 && (offset - rounded).norm() < 1e-6,
            "peridynamic regions ", contact.region + 1, " and ", contact.other_region + 1,
            " touch, but their lattices do not match (spacings ", spacing, " and ", b.lattice.spacing,
            "); give them the same spacing and corners that are whole spacings apart");
  }
}

// Material points that are nodes of other regions too: all on interfaces that match, the ends of others.
std::vector<char> shared_points(const Scene& scene, const Discretization& d, const LatticePart& part) {
  std::vector<char> shared(part.points.size(), 0);
  if (part.cell_centred) {
    for (int i = part.lattice->point_count(); i < part.point_count(); ++i) shared[i] = 1;
    return shared;
  }
  for (const Contact& contact : d.arrangement.contacts) {
    if (contact.region != part.region - 1) continue;
    const Edge edge = scene.region(part.region).edge(contact.edge + 1);
    const std::vector<int> points = part.points_along(edge.at(contact.from), edge.at(contact.to));
    if (!d.formulation.paper && scene.region(contact.other_region + 1).has_own_mesh(contact.other_edge + 1)) {
      shared[points.front()] = shared[points.back()] = 1;
    } else {
      for (int point : points) shared[point] = 1;
    }
  }
  return shared;
}

// Places of boundary nodes on the interfaces of a peridynamic region.
std::vector<Point> interface_nodes(const std::vector<BoundaryPart>& boundaries, int region) {
  std::vector<Point> places;
  for (const BoundaryPart& part : boundaries) {
    for (const BoundaryElement& element : part.mesh.elements) {
      if (part.panels[element.panel].other_region != region) continue;
      for (int node : element.nodes) places.push_back(part.mesh.nodes[node]);
    }
  }
  return places;
}

// Ties the lattice points of a panel's interface to the boundary nodes there.
void tie_lattice_points(const BoundaryPart& part, int panel, const LatticePart& lattice, coupling::NodeTies& ties) {
  std::vector<int> mesh_nodes;
  for (const BoundaryElement& element : part.mesh.elements) {
    if (element.panel != panel) continue;
    if (mesh_nodes.empty()) mesh_nodes.push_back(element.nodes[0]);
    mesh_nodes.insert(mesh_nodes.end(), {element.nodes[1], element.nodes[2]});
  }
  const Point start = part.mesh.nodes[mesh_nodes.front()], end = part.mesh.nodes[mesh_nodes.back()];
  const std::vector<int> points = lattice.points_along(start, end);
  std::vector<double> stations;
  for (std::size_t a = 0; a < mesh_nodes.size(); a += 2) {
    stations.push_back((part.mesh.nodes[mesh_nodes[a]] - start).norm() / lattice.spacing());
  }
  stations.back() = static_cast<double>(points.size() - 1);
  const auto trace = coupling::interface_trace(stations);
  require(trace.has_value(), "edge ", part.panels[panel].edge, " of region ", part.region,
          " has elements of its own on the interface with region ", lattice.region, ", from (", start.x(), ", ",
          start.y(), ") to (", end.x(), ", ", end.y(), "), that cannot be joined to its ", points.size(),
          " lattice points; leave out bempd_set_edge_mesh() for this edge, so that its elements follow the lattice");
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    std::vector<coupling::NodeTies::Master> masters;
    using Row = Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator;
    for (Row it(*trace, static_cast<Eigen::Index>(i)); it; ++it) {
      masters.push_back({part.node_of_mesh_node[mesh_nodes[it.col()]], it.value()});
    }
    ties.add(lattice.nodes[points[i]], std::move(masters));
  }
}

void add_lattice(const Scene& scene, int id, Discretization& d, NodeRegistry& registry, int threads) {
  const Region& region = scene.region(id);
  LatticePart part = make_lattice_part(id, region, d.formulation, interface_nodes(d.boundaries, id));
  number_nodes(part, shared_points(scene, d, part), registry);
  part.network = network_of(part, d.lattices, scene, d.formulation, threads);
  add_bonds(part, region, scene.material(region.material), d.formulation, d.bonds, d.critical_stretch);
  if (part.network->reduced) {
    d.warnings.push_back(text("region ", id, " has a shape for which no network of positive bonds with horizon ratio ",
                              region.horizon_ratio, " was found; it has bonds between nearest neighbours only"));
  }
  d.lattices.push_back(std::move(part));
}

// Regions that nearly touch are rarely meant to: coordinates have been rounded somewhere.
void warn_of_gaps(const Scene& scene, const std::vector<Outline>& outlines, Discretization& d) {
  constexpr double share = 0.1;
  std::vector<double> reach;
  for (const Region& region : scene.regions())
    reach.push_back(share * (region.kind == RegionKind::peridynamics ? region.lattice.spacing : region.element_length));
  const std::vector<Gap> gaps = close_gaps(outlines, reach);
  if (gaps.empty()) return;
  const auto narrower = [](const Gap& a, const Gap& b) { return a.width < b.width; };
  const Gap& gap = *std::min_element(gaps.begin(), gaps.end(), narrower);
  const std::string others = gaps.size() > 1 ? text(" (and ", gaps.size() - 1, " more such pairs)") : "";
  d.warnings.push_back(text("regions ", gap.region_a + 1, " and ", gap.region_b + 1, " lie ", gap.width, " apart at (",
                            gap.where.x(), ", ", gap.where.y(), "), less than a tenth of their elements", others,
                            "; they are not bonded there, as places count as one up to ", d.tolerance,
                            " only: let them share vertices if they belong together"));
}

}  // namespace

const BoundaryPart* Discretization::boundary_of(int region) const {
  for (const BoundaryPart& part : boundaries) {
    if (part.region == region) return &part;
  }
  return nullptr;
}

const LatticePart* Discretization::lattice_of(int region) const {
  for (const LatticePart& part : lattices) {
    if (part.region == region) return &part;
  }
  return nullptr;
}

std::vector<coupling::DenseOperator> Discretization::dense_operators() const {
  std::vector<coupling::DenseOperator> operators;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    operators.push_back(boundaries[i].dense_operator(std::span(boundaries).first(i), operators));
  }
  return operators;
}

std::int64_t Discretization::kernel_evaluations() const {
  std::set<const bem::BoundaryOperator*> operators;
  for (const BoundaryPart& part : boundaries) operators.insert(part.boundary_operator.get());
  std::int64_t sum = 0;
  for (const bem::BoundaryOperator* one : operators) sum += one->kernel_evaluations();
  return sum;
}

Discretization discretize(const Scene& scene, const Options& options) {
  Discretization d;
  d.formulation = Formulation::from(options);
  std::vector<Outline> outlines;
  for (const Region& region : scene.regions()) outlines.push_back(region.outline);
  const Box box = scene.bounding_box();
  d.tolerance = geometric_tolerance(box);
  d.arrangement = arrange(outlines);
  warn_of_gaps(scene, outlines, d);
  require_straight_interfaces(scene, d.tolerance);
  require_compatible(scene, d.arrangement, d.formulation);

  const int region_count = static_cast<int>(scene.regions().size());
  const auto is_lattice = [&](int id) { return scene.region(id).kind == RegionKind::peridynamics; };
  for (int id = 1; id <= region_count; ++id) {
    if (is_lattice(id)) continue;
    const Stopwatch watch(d.seconds_boundary);
    BoundaryPanels panels = mesh_edges(scene, d.arrangement, d.formulation, d.tolerance, id);
    d.boundaries.push_back({id,
                            std::move(panels.sources),
                            mesh_boundary(panels.loops, d.formulation.corner_tractions),
                            {},
                            {},
                            {},
                            nullptr,
                            {}});
  }
  NodeRegistry registry(box.min(), 10 * d.tolerance);
  std::size_t boundary = 0;
  for (int id = 1; id <= region_count; ++id) {
    const Stopwatch watch(is_lattice(id) ? d.seconds_lattice : d.seconds_boundary);
    if (is_lattice(id)) {
      add_lattice(scene, id, d, registry, options.whole_number("threads"));
      continue;
    }
    BoundaryPart& part = d.boundaries[boundary];
    number_nodes(part, d.formulation, registry);
    build_operator(part, {d.boundaries.data(), boundary++}, scene, d.formulation, options);
  }
  for (const BoundaryPart& part : d.boundaries) {
    for (std::size_t p = 0; p < part.panels.size(); ++p) {
      if (!part.panels[p].tied) continue;
      tie_lattice_points(part, static_cast<int>(p), *d.lattice_of(part.panels[p].other_region), d.ties);
    }
  }
  d.positions = registry.positions();
  return d;
}

}  // namespace bempd::model
