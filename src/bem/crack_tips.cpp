#include "bem/crack_tips.hpp"

#include <algorithm>
#include <cmath>

#include "bem/interior.hpp"
#include "bem/pair_blocks.hpp"
#include "elasticity/griffith.hpp"
#include "geometry/turning.hpp"
#include "number_range.hpp"

namespace bempd::bem {

namespace {

// Length by which a tip is moved for a difference quotient, over the length of its element; the quotient is exact to
// some 1e-7.
constexpr double step = 1e-3;

// Elements of a body, followed by two variants of each tip's element, with the tip moved forward and back. Their
// differences give derivatives of the Galerkin matrices by the position of a tip.
class MovedTips {
 public:
  explicit MovedTips(const CrackedOperator& body)
      : body_(body),
        elements_(with_moved(body)),
        blocks_(elements_, body.elasticity().effective_poisson_ratio(), body.options().quadrature_tolerance) {}

  // Derivatives of 1/2 u^T D u + t^T B u by the position of tip number `k`, one for each column. D is the hypersingular
  // matrix and B the double layer; `values` are the displacements and openings u, `tractions` the scaled tractions t.
  Eigen::VectorXd derivatives(int k, const Eigen::MatrixXd& values, const Eigen::MatrixXd& tractions) const {
    const int first = static_cast<int>(body_.elements().size()) + 2 * k;
    const double length = 2 * body_.elements()[element_of(k)].geometry.c1.norm();
    return (forms(k, first, values, tractions) - forms(k, first + 1, values, tractions)) / (2 * step * length);
  }

 private:
  int element_of(int k) const {
    return static_cast<int>(body_.mesh().elements.size()) + body_.cracks().tips[k].element;
  }

  static std::vector<GalerkinElement> with_moved(const CrackedOperator& body) {
    std::vector<GalerkinElement> elements = body.elements();
    const std::size_t first = body.mesh().elements.size();
    for (const CrackTip& tip : body.cracks().tips) {
      const GalerkinElement& own = body.elements()[first + tip.element];
      const Point start = own.geometry.at(-1), end = own.geometry.at(1);
      for (const double by : {step, -step}) {
        GalerkinElement moved = own;
        moved.geometry = tip.end == TipEnd::start ? tip_element(start + by * (start - end), end, tip.end)
                                                  : tip_element(start, end + by * (end - start), tip.end);
        elements.push_back(moved);
      }
    }
    return elements;
  }

  // Values of two components at the three nodes of an element.
  using Column = Eigen::Matrix<double, 6, 1>;
  using Block = Eigen::Matrix<double, 6, 6>;
  static Column on_element(const Eigen::Ref<const Eigen::VectorXd>& all, const std::array<int, 3>& nodes) {
    Column own;
    for (int k = 0; k < 3; ++k) own.segment<2>(2 * k) = all.segment<2>(2 * static_cast<Eigen::Index>(nodes[k]));
    return own;
  }

  // Part of 1/2 u^T D u + t^T B u (see derivatives()) that depends on the position of tip `k`, one value for each
  // column: the sum over all pairs with the tip's element, in place of which element number `variant` is used.
  Eigen::VectorXd forms(int k, int variant, const Eigen::MatrixXd& values, const Eigen::MatrixXd& tractions) const {
    const GalerkinElement& tip = elements_[variant];
    const int own = element_of(k), count = static_cast<int>(body_.elements().size());
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(values.cols());
    for (int e = 0; e < count; ++e) {
      const int outer = e == own ? variant : e;
      const GalerkinElement& x = elements_[outer];
      if (x.piece != tip.piece) continue;
      const PairMoments m = blocks_.moments(outer, variant, x.crack ? PairPart::derivative_only : PairPart::everything);
      Block of_values, of_tractions;
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          of_values.block<2, 2>(2 * b, 2 * a) = blocks_.hypersingular(outer, variant, m, a, b);
          if (!x.crack) of_tractions.block<2, 2>(2 * b, 2 * a) = blocks_.double_layer(m, a, b);
        }
      for (Eigen::Index s = 0; s < values.cols(); ++s) {
        Column force = of_values * on_element(values.col(s), x.nodes);
        if (!x.crack) force += of_tractions * on_element(tractions.col(s), x.traction_nodes);
        sums[s] += on_element(values.col(s), tip.nodes).dot(force);
      }
    }
    return sums;
  }

