#include "elasticity/wedge_exponent.hpp"

#include <Eigen/LU>
#include <cmath>
#include <cstddef>

#include "linalg/analytic_roots.hpp"

namespace bempd {

namespace {

using Complex = std::complex<double>;
constexpr Complex i_unit{0, 1};

// Displacements and resultant forces (rows x, y) on a ray of a wedge, one column for each of the four constants of the
// solution in a sector.
struct RayFunctions {
  Eigen::Matrix<Complex, 2, 4> displacement, force;
};

// Displacement and force functions of the potentials phi = a z^lambda, psi = b z^lambda with complex constants a and b.
// Their conjugates have constants c and d of their own, so that all functions are analytic in lambda (M. L. Williams,
// J. Appl. Mech. 19, 1952; England, Complex Variable Methods in Elasticity, 1971, section 3.7). The displacement is 2
// mu (u + i v) = kappa phi - z conj(phi') - conj(psi), with the shear modulus mu and Kolosov's constant kappa. The
// resultant force on the arc from a fixed point is -i (phi + z conj(phi') + conj(psi)) times the thickness.
RayFunctions functions_on(double angle, const Complex& lambda, const PlaneElasticity& e, double modulus) {
  const Complex up = std::exp(i_unit * lambda * angle), down = 1.0 / up;
  const Complex turn = std::exp(2.0 * i_unit * angle), ahead = turn * down, behind = up / turn;
  const double kappa = 3 - 4 * e.effective_poisson_ratio();
  Eigen::RowVector<Complex, 4> u, u_bar, t, t_bar;  // in the order a, b, c, d
  u << kappa * up, 0, -lambda * ahead, -down;
  u_bar << -lambda * behind, -up, kappa * down, 0;
  t << up, 0, lambda * ahead, down;
  t_bar << lambda * behind, up, down, 0;
  const double softness = modulus / (4 * e.shear_modulus());
  RayFunctions result;
  result.displacement.row(0) = softness * (u + u_bar);
  result.displacement.row(1) = -softness * i_unit * (u - u_bar);
  result.force.row(0) = -0.5 * e.thickness * i_unit * (t - t_bar);
  result.force.row(1) = -0.5 * e.thickness * (t + t_bar);
  return result;
}

// Determinant of the conditions on all rays of a wedge as a function of the exponent lambda: it is 0 if some
// displacement ~ r^lambda satisfies all conditions.
class WedgeEquations {
 public:
  explicit WedgeEquations(const Wedge& wedge) : wedge_(wedge) {
    double angle = wedge.angle;
    for (const WedgeSector& sector : wedge.sectors) {
      from_.push_back(angle);
      angle += sector.opening;
    }
  }

  Complex operator()(const Complex& lambda) const {
    const auto count = static_cast<Eigen::Index>(wedge_.sectors.size());
    Eigen::MatrixXcd equations = Eigen::MatrixXcd::Zero(4 * count, 4 * count);
    Eigen::Index row = 0;
    for (std::size_t ray = 0; ray < wedge_.held.size(); ++ray) add_ray(ray, lambda, equations, row);
    return equations.partialPivLu().determinant();
  }

 private:
  void add_ray(std::size_t ray, const Complex& lambda, Eigen::MatrixXcd& equations, Eigen::Index& row) const {
    const std::size_t count = wedge_.sectors.size();
    struct Side {
      Eigen::Index column;
      double sign;
      RayFunctions functions;
    };
    std::vector<Side> sides;
    const auto add_side = [&](std::size_t sector, bool end, double sign) {
      const WedgeSector& s = wedge_.sectors[sector];
      const double angle = from_[sector] + (end ? s.opening : 0);
      const PlaneElasticity& reference = wedge_.sectors.front().elasticity;
      PlaneElasticity scaled = s.elasticity;
      scaled.thickness /= reference.thickness;
      sides.push_back({4 * static_cast<Eigen::Index>(sector), sign,
                       functions_on(angle, lambda, scaled, reference.shear_modulus())});
    };
    if (ray > 0 || wedge_.closed) add_side(ray > 0 ? ray - 1 : count - 1, true, 1);
    if (ray < count) add_side(ray, false, -1);
    for (int component = 0; component < 2; ++component) {
      if ((wedge_.held[ray] >> component) & 1) {
        for (const Side& side : sides)
          equations.block<1, 4>(row++, side.column) = side.functions.displacement.row(component);
        continue;
      }
      for (const Side& side : sides)
        equations.block<1, 4>(row, side.column) += side.sign * side.functions.force.row(component);
      ++row;
      if (sides.size() < 2) continue;
      for (const Side& side : sides)
        equations.block<1, 4>(row, side.column) += side.sign * side.functions.displacement.row(component);
      ++row;
    }
  }

  const Wedge& wedge_;
  std::vector<double> from_;
};

// Whether the stress is certainly bounded: the wedge is one sector with an angle up to 180 degrees, and its two faces
// are both free or both held.
bool is_surely_bounded(const Wedge& wedge) {
  if (wedge.sectors.size() != 1 || wedge.closed) return false;
  const int held = wedge.held[0];
  constexpr double straight = 3.1415926;
  return held == wedge.held[1] && (held == 0 || held == 3) && wedge.sectors[0].opening <= straight;
}

}  // namespace

std::optional<std::complex<double>> singular_exponent(const Wedge& wedge) {
  if (is_surely_bounded(wedge)) return std::nullopt;
  // Exponents near 0 and 1 are left out: translations are solutions with the exponent 0, rotations and constant
  // stresses with 1.
  constexpr double least = 0.01, most_imaginary = 1;
  return linalg::leftmost_root(WedgeEquations(wedge), {least, largest_singular_exponent}, most_imaginary);
}

}  // namespace bempd
