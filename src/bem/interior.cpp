#include "bem/interior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bem/boundary_slopes.hpp"
#include "bem/kelvin_solution.hpp"
#include "bem/smoothness.hpp"
#include "error.hpp"

namespace bempd::bem {

namespace {

constexpr double tolerance = 1e-14;
// Distance from an element, over its length, below which a point counts as lying on the boundary: smaller distances
// are lost in the rounding of positions.
constexpr double on_boundary = 1e-10;
// Rounding error of the place of a point or node, over the largest of its coordinates and the body's size.
constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

// Parameter of the point of an arc nearest to x, from the angle at the arc's centre; beyond the ends, the nearer end.
double nearest_on_arc(const ElementGeometry& arc, const Point& x) {
  const double root = std::sin(0.5 * arc.basis.half_angle());
  const Point to_centre = arc.c2 / (2 * root * root), r = x - arc.c0 - to_centre;
  double xi = std::atan2(cross(-to_centre, r), -to_centre.dot(r)) / arc.basis.half_angle();
  if (std::abs(xi) > 1) return (arc.at(-1) - x).squaredNorm() < (arc.at(1) - x).squaredNorm() ? -1.0 : 1.0;
  // Two Newton steps follow, because the centre of a flat arc is known to few digits.
  for (int iteration = 0; iteration < 2; ++iteration) {
    const Point distance = arc.at(xi) - x, dx = arc.derivative(xi);
    xi = std::clamp(xi - distance.dot(dx) / dx.squaredNorm(), -1.0, 1.0);
  }
  return xi;
}

// Parameter of the point of an element nearest to x; on a parabola by Newton's method from the best of a few samples.
double nearest_parameter(const ElementGeometry& element, const Point& x) {
  if (element.straight()) return std::clamp(element.c1.dot(x - element.c0) / element.c1.squaredNorm(), -1.0, 1.0);
  if (!element.basis.powers()) return nearest_on_arc(element, x);
  constexpr int samples = 9;
  double best = -1, best_distance = (element.at(-1) - x).squaredNorm();
  for (int i = 1; i < samples; ++i) {
    const double xi = -1 + 2.0 * i / (samples - 1), distance = (element.at(xi) - x).squaredNorm();
    if (distance < best_distance) best = xi, best_distance = distance;
  }
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Point r = element.at(best) - x, dx = element.derivative(best);
    // The Gauss-Newton step, which leaves out the curvature, is taken where the curvature would make the Newton step
    // lead away from the minimum.
    const double full = dx.squaredNorm() + 2 * r.dot(element.c2);
    const double next = std::clamp(best - r.dot(dx) / (full > 0 ? full : dx.squaredNorm()), -1.0, 1.0);
    const bool done = std::abs(next - best) < 1e-15;
    best = next;
    if (done) break;
  }
  return best;
}

}  // namespace

struct InteriorEvaluator::Nearest {
  int element = 0;
  double xi = 0, distance = 1e300;
};

// Linear displacement field u(y) = origin_displacement + gradient (y - origin), in equilibrium, with its stress.
struct InteriorEvaluator::LinearField {
  Point origin, origin_displacement;
  Eigen::Matrix2d gradient, stress;
};

struct InteriorEvaluator::Sums {
  Point displacement = Point::Zero();
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
};

InteriorEvaluator::InteriorEvaluator(const BoundaryMesh& mesh, const PlaneElasticity& elasticity,
                                     const Eigen::VectorXd& displacements, const Eigen::VectorXd& tractions)
    : boundary_(mesh), nu_(elasticity.effective_poisson_ratio()), shear_modulus_(elasticity.shear_modulus()) {
  for (const BoundaryElement& e : mesh.elements) {
    const auto value = [](const Eigen::VectorXd& field, int node, double scale) -> Point {
      return field.segment<2>(2 * node) / scale;
    };
    const auto along_element = [&](const Eigen::VectorXd& field, const std::array<int, 3>& nodes, double scale) {
      return element_through(value(field, nodes[0], scale), value(field, nodes[1], scale),
                             value(field, nodes[2], scale), e.sweep);
    };
    displacement_.push_back(along_element(displacements, e.nodes, boundary_.length));
    end_nodes_.push_back({e.nodes[0], e.nodes[2]});
    traction_.push_back(along_element(tractions, e.traction_nodes, shear_modulus_));
  }
  const std::vector<ElementSlopes> slopes = boundary_slopes(mesh, displacements);
  for (std::size_t e = 0; e < slopes.size(); ++e) correction_.push_back(slope_correction(e, slopes[e]));
}

