#include "model/discretization.hpp"

#include <cmath>
#include <limits>

#include "coupling/interface_trace.hpp"
#include "error.hpp"
#include "model/node_registry.hpp"
#include "stopwatch.hpp"

namespace bempd::model {

namespace {

void require_compatible(const Scene& scene, const Arrangement& arrangement) {
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
    const double spacing = a.lattice.spacing;
    const Point offset = (b.lattice.origin - a.lattice.origin) / spacing;
    const Point rounded = offset.array().round();
    require(std::abs(b.lattice.spacing / spacing - 1) < 1e-9 && (offset - rounded).norm() < 1e-6,
            "peridynamic regions ", contact.region + 1, " and ", contact.other_region + 1,
            " touch, but their lattices do not match (spacings ", spacing, " and ", b.lattice.spacing,
            "); give them the same spacing and corners that are whole spacings apart");
  }
}

// Material points of a lattice that are nodes of other regions too: all on interfaces that match, the ends of others.
std::vector<char> shared_points(const Scene& scene, const Arrangement& arrangement, const LatticePart& part) {
  std::vector<char> shared(part.lattice->point_count(), 0);
  for (const Contact& contact : arrangement.contacts) {
    if (contact.region != part.region - 1) continue;
    const Segment edge = scene.region(part.region).edge(contact.edge + 1);
    const std::vector<int> points = part.points_along(edge.at(contact.from), edge.at(contact.to));
    if (scene.region(contact.other_region + 1).has_own_mesh(contact.other_edge + 1)) {
      shared[points.front()] = shared[points.back()] = 1;
    } else {
      for (int point : points) shared[point] = 1;
    }
  }
  return shared;
}

void number_lattice_nodes(const Scene& scene, const Arrangement& arrangement, LatticePart& part,
                          NodeRegistry& registry) {
  const std::vector<char> shared = shared_points(scene, arrangement, part);
  part.nodes.resize(part.lattice->point_count());
  for (int i = 0; i < part.lattice->point_count(); ++i) {
    part.nodes[i] = shared[i] ? registry.add_shared(part.position(i), part.region) : registry.add(part.position(i));
  }
}

void number_boundary_nodes(BoundaryPart& part, NodeRegistry& registry) {
  const auto count = part.mesh.nodes.size();
  std::vector<char> shared(count, 0), slaved(count, 0);
  std::vector<std::array<int, 2>> masters(count);
  for (std::size_t e = 0; e < part.mesh.elements.size(); ++e) {
    const BoundaryElement& element = part.mesh.elements[e];
    const PanelSource& panel = part.panels[element.panel];
    if (panel.border == Border::free) continue;
    if (panel.tied) {
      if (e == 0 || part.mesh.elements[e - 1].panel != element.panel) shared[element.nodes[0]] = 1;
      if (e + 1 == part.mesh.elements.size() || part.mesh.elements[e + 1].panel != element.panel) {
        shared[element.nodes[2]] = 1;
      }
      continue;
    }
    for (int node : element.nodes) shared[node] = 1;
    if (panel.border == Border::peridynamics) {
      slaved[element.nodes[1]] = 1;
      masters[element.nodes[1]] = {element.nodes[0], element.nodes[2]};
    }
  }
  part.node_of_mesh_node.assign(count, -1);
  std::vector<int> column(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    if (slaved[i]) continue;
    column[i] = static_cast<int>(part.nodes.size());
    part.nodes.push_back(shared[i] ? registry.add_shared(part.mesh.nodes[i], part.region)
                                   : registry.add(part.mesh.nodes[i]));
    part.node_of_mesh_node[i] = part.nodes.back();
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < count; ++i) {
    const int row = 2 * static_cast<int>(i);
    for (int component = 0; component < 2; ++component) {
      if (!slaved[i]) {
        entries.emplace_back(row + component, 2 * column[i] + component, 1.0);
      } else {
        for (int master : masters[i]) entries.emplace_back(row + component, 2 * column[master] + component, 0.5);
      }
    }
  }
  part.trace.resize(2 * static_cast<Eigen::Index>(count), 2 * static_cast<Eigen::Index>(part.nodes.size()));
  part.trace.setFromTriplets(entries.begin(), entries.end());
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
    stations.push_back((part.mesh.nodes[mesh_nodes[a]] - start).norm() / lattice.outline.spacing);
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

void add_bonds(const Scene& scene, LatticePart& part, Discretization& result) {
  const Region& region = scene.region(part.region);
  const Material& material = scene.material(region.material);
  part.network = pd::build_network(*part.lattice, region.horizon_ratio, material.elasticity);
  if (part.network.reduced) {
    result.warnings.push_back(text("region ", part.region,
                                   " has a shape for which no network of positive bonds with horizon ratio ",
                                   region.horizon_ratio, " was found; it has bonds between nearest neighbours only"));
  }
  const double spacing = part.outline.spacing;
  const double critical = material.critical_stretch_for(region.horizon_ratio * spacing);
  part.first_bond = result.bonds.size();
  for (const pd::Bond& bond : part.bonds()) {
    const Point offset = (part.lattice->point(bond.second) - part.lattice->point(bond.first)).cast<double>();
    const double length = offset.norm();
    result.bonds.first.push_back(part.nodes[bond.first]);
    result.bonds.second.push_back(part.nodes[bond.second]);
    result.bonds.cosine.push_back(offset.x() / length);
    result.bonds.sine.push_back(offset.y() / length);
    result.bonds.length.push_back(spacing * length);
    result.bonds.stiffness.push_back(bond.stiffness);
    result.critical_stretch.push_back(critical);
  }
}

}  // namespace

std::vector<int> LatticePart::points_along(const Point& start, const Point& end) const {
  const LatticePoint from = to_lattice(start).array().round().cast<int>().matrix();
  const LatticePoint span = LatticePoint(to_lattice(end).array().round().cast<int>().matrix()) - from;
  const int count = span.cwiseAbs().maxCoeff();
  std::vector<int> points{lattice->find_point(from)};
  for (int i = 1; i <= count; ++i) points.push_back(lattice->find_point(from + span / count * i));
  return points;
}

Point LatticePart::position(int point) const { return from_lattice(lattice->point(point).cast<double>()); }

Eigen::VectorXd BoundaryPart::mesh_displacement(const Eigen::VectorXd& scene_displacement) const {
  Eigen::VectorXd values(2 * nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    values.segment<2>(2 * static_cast<Eigen::Index>(i)) = scene_displacement.segment<2>(2 * nodes[i]);
  }
  return trace * values;
}

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
  for (const BoundaryPart& part : boundaries) {
    const Eigen::MatrixXd half = part.galerkin->stiffness() * part.trace;
    operators.push_back({part.nodes, part.trace.transpose() * half});
  }
  return operators;
}

