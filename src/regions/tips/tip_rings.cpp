#include "regions/tips/tip_rings.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace bempd::regions {

namespace {

// Weight q at the distance `radius` from the tip: 1 up to the inner radius of the ring, 0 from its outer radius on,
// with a continuous derivative.
double weight_at(double radius, double inner, double outer) {
  const double t = std::clamp((radius - inner) / (outer - inner), 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

double elongation(const std::vector<std::pair<int, Point>>& pulls, const std::vector<Point>& displacement) {
  if (pulls.size() == 2) return pulls[1].second.dot(displacement[pulls[1].first] - displacement[pulls[0].first]);
  double sum = 0;
  for (const auto& [node, pull] : pulls) sum += pull.dot(displacement[node]);
  return sum;
}

std::vector<Point> path_in_axes(const TipAxes& axes) {
  std::vector<Point> path;
  for (const Point& p : axes.path) path.push_back(axes.into(p - axes.place));
  return path;
}

}  // namespace

TipRings::TipRings(const BondedBody& body, TipAxes axes, double radius)
    : body_(body), axes_(std::move(axes)), radius_(radius), crack_(path_in_axes(axes_), radius) {
  const coupling::Terms& terms = body.bonds;
  const std::vector<char> usable = terms_of_material();
  const std::vector<Point>& positions = body.discretization.positions;
  std::vector<int> local(positions.size(), -1);
  const auto near = [&](int node) { return (positions[node] - axes_.place).norm() < radius_; };
  const auto number = [&](int node) {
    if (local[node] < 0) local[node] = static_cast<int>(nodes_.size()), nodes_.push_back(node);
    return local[node];
  };
  for (std::size_t b = 0; b < terms.size(); ++b) {
    if (!body.intact[b] || !usable[b]) continue;
    bool is_near = false;
    terms.for_each_node(b, [&](int node) { is_near = is_near || near(node); });
    if (!is_near) continue;
    LocalTerm& term = terms_.emplace_back(LocalTerm{body.stiffness[b], {}});
    terms.for_each_entry(b, [&](int node, double x, double y) { term.pulls.emplace_back(number(node), Point(x, y)); });
  }
  collect_faces();
  if (axes_.is_rough) return;
  std::vector<Point> places;
  for (const int node : nodes_) places.push_back(axes_.into(positions[node] - axes_.place));
  crack_.divide(places, axes_.spacing);
}

// Flag of each energy term (bond or cell square): whether all its nodes lie in lattices of the material at the tip.
// Lattices of other materials are treated like boundary elements: the sum over energy terms ends at their interface.
std::vector<char> TipRings::terms_of_material() const {
  const coupling::Terms& terms = body_.bonds;
  std::vector<char> inside(body_.discretization.positions.size(), 0), usable(terms.size(), 1);
  for (const auto& region : body_.discretization.regions) {
    if (is_of_material(*region))
      for (const int node : region->nodes()) inside[node] = 1;
    else if (const RegionBonds* bonds = region->bonds())
      std::fill_n(usable.begin() + static_cast<std::ptrdiff_t>(bonds->first_bond()), bonds->list().size(), 0);
  }
  for (std::size_t b = 0; b < terms.size(); ++b)
    terms.for_each_node(b, [&](int node) { usable[b] = usable[b] && inside[node]; });
  return usable;
}

// Collects the parts of the lattices' edges near the tip at which the material at the tip ends: free edges, and
// interfaces with boundary elements or with lattices of other materials.
void TipRings::collect_faces() {
  for (const auto& region : body_.discretization.regions) {
    if (!is_of_material(*region)) continue;
    const std::vector<Edge> edges = edges_of(body_.scene.region(region->id()).outline());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (distance(edges[e], axes_.place) > radius_) continue;
      double from = 0;
      const auto add_until = [&](double to) {
        if (to > from) faces_.push_back({region.get(), {static_cast<int>(e) + 1, edges[e], from, to}});
      };
      for (const Contact& contact : body_.discretization.arrangement.contacts) {
        if (contact.region != region->id() - 1 || contact.edge != static_cast<int>(e)) continue;
        if (!is_of_material(body_.discretization.region(contact.other_region + 1))) continue;
        add_until(contact.from);
        from = contact.to;
      }
      add_until(1);
    }
  }
}

TipPolar TipRings::polar(const Point& place, const Point& centre) const {
  TipPolar found = crack_.polar(axes_.into(place - axes_.place), axes_.into(centre - axes_.place));
  found.radius = std::max(found.radius, 1e-3 * axes_.spacing);
  return found;
}

Eigen::VectorXd TipRings::face_forces(const CrackTipField& dual, const Point& centre) const {
  Eigen::VectorXd own = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(nodes_.size()));
  crack_.add_forces(dual, axes_.into(centre - axes_.place), [&](int node, const Point& force) {
    own.segment<2>(2 * static_cast<Eigen::Index>(node)) += axes_.elasticity.thickness * axes_.out_of(force);
  });
  if (faces_.empty()) return own;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(body_.discretization.positions.size()));
  for (const FacePart& face : faces_) {
    const Edge& edge = face.span.geometry;
    const auto traction = [&](const Point& place) {
      const Point along =
          edge.straight() ? Point(edge.direction().normalized()) : edge.tangent(closest_fraction(edge, place));
      const Point normal = axes_.into(Point(along.y(), -along.x()));
      const Eigen::Vector3d s = dual.stress(polar(place, centre));
      return axes_.out_of({s[0] * normal.x() + s[2] * normal.y(), s[2] * normal.x() + s[1] * normal.y()});
    };
    face.region->loads().add_traction(face.span, traction, forces);
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) own.segment<2>(2 * i) += forces.segment<2>(2 * nodes_[i]);
  return own;
}