InteriorEvaluator::SlopeCorrection InteriorEvaluator::slope_correction(std::size_t e,
                                                                       const ElementSlopes& better) const {
  std::array<Point, 2> change{Point::Zero(), Point::Zero()};
  for (int end = 0; end < 2; ++end) {
    if (!better.known[end]) continue;
    const double xi = 2 * end - 1;
    change[end] = better.slope[end] * boundary_.elements[e].derivative(xi).norm() - displacement_[e].derivative(xi);
  }
  return {0.25 * (change[1] + change[0]), 0.25 * (change[1] - change[0])};
}

InteriorEvaluator::Nearest InteriorEvaluator::nearest(const Point& x) const {
  Nearest best;
  for (int e = 0; e < static_cast<int>(boundary_.elements.size()); ++e) {
    const ElementGeometry& element = boundary_.elements[e];
    const double reach = element.c1.norm() + element.c2.norm();  // largest distance of the element's points from c0
    if ((element.c0 - x).norm() - reach > best.distance) continue;
    const double xi = nearest_parameter(element, x), distance = (element.at(xi) - x).norm();
    if (distance < best.distance) best = {e, xi, distance};
  }
  return best;
}

// Linear field with the displacement, the tangential derivative and the traction of the nearest boundary point. Its
// gradient H follows from H tau = du/ds (tau: unit tangent, s: arc length) and from the traction, for plane strain with
// nu and the shear modulus 1.
InteriorEvaluator::LinearField InteriorEvaluator::matching_field(const Nearest& nearest,
                                                                 const Point& displacement_derivative) const {
  const ElementGeometry& element = boundary_.elements[nearest.element];
  const Point dx = element.derivative(nearest.xi);
  const double jacobian = dx.norm();
  const Point tangent = dx / jacobian, normal = scaled_normal(tangent);
  const Point slope = displacement_derivative / jacobian;
  const Point traction = traction_[nearest.element].at(nearest.xi);
  const double stress_nn = traction.dot(normal), stress_nt = traction.dot(tangent), strain_tt = slope.dot(tangent);
  const double strain_nn = (0.5 * (1 - 2 * nu_) * stress_nn - nu_ * strain_tt) / (1 - nu_);
  const double stress_tt = (2 * strain_tt + nu_ * stress_nn) / (1 - nu_);
  const Point normal_slope = strain_nn * normal + (stress_nt - normal.dot(slope)) * tangent;

  LinearField field;
  field.origin = element.at(nearest.xi);
  field.origin_displacement = displacement_[nearest.element].at(nearest.xi);
  field.gradient = slope * tangent.transpose() + normal_slope * normal.transpose();
  field.stress = stress_nn * normal * normal.transpose() + stress_tt * tangent * tangent.transpose() +
                 stress_nt * (normal * tangent.transpose() + tangent * normal.transpose());
  return field;
}

// Displacement of element `e` at the parameter xi less the linear field `field`, without cancellation near the nearest
// point, because the stress kernel divides this difference by the square of the distance.
Point InteriorEvaluator::remainder(int e, double xi, const Nearest& nearest, const LinearField& field) const {
  const ElementGeometry& element = boundary_.elements[e];
  const ElementGeometry& displacement = displacement_[e];
  // Value and slope of the linear field match the displacement on the nearest element, so only the second-order part of
  // the shape functions remains.
  const auto on_nearest = [&](double parameter) -> Point {
    const ElementBasis& basis = boundary_.elements[nearest.element].basis;
    return basis.second_order(parameter, nearest.xi) *
           (displacement_[nearest.element].c2 - field.gradient * boundary_.elements[nearest.element].c2);
  };
  if (e == nearest.element) return on_nearest(xi);
  // Neighbours of the nearest element: the difference is the sum of its value at the common end and of the change from
  // this end, so that no digits cancel.
  for (int own = 0; own < 2; ++own)
    for (int other = 0; other < 2; ++other)
      if (end_nodes_[e][own] == end_nodes_[nearest.element][other]) {
        const double end = 2 * own - 1;
        return on_nearest(2 * other - 1) +
               (xi - end) * (displacement.quotients(xi, end).place - field.gradient * element.quotients(xi, end).place);
      }
  return displacement.at(xi) - field.origin_displacement - field.gradient * (element.at(xi) - field.origin);
}