Discretization discretize(const Scene& scene, const Options& options) {
  Discretization result;
  std::vector<Outline> outlines;
  for (const Region& region : scene.regions()) outlines.push_back(region.outline);
  const Box box = scene.bounding_box();
  result.tolerance = geometric_tolerance(box);
  result.arrangement = arrange(outlines);
  require_compatible(scene, result.arrangement);

  NodeRegistry registry(box.min(), 10 * result.tolerance);
  for (int id = 1; id <= static_cast<int>(scene.regions().size()); ++id) {
    const Region& region = scene.region(id);
    const bool is_lattice = region.kind == RegionKind::peridynamics;
    const Stopwatch watch(is_lattice ? result.seconds_lattice : result.seconds_boundary);
    if (is_lattice) {
      LatticePart part{id, region.lattice, std::make_unique<pd::CellLattice>(region.lattice.loops), {}, {}, 0};
      number_lattice_nodes(scene, result.arrangement, part, registry);
      add_bonds(scene, part, result);
      result.lattices.push_back(std::move(part));
    } else {
      BoundaryPanels panels = mesh_edges(scene, result.arrangement, result.tolerance, id);
      BoundaryPart part{id, std::move(panels.sources), mesh_boundary(panels.loops), {}, {}, {}, nullptr};
      number_boundary_nodes(part, registry);
      const bem::AssemblyOptions assembly{options.number("bem.quadrature_tolerance"), options.whole_number("threads")};
      part.galerkin =
          std::make_unique<bem::GalerkinOperator>(part.mesh, scene.material(region.material).elasticity, assembly);
      result.boundaries.push_back(std::move(part));
    }
  }
  for (const BoundaryPart& part : result.boundaries) {
    for (std::size_t p = 0; p < part.panels.size(); ++p) {
      if (!part.panels[p].tied) continue;
      tie_lattice_points(part, static_cast<int>(p), *result.lattice_of(part.panels[p].other_region), result.ties);
    }
  }
  result.positions = registry.positions();
  return result;
}

}  // namespace bempd::model