  const CrackedOperator& body_;
  std::vector<GalerkinElement> elements_;
  PairBlocks blocks_;
};

// Whether the faces next to a tip are closed.
bool is_closed(const CrackMesh& cracks, const CrackTip& tip, const CrackedState& state) {
  return !state.closed.empty() && state.closed[cracks.elements[tip.element].nodes[1]] != 0;
}

// Opening next to a tip, shearing component first. It is the coefficient of sqrt(distance from the tip / length of the
// element). The normal component is 0 where the faces are closed.
Point opening_at(const CrackMesh& cracks, const CrackTip& tip, const CrackedState& state) {
  const CrackElement& element = cracks.elements[tip.element];
  const Eigen::VectorXd& openings = state.openings;
  const bool at_start = tip.end == TipEnd::start;
  const Point mid = openings.segment<2>(2 * element.nodes[1]);
  const Point far = openings.segment<2>(2 * element.nodes[at_start ? 2 : 0]);
  const Point jump = (at_start ? -1.0 : 1.0) * (8 * mid - far) / 3;
  const double across = is_closed(cracks, tip, state) ? 0 : jump.dot(left_of(tip.direction));
  return {jump.dot(tip.direction), across};
}

// State of a cracked body divided by 2^exponent, so that its squares neither overflow nor vanish.
struct NearState {
  CrackedState state;
  int exponent;
};

NearState near(const CrackedState& far, double traction_unit) {
  const double size = std::max({far.displacements.lpNorm<Eigen::Infinity>(), far.openings.lpNorm<Eigen::Infinity>(),
                                traction_unit * far.tractions.lpNorm<Eigen::Infinity>()});
  NearState near{far, far_exponent(size)};
  if (near.exponent == 0) return near;
  const double unit = std::ldexp(1, -near.exponent);
  near.state.displacements *= unit, near.state.openings *= unit, near.state.tractions *= unit;
  if (far.face_traction)
    near.state.face_traction = [unit, traction = far.face_traction](int line, const Point& x, const Point& normal) {
      return Point(unit * traction(line, x, normal));
    };
  return near;
}

StressIntensity far(const StressIntensity& near, int exponent) {
  if (exponent == 0) return near;
  return {in_range(std::ldexp(near.energy_release_rate, 2 * exponent)),
          {in_range(std::ldexp(near.factors.x(), exponent)), in_range(std::ldexp(near.factors.y(), exponent))}};
}

StressIntensity shared_by_modes(const CrackedOperator& body, const CrackTip& tip, double rate,
                                const CrackedState& state) {
  Point opening = opening_at(body.cracks(), tip, state);
  if (state.faces_press) opening.y() = std::max(opening.y(), 0.0);
  const double size = opening.norm();
  if (size == 0) return {rate, Point::Zero()};
  return {rate, std::sqrt(plane_modulus(body.elasticity()) * rate) / size * Point(opening.y(), opening.x())};
}

}  // namespace

std::vector<std::vector<StressIntensity>> stress_intensities(const CrackedOperator& body,
                                                             const std::vector<CrackedState>& states) {
  const CrackMesh& cracks = body.cracks();
  const double shear = body.elasticity().shear_modulus(), length = body.boundary().length;
  const Eigen::Index count = static_cast<Eigen::Index>(states.size());
  std::vector<NearState> near_states;
  for (const CrackedState& state : states) near_states.push_back(near(state, length / shear));
  Eigen::MatrixXd values(body.matrices().hypersingular.rows(), count);
  Eigen::MatrixXd tractions(body.matrices().single_layer.rows(), count);
  for (Eigen::Index s = 0; s < count; ++s) {
    const CrackedState& state = near_states[s].state;
    values.col(s) << state.displacements, state.openings;
    tractions.col(s) = length / shear * state.tractions;
  }
  const MovedTips moved(body);
  std::vector<std::vector<StressIntensity>> results;
  for (int k = 0; k < static_cast<int>(cracks.tips.size()); ++k) {
    const CrackTip& tip = cracks.tips[k];
    Eigen::VectorXd rates = -shear / length * moved.derivatives(k, values, tractions);
    results.emplace_back();
    for (Eigen::Index s = 0; s < count; ++s) {
      const CrackedState& state = near_states[s].state;
      if (state.face_traction) rates[s] += work_of_growth(cracks, tip, state.face_traction, state.openings);
      results.back().push_back(
          far(shared_by_modes(body, tip, std::max(rates[s], 0.0), state), near_states[s].exponent));
    }
  }
  return results;
}

InteriorEvaluator interior_of_body(const CrackedOperator& body, const CrackedState& state) {
  InteriorEvaluator interior(body.mesh(), body.elasticity(), state.displacements, state.tractions);
  interior.set_cracks(
      CrackField(body.boundary(), body.cracks(), body.elasticity().effective_poisson_ratio(), state.openings));
  return interior;
}

InteriorEvaluator interior_of_piece(const CrackedOperator& body, const CrackedState& state, int piece) {
  const CrackMesh& cracks = body.cracks();
  Eigen::VectorXd openings = state.openings;
  for (const CrackElement& e : cracks.elements)
    for (const int node : e.nodes)
      if (e.piece != piece) openings.segment<2>(2 * node).setZero();
  InteriorEvaluator interior(elements_of_piece(body.mesh(), cracks.pieces, piece), body.elasticity(),
                             state.displacements, state.tractions);
  interior.set_cracks(CrackField(body.boundary(), cracks, body.elasticity().effective_poisson_ratio(), openings));
  return interior;
}

std::vector<double> stresses_along_crack(const CrackedOperator& body, const CrackedState& state) {
  const CrackMesh& cracks = body.cracks();
  std::vector<InteriorEvaluator> interiors;
  for (int piece = 0; piece < cracks.pieces.count; ++piece) interiors.push_back(interior_of_piece(body, state, piece));
  std::vector<double> results;
  for (const CrackTip& tip : cracks.tips) {
    const InteriorEvaluator& interior = interiors[cracks.elements[tip.element].piece];
    const Eigen::Vector3d s = interior.stress_without(tip.place, tip.element);
    const Point d = tip.direction;
    const double c = d.x() * d.x() - d.y() * d.y();
    double stress = c * (s[0] - s[1]) + 4 * d.x() * d.y() * s[2];
    if (is_closed(cracks, tip, state)) {
      // Closed faces only slide, and their openings give no normal stress on the crack's line. The T-stress is then the
      // stress along the crack.
      results.push_back(d.x() * d.x() * s[0] + d.y() * d.y() * s[1] + 2 * d.x() * d.y() * s[2]);
      continue;
    }
    // The left face (seen along a direction) has an outward normal that points to the right.
    const Point normal = -left_of(tip.end == TipEnd::end ? d : Point(-d));
    if (state.face_traction) stress += normal.dot(state.face_traction(tip.line, tip.place, normal));
    results.push_back(stress);
  }
  return results;
}

}  // namespace bempd::bem
