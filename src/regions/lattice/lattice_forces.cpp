#include <algorithm>

#include "geometry/segment.hpp"
#include "pd/face_loads.hpp"
#include "regions/lattice/lattice_region.hpp"

namespace bempd::regions {

std::vector<LatticeRegion::EdgePoint> LatticeRegion::edge_points(int edge) const {
  const auto& [start, end] = outline_.edges[edge - 1];
  const LatticePoint span = end - start;
  const int count = span.cwiseAbs().maxCoeff();
  const LatticePoint step = span / count;
  std::vector<EdgePoint> found;
  for (int i = 0; i <= count; ++i)
    found.push_back({grid_.find_point(start + step * i), static_cast<double>(i) / count});
  return found;
}

std::vector<PlacedNode> LatticeRegion::nodes_on(const EdgeSpan& span, double tolerance) const {
  const double slack = 10 * tolerance / span.geometry.length();
  std::vector<PlacedNode> found;
  for (const EdgePoint& p : edge_points(span.edge)) {
    if (p.fraction < span.from - slack || p.fraction > span.to + slack) continue;
    const double along = (p.fraction - span.from) / (span.to - span.from);
    found.push_back({nodes_[p.point], std::clamp(along, 0.0, 1.0)});
  }
  return found;
}

void LatticeRegion::add_edge_forces(const Point& a, const Point& b, const std::function<Point(const Point&)>& traction,
                                    Eigen::Ref<Eigen::VectorXd> forces) const {
  pd::add_face_forces(grid_, a, b, traction, forces);
}

void LatticeRegion::add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                                 Eigen::Ref<Eigen::VectorXd> force) const {
  const auto& ends = outline_.edges[span.edge - 1];
  const Segment piece{ends[0].cast<double>(), ends[1].cast<double>()};
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(2 * point_count());
  const auto in_cells = [&](const Point& p) { return traction(outline_.origin + spacing() * p); };
  add_edge_forces(piece.at(span.from), piece.at(span.to), in_cells, nodal.head(2 * grid_.point_count()));
  nodal *= elasticity().thickness * spacing();
  scatter(nodal, force);
}

// Area of the cells that belongs to each point, in cells: every cell gives a quarter to each of its corners, which is
// the integral of a bilinear shape function.
std::vector<double> LatticeRegion::cell_shares() const {
  std::vector<double> shares(points_.size(), 0.0);
  for (int i = 0; i < grid_.point_count(); ++i) shares[i] = 0.25 * grid_.cells_around(i);
  return shares;
}

}  // namespace bempd::regions