TipRings::View::Dual TipRings::dual_at(const Point& centre, double power, std::complex<double> factor) const {
  const CrackTipField field(axes_.elasticity, -power, factor);
  std::vector<Point> moved;
  for (const int node : nodes_)
    moved.push_back(axes_.out_of(field.displacement(polar(body_.discretization.positions[node], centre))));
  View::Dual dual{power, factor, {}, face_forces(field, centre)};
  for (const LocalTerm& term : terms_) dual.tensions.push_back(term.stiffness * elongation(term.pulls, moved));
  return dual;
}

TipRings::View TipRings::about(double ahead) const {
  View view{axes_.place + ahead * axes_.direction, {}, {}};
  for (const int node : nodes_) view.distances.push_back((body_.discretization.positions[node] - view.centre).norm());
  for (const double power : {0.5, -0.5})
    for (const std::complex<double> factor : {std::complex<double>(1, 0), std::complex<double>(0, 1)})
      view.duals.push_back(dual_at(view.centre, power, factor));
  view.duals.push_back(dual_at(view.centre, 1, 1));
  return view;
}

// Displacements around the tip without their rigid motion. In theory a rigid motion does no work on any dual field. But
// the crack leaves fewer bonds at its faces, so the dual fields are balanced only far from the tip.
//
// The motion is found by a fit together with the first terms of Williams' expansion. Without these terms the fit would
// take part of the displacements that vary as r^(1/2) with the distance r from the tip for a rigid motion.
Eigen::VectorXd TipRings::around(const Eigen::VectorXd& displacement) const {
  const auto count = static_cast<Eigen::Index>(nodes_.size());
  Eigen::VectorXd own(2 * count);
  for (Eigen::Index i = 0; i < count; ++i) own.segment<2>(2 * i) = displacement.segment<2>(2 * nodes_[i]);
  if (own.isZero(0)) return own;
  Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(2 * count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Point arm = (body_.discretization.positions[nodes_[i]] - axes_.place) / radius_;
    terms.block<2, 3>(2 * i, 0) << 1, 0, -arm.y(), 0, 1, arm.x();
  }
  const Eigen::MatrixXd rigid = terms;
  for (const double power : {-0.5, 0.5, 1.0, 1.5, 2.0, 2.5}) {
    for (const std::complex<double> factor : {std::complex<double>(1, 0), std::complex<double>(0, 1)}) {
      if (power == 1 && factor.imag() != 0) continue;  // a rotation
      const CrackTipField field(axes_.elasticity, power, factor * axes_.elasticity.shear_modulus());
      terms.conservativeResize(Eigen::NoChange, terms.cols() + 1);
      for (Eigen::Index i = 0; i < count; ++i) {
        TipPolar place = polar(body_.discretization.positions[nodes_[i]], axes_.place);
        place.radius = std::max(place.radius, axes_.spacing) / radius_;
        terms.block<2, 1>(2 * i, terms.cols() - 1) = axes_.out_of(field.displacement(place));
      }
    }
  }
  const Eigen::VectorXd fit = (terms.transpose() * terms).ldlt().solve(terms.transpose() * own);
  return own - rigid * fit.head<3>();
}

TipRings::Expansion TipRings::expansion(const View& view, double inner, double outer,
                                        const Eigen::VectorXd& around) const {
  std::vector<Point> weighted;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    weighted.push_back(weight_at(view.distances[i], inner, outer) * around.segment<2>(2 * i));
  std::vector<double> found;
  for (const View::Dual& dual : view.duals) {
    double work = 0;
    for (std::size_t t = 0; t < terms_.size(); ++t) work += dual.tensions[t] * elongation(terms_[t].pulls, weighted);
    for (std::size_t i = 0; i < nodes_.size(); ++i) work -= dual.face_forces.segment<2>(2 * i).dot(weighted[i]);
    found.push_back(work / axes_.elasticity.thickness /
                    reciprocal_work(axes_.elasticity, dual.power, dual.factor, dual.factor));
  }
  return {{found[0], found[1]}, {found[2], found[3]}, 4 * found[4]};
}

}  // namespace bempd::regions
