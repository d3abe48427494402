#include <algorithm>

#include "error.hpp"
#include "geometry/segment.hpp"
#include "pd/crack.hpp"
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
    found.push_back({grid_->find_point(start + step * i), static_cast<double>(i) / count});
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
  pd::add_face_forces(*grid_, a, b, traction, forces);
}

void LatticeRegion::add_traction(const EdgeSpan& span, const std::function<Point(const Point&)>& traction,
                                 Eigen::Ref<Eigen::VectorXd> force) const {
  const auto& ends = outline_.edges[span.edge - 1];
  const Segment piece{ends[0].cast<double>(), ends[1].cast<double>()};
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(2 * point_count());
  const auto in_cells = [&](const Point& p) { return traction(outline_.origin + spacing() * p); };
  add_edge_forces(piece.at(span.from), piece.at(span.to), in_cells, nodal.head(2 * grid_->point_count()));
  nodal *= elasticity().thickness * spacing();
  scatter(nodal, force);
}

// The edge's part of the force that the stress at the node makes on all of it.
std::vector<Point> LatticeRegion::forces_on_edge(const EdgeSpan& span, const std::vector<int>& nodes_of_scene,
                                                 const FieldsOfRegion& fields) const {
  const std::vector<double>& stress = fields(Field::stress).values;
  const Point along = span.geometry.direction().normalized(), normal(along.y(), -along.x());
  std::vector<Point> forces;
  for (const int node : nodes_of_scene) {
    const auto place = static_cast<std::size_t>(std::find(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
    const double* s = &stress[3 * place];
    const Point traction(s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y());
    Eigen::VectorXd of_edge = Eigen::VectorXd::Zero(2 * (1 + *std::max_element(nodes_.begin(), nodes_.end())));
    add_traction(
        {span.edge, span.geometry, 0, 1}, [&](const Point&) { return traction; }, of_edge);
    forces.emplace_back(of_edge.segment<2>(2 * node));
  }
  return forces;
}

// A quarter of every cell goes to each of its corners: the integrals of the bilinear shape functions.
std::vector<double> LatticeRegion::cell_shares() const {
  std::vector<double> shares(points_.size(), 0.0);
  for (int i = 0; i < grid_->point_count(); ++i) shares[i] = 0.25 * grid_->cells_around(i);
  return shares;
}

void LatticeRegion::add_body_force(const Point& body_force, Eigen::Ref<Eigen::VectorXd> force) const {
  const Point of_cell = elasticity().thickness * spacing() * spacing() * body_force;
  const std::vector<double> shares = cell_shares();
  for (std::size_t i = 0; i < shares.size(); ++i) force.segment<2>(2 * nodes_[i]) += shares[i] * of_cell;
}

void LatticeRegion::cut(const scene::Crack& crack, int number, std::vector<int>& bonds,
                        std::vector<std::string>& warnings) const {
  std::vector<Point> polyline;
  for (const Point& p : crack.points) polyline.push_back(to_grid(p));
  const std::vector<int> touched = pd::points_on(points_, polyline);
  if (!touched.empty()) {
    const Point where = position(touched.front());
    const std::string finding =
        text("crack ", number, " passes through ", touched.size(), " material points of region ", id(),
             ", the first at (", where.x(), ", ", where.y(), ")");
    require(cracks_may_meet_points(), finding,
            "; a point on a crack belongs to neither side: shift the crack or the region by half a spacing (",
            0.5 * spacing(), ")");
    warnings.push_back(finding + "; they stay bonded to both of its faces and bridge it");
  }
  const pd::Touching touching = cracks_may_meet_points() ? pd::Touching::of_ends_keeps : pd::Touching::cuts;
  std::vector<Point> ends = points_;
  ends.insert(ends.end(), bonds_.far_points.begin(), bonds_.far_points.end());
  for (int bond : pd::bonds_cut_by(ends, network()->bonds, polyline, touching))
    bonds.push_back(static_cast<int>(scene_bond(bond)));
}

}  // namespace bempd::regions
