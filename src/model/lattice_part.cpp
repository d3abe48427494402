#include "model/lattice_part.hpp"

#include <algorithm>
#include <cmath>

#include "paper/uncorrected_network.hpp"

namespace bempd::model {

namespace {

constexpr double same_place = 1e-6;  // in spacings

std::vector<Point> grid_points(const pd::CellLattice& lattice) {
  std::vector<Point> points;
  for (int i = 0; i < lattice.point_count(); ++i) points.push_back(lattice.point(i).cast<double>());
  return points;
}

std::vector<std::array<Point, 2>> faces_in_grid(const LatticePart& part) {
  std::vector<std::array<Point, 2>> faces;
  const Point shift = (part.outline.origin - part.origin) / part.spacing();
  for (const auto& loop : part.outline.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      faces.push_back({loop[k].cast<double>() + shift, loop[(k + 1) % loop.size()].cast<double>() + shift});
    }
  }
  return faces;
}

}  // namespace

std::vector<int> LatticePart::points_along(const Point& start, const Point& end) const {
  const LatticePoint from = to_grid(start).array().round().cast<int>().matrix();
  const LatticePoint span = LatticePoint(to_grid(end).array().round().cast<int>().matrix()) - from;
  const int count = span.cwiseAbs().maxCoeff();
  std::vector<int> found{lattice->find_point(from)};
  for (int i = 1; i <= count; ++i) found.push_back(lattice->find_point(from + span / count * i));
  return found;
}

std::vector<LatticePart::EdgePoint> LatticePart::edge_points(int edge) const {
  const auto& [start, end] = outline.edges[edge - 1];
  const LatticePoint span = end - start;
  const int count = span.cwiseAbs().maxCoeff();
  const LatticePoint step = span / count;
  std::vector<EdgePoint> found;
  if (!cell_centred) {
    for (int i = 0; i <= count; ++i) {
      found.push_back({lattice->find_point(start + step * i), static_cast<double>(i) / count});
    }
    return found;
  }
  // The cell to the left of every piece of the edge, named by its lower left corner.
  const LatticePoint left(-step.y(), step.x());
  const LatticePoint to_corner(std::min({0, step.x() + left.x(), step.x(), left.x()}),
                               std::min({0, step.y() + left.y(), step.y(), left.y()}));
  for (int i = 0; i < count; ++i) {
    found.push_back({lattice->find_point(start + step * i + to_corner), (i + 0.5) / count});
  }
  return found;
}

LatticePart make_lattice_part(int id, const Region& region, const Formulation& formulation,
                              const std::vector<Point>& on_interfaces) {
  LatticePart part;
  part.region = id;
  part.outline = region.lattice;
  part.origin = region.lattice.origin;
  part.lattice = std::make_unique<pd::CellLattice>(region.lattice.loops);
  if (formulation.paper && formulation.cell_centred) {
    part.cell_centred = true;
    part.origin += Point::Constant(0.5 * part.spacing());
    part.lattice = std::make_unique<pd::CellLattice>(pd::CellLattice::centres_of(*part.lattice));
  }
  part.points = grid_points(*part.lattice);
  const std::size_t first = part.points.size();
  for (const Point& place : on_interfaces) {
    if (!part.cell_centred) break;
    const Point p = part.to_grid(place);
    // Two pieces of interface share the point where they meet.
    const auto is_there = [&](const Point& q) { return (p - q).norm() < same_place; };
    if (std::any_of(part.points.begin() + static_cast<std::ptrdiff_t>(first), part.points.end(), is_there)) continue;
    part.points.push_back(p);
  }
  // Points on interfaces and faces count as full ones: with less, the published stretching example has larger errors.
  if (formulation.paper) part.volumes.assign(part.points.size(), 1.0);
  return part;
}

void number_nodes(LatticePart& part, const std::vector<char>& is_shared, NodeRegistry& registry) {
  part.nodes.resize(part.points.size());
  for (int i = 0; i < part.point_count(); ++i) {
    part.nodes[i] = is_shared[i] ? registry.add_shared(part.position(i), part.region) : registry.add(part.position(i));
  }
}

std::shared_ptr<const pd::Network> network_of(const LatticePart& part, std::span<const LatticePart> built,
                                              const Scene& scene, const Formulation& formulation, int threads) {
  const Region& region = scene.region(part.region);
  const PlaneElasticity& elasticity = scene.material(region.material).elasticity;
  for (const LatticePart& other : built) {
    const Region& its_region = scene.region(other.region);
    if (part.outline.loops == other.outline.loops && part.points == other.points &&
        region.horizon_ratio == its_region.horizon_ratio &&
        elasticity == scene.material(its_region.material).elasticity) {
      return other.network;
    }
  }
  return std::make_shared<const pd::Network>(
      formulation.paper ? paper::build_uncorrected_network(part.points, part.volumes, faces_in_grid(part),
                                                           region.horizon_ratio, elasticity)
                        : pd::build_network(*part.lattice, region.horizon_ratio, elasticity, threads));
}

void add_bonds(LatticePart& part, const Region& region, const Material& material, const Formulation& formulation,
               coupling::BondSet& bonds, std::vector<double>& critical_stretch) {
  const double critical =
      material.critical_stretch_for(region.horizon_ratio * part.spacing(), formulation.printed_critical_stretch);
  part.first_bond = bonds.size();
  for (const pd::Bond& bond : part.bonds()) {
    const Point offset = part.points[bond.second] - part.points[bond.first];
    const double length = offset.norm();
    bonds.first.push_back(part.nodes[bond.first]);
    bonds.second.push_back(part.nodes[bond.second]);
    bonds.cosine.push_back(offset.x() / length);
    bonds.sine.push_back(offset.y() / length);
    bonds.length.push_back(part.spacing() * length);
    bonds.stiffness.push_back(bond.stiffness);
    critical_stretch.push_back(critical);
  }
}

}  // namespace bempd::model
