#include "model/discretization.hpp"

#include <cmath>
#include <limits>

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

// Material points of a lattice on its interfaces.
std::vector<char> interface_points(const Scene& scene, const Arrangement& arrangement, const LatticePart& part) {
  std::vector<char> on_interface(part.lattice->point_count(), 0);
  for (const Contact& contact : arrangement.contacts) {
    if (contact.region != part.region - 1) continue;
    const Segment edge = scene.region(part.region).edge(contact.edge + 1);
    const Point start = part.to_lattice(edge.at(contact.from)), end = part.to_lattice(edge.at(contact.to));
    const int count = static_cast<int>(std::lround((end - start).norm()));
    for (int i = 0; i <= count; ++i) {
      const Point p = start + (end - start) * (count > 0 ? static_cast<double>(i) / count : 0.0);
      const int point =
          part.lattice->find_point({static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))});
      if (point >= 0) on_interface[point] = 1;
    }
  }
  return on_interface;
}

void number_lattice_nodes(const Scene& scene, const Arrangement& arrangement, LatticePart& part,
                          NodeRegistry& registry) {
  const std::vector<char> shared = interface_points(scene, arrangement, part);
  part.nodes.resize(part.lattice->point_count());
  for (int i = 0; i < part.lattice->point_count(); ++i) {
    part.nodes[i] = shared[i] ? registry.add_shared(part.position(i), part.region) : registry.add(part.position(i));
  }
}

void number_boundary_nodes(BoundaryPart& part, NodeRegistry& registry) {
  const auto count = part.mesh.nodes.size();
  std::vector<char> shared(count, 0), slaved(count, 0);
  std::vector<std::array<int, 2>> masters(count);
  for (const BoundaryElement& element : part.mesh.elements) {
    const Border border = part.panels[element.panel].border;
    if (border == Border::free) continue;
    for (int node : element.nodes) shared[node] = 1;
    if (border == Border::peridynamics) {
      slaved[element.nodes[1]] = 1;
      masters[element.nodes[1]] = {element.nodes[0], element.nodes[2]};
    }
  }
  std::vector<int> column(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    if (slaved[i]) continue;
    column[i] = static_cast<int>(part.nodes.size());
    part.nodes.push_back(shared[i] ? registry.add_shared(part.mesh.nodes[i], part.region)
                                   : registry.add(part.mesh.nodes[i]));
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
      BoundaryPart part{id, std::move(panels.sources), mesh_boundary(panels.loops), {}, {}, nullptr};
      number_boundary_nodes(part, registry);
      const bem::AssemblyOptions assembly{options.number("bem.quadrature_tolerance"), options.whole_number("threads")};
      part.galerkin =
          std::make_unique<bem::GalerkinOperator>(part.mesh, scene.material(region.material).elasticity, assembly);
      result.boundaries.push_back(std::move(part));
    }
  }
  result.positions = registry.positions();
  return result;
}

}  // namespace bempd::model
