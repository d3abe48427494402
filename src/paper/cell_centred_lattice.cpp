#include "paper/cell_centred_lattice.hpp"

#include <algorithm>

#include "paper/layer_forces.hpp"

namespace bempd::paper {

using namespace regions;

namespace {

constexpr double same_place = 1e-6;  // in spacings

}  // namespace

CellCentredLattice::CellCentredLattice(int id, const PeridynamicDescription& described, const scene::Material& material)
    : UncorrectedLattice(id, described, material) {
  use_grid(pd::CellLattice::centres_of(grid()), origin() + Point::Constant(0.5 * spacing()));
}

void CellCentredLattice::place_points(const Preparation& preparation) {
  const auto first = static_cast<std::ptrdiff_t>(points_.size());
  for (const auto& other : preparation.regions) {
    const ElementBorders* borders = other->element_borders();
    if (!borders) continue;
    for (const Point& place : borders->places_facing(id())) {
      const Point p = to_grid(place);
      // A place where two pieces of interface meet gets one point, not one for each piece.
      const auto is_there = [&](const Point& q) { return (p - q).norm() < same_place; };
      if (std::none_of(points_.begin() + first, points_.end(), is_there)) points_.push_back(p);
    }
  }
}

std::vector<char> CellCentredLattice::shared_points(const Preparation&) const {
  std::vector<char> shared(points_.size(), 0);
  std::fill(shared.begin() + grid().point_count(), shared.end(), 1);
  return shared;
}

std::vector<LatticeRegion::EdgePoint> CellCentredLattice::edge_points(int edge) const {
  const auto& [start, end] = outline().edges[edge - 1];
  const LatticePoint span = end - start;
  const int count = span.cwiseAbs().maxCoeff();
  const LatticePoint step = span / count;
  // The cell behind a piece of the edge lies on the left of the edge. A cell has the number of its lower left corner.
  const LatticePoint left(-step.y(), step.x());
  const LatticePoint to_corner(std::min({0, step.x() + left.x(), step.x(), left.x()}),
                               std::min({0, step.y() + left.y(), step.y(), left.y()}));
  std::vector<EdgePoint> found;
  found.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) found.push_back({grid().find_point(start + step * i + to_corner), (i + 0.5) / count});
  return found;
}

void CellCentredLattice::add_edge_forces(const Point& a, const Point& b,
                                         const std::function<Point(const Point&)>& traction,
                                         Eigen::Ref<Eigen::VectorXd> forces) const {
  add_layer_forces(grid(), a, b, traction, forces);
}

// Share of a cell that each point stands for: 1 for points at centres of cells, 0 for points on interfaces.
std::vector<double> CellCentredLattice::cell_shares() const {
  std::vector<double> shares(points_.size(), 0.0);
  std::fill_n(shares.begin(), grid().point_count(), 1.0);
  return shares;
}

}  // namespace bempd::paper