void InteriorEvaluator::integrate(int e, const Interval& interval, const Point& x, const Nearest& nearest,
                                  const LinearField& field, bool with_stress, int depth, Sums& sums) const {
  const ElementGeometry& element = boundary_.elements[e];
  const Point from = element.at(interval.from), mid = element.at(interval.mid()), to = element.at(interval.to);
  const double half = 0.5 * ((mid - from).norm() + (to - mid).norm());
  const double ellipse = element.straight() ? ellipse_size(((x - from).norm() + (x - to).norm()) / half)
                                            : singularities_from(element, x).ellipse(interval);
  // Stress kernels are singular by one order more than displacement kernels and need one point more.
  const int needed =
      std::max(gauss_points_needed(ellipse, tolerance) + 1, shape_points_needed(element, interval, tolerance));
  constexpr int max_depth = 60;
  if (needed > max_regular_points && depth < max_depth) {
    integrate(e, {interval.from, interval.mid()}, x, nearest, field, with_stress, depth + 1, sums);
    integrate(e, {interval.mid(), interval.to}, x, nearest, field, with_stress, depth + 1, sums);
    return;
  }

  const KelvinSolution kelvin{nu_};
  const GaussRule& rule = gauss_rule(std::min(needed, max_regular_points));
  const ElementGeometry& traction = traction_[e];
  const double length = interval.to - interval.from;
  kernel_evaluations_ += static_cast<std::int64_t>(rule.points.size());
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double xi = interval.at(rule.points[q]), weight = rule.weights[q] * length;
    const Point y = element.at(xi), dx = element.derivative(xi), normal = scaled_normal(dx), r = y - x;
    const Point t = traction.at(xi) * dx.norm() - field.stress * normal;
    const Point u = remainder(e, xi, nearest, field);
    sums.displacement += weight * (kelvin.displacement(r) * t - kelvin.traction(r, normal) * u);
    if (with_stress)
      sums.stress += weight * (kelvin.stress_from_traction(r, t) - kelvin.stress_from_displacement(r, normal, u));
  }
}

InteriorEvaluator::Value InteriorEvaluator::from_boundary(const Point& x, const Nearest& closest,
                                                          bool with_stress) const {
  const LinearField field = matching_field(closest, displacement_[closest.element].derivative(closest.xi));
  Sums sums;
  for (int e = 0; e < static_cast<int>(boundary_.elements.size()); ++e)
    integrate(e, {}, x, closest, field, with_stress, 0, sums);
  const Point displacement = field.origin_displacement + field.gradient * (x - field.origin) + sums.displacement;
  const Eigen::Vector3d stress = Eigen::Vector3d(field.stress(0, 0), field.stress(1, 1), field.stress(0, 1));
  return {displacement, stress + sums.stress};
}

InteriorEvaluator::Value InteriorEvaluator::evaluate(const Point& position, bool with_stress) const {
  const Point x = boundary_.scaled(position);
  const Nearest closest = nearest(x);
  // Elements beside singular places can be so short that rounding errors of places on them count.
  const double of_place = rounding * std::max(1.0, boundary_.centre.lpNorm<Eigen::Infinity>() / boundary_.length);
  if (closest.distance <= std::max(of_place, on_boundary * boundary_.elements[closest.element].c1.norm())) {
    const Point displacement = displacement_[closest.element].at(closest.xi);
    return {boundary_.length * displacement, stress_on(closest.element, closest.xi)};
  }
  Value value = from_boundary(x, closest, with_stress);
  if (cracks_) {
    require(!with_stress || cracks_->nearness_of_tip(x) > on_boundary, "the stress at (", position.x(), ", ",
            position.y(),
            ") is infinite: a crack ends there; ask for it beside the tip, or for the stress intensity "
            "factors of the tip");
    const CrackField::Value cracks = cracks_->anywhere(x);
    value.displacement += cracks.displacement;
    value.stress += cracks.stress;
  }
  return {boundary_.length * value.displacement, shear_modulus_ * value.stress};
}

Eigen::Vector3d InteriorEvaluator::stress_without(const Point& position, int crack_element) const {
  const Point x = boundary_.scaled(position);
  Eigen::Vector3d stress = from_boundary(x, nearest(x), true).stress;
  if (cracks_) stress += cracks_->at(x, crack_element).stress;
  return shear_modulus_ * stress;
}

Eigen::Vector3d InteriorEvaluator::stress_on(int element, double xi) const {
  const Point derivative = displacement_[element].derivative(xi) + correction_[element].at(xi);
  const Eigen::Matrix2d s = matching_field({element, xi, 0}, derivative).stress;
  return shear_modulus_ * Eigen::Vector3d(s(0, 0), s(1, 1), s(0, 1));
}

InteriorEvaluator::Value InteriorEvaluator::at(const Point& x) const { return evaluate(x, true); }

Point InteriorEvaluator::displacement_at(const Point& x) const { return evaluate(x, false).displacement; }

}  // namespace bempd::bem
