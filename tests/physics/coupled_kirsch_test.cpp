// The field beside a circular hole in an infinite plate under tension (G. Kirsch 1898), in the complex form of
// N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, par. 56a: a field whose strain
// varies everywhere. Errors of an independent prototype, lattice alone, m = 4: 7.0e-3, 1.7e-3, 3.8e-4 for 10, 20, 40
// cells.
#include <gtest/gtest.h>

#include <complex>

#include "coupled_scene.hpp"

namespace coupled_kirsch_test {
namespace {

using namespace host;
using Complex = std::complex<double>;
constexpr double young = 100e9, poisson = 1.0 / 3, pull = 1e8, radius = 1;

Vector exact(double x, double y) {
  const Complex z(x, y), a2 = radius * radius, z2 = z * z;
  const Complex phi = pull / 4 * (z + 2.0 * a2 / z), phi1 = pull / 4 * (1.0 - 2.0 * a2 / z2);
  const Complex psi = -pull / 2 * (z + a2 / z - a2 * a2 / (z2 * z));
  const Complex u =
      ((3 - poisson) / (1 + poisson) * phi - z * std::conj(phi1) - std::conj(psi)) * ((1 + poisson) / young);
  return {u.real(), u.imag()};
}

Vector exact_traction(double x, double y, Vector n) {
  const Complex z(x, y), a2 = radius * radius, z2 = z * z;
  const Complex phi1 = pull / 4 * (1.0 - 2.0 * a2 / z2), phi2 = pull * a2 / (z2 * z);
  const Complex psi1 = -pull / 2 * (1.0 - a2 / z2 + 3.0 * a2 * a2 / (z2 * z2));
  const double sum = 4 * phi1.real();
  const Complex difference = 2.0 * (std::conj(z) * phi2 + psi1);  // yy - xx + 2 i xy
  const double sxx = (sum - difference.real()) / 2, syy = (sum + difference.real()) / 2, sxy = difference.imag() / 2;
  return {sxx * n[0] + sxy * n[1], sxy * n[0] + syy * n[1]};
}

// Everything on one rectangle's outer edges; the rigid motion is held at two corners, where no force acts.
void load(Model& model, const std::vector<int32_t>& regions, const std::vector<Piece>& pieces) {
  for (const EdgePart& part : free_parts(pieces))
    model.traction(regions[part.piece], part.edge,
                   [n = part.normal()](double x, double y) { return exact_traction(x, y, n); });
  const Vector a = pieces[0].outline[0], b = pieces[0].outline[1];
  model.prescribe_point(a, BEMPD_X, exact(a[0], a[1])[0]);
  model.prescribe_point(a, BEMPD_Y, exact(a[0], a[1])[1]);
  model.prescribe_point(b, BEMPD_Y, exact(b[0], b[1])[1]);
  model.step(1);
}

// Relative L2 error of the displacement at a region's nodes, the mean rigid motion taken out of error and field.
double relative_error(Model& model, int32_t region) {
  const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
  std::vector<Vector> field, error;
  for (std::size_t i = 0; i < x.size(); ++i) {
    field.push_back(exact(x[i][0], x[i][1]));
    error.push_back({u[i][0] - field[i][0], u[i][1] - field[i][1]});
  }
  const auto norm_without_rigid_motion = [&](const std::vector<Vector>& v) {
    const double n = static_cast<double>(v.size());
    Vector centre{}, mean{};
    for (std::size_t i = 0; i < v.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k) centre[k] += x[i][k] / n, mean[k] += v[i][k] / n;
    double moment = 0, inertia = 0, sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const double rx = x[i][0] - centre[0], ry = x[i][1] - centre[1];
      moment += rx * v[i][1] - ry * v[i][0], inertia += rx * rx + ry * ry;
    }
    for (std::size_t i = 0; i < v.size(); ++i) {
      const double rx = x[i][0] - centre[0], ry = x[i][1] - centre[1], spin = moment / inertia;
      sum += std::pow(v[i][0] - mean[0] + spin * ry, 2) + std::pow(v[i][1] - mean[1] - spin * rx, 2);
    }
    return std::sqrt(sum);
  };
  return norm_without_rigid_motion(error) / norm_without_rigid_motion(field);
}

TEST(Kirsch, the_lattice_alone_converges_at_second_order) {
  const std::vector<Piece> pieces{{Method::peridynamics, rectangle(0.8, 0.8, 1.8, 1.8)}};
  const double prototype[3] = {7.0e-3, 1.7e-3, 3.8e-4};
  double previous = 0;
  for (int k = 0; k < 3; ++k) {
    Model model;
    const double spacing = 0.1 / (1 << k);
    const auto regions = add_pieces(model, pieces, model.add(material(young, poisson)), spacing, 4, 1);
    load(model, regions, pieces);
    const double error = relative_error(model, regions[0]);
    report("relative L2 error", error, prototype[k], "independent prototype, another square");
    if (previous > 0) {
      EXPECT_GE(report("order", std::log2(previous / error), 2, "theory of the network"), 1.9 - 2);
    }
    previous = error;
  }
  EXPECT_LE(previous, 1e-3);
}

TEST(Kirsch, errors_of_a_lattice_inside_a_boundary_element_plate_fall) {
  const std::vector<Piece> pieces{
      {Method::boundary_elements, rectangle(0.8, 0.8, 3.8, 3.8), {rectangular_hole(1.8, 1.8, 2.8, 2.8)}},
      {Method::peridynamics, rectangle(1.8, 1.8, 2.8, 2.8)}};
  double previous = 1;
  for (double spacing : {0.1, 0.05, 0.025}) {
    Model model;
    const auto regions = add_pieces(model, pieces, model.add(material(young, poisson)), spacing, 4, 0.25);
    load(model, regions, pieces);
    const double lattice = relative_error(model, regions[1]), plate = relative_error(model, regions[0]);
    report("relative L2 error, lattice", lattice, 0, "closed form");
    report("relative L2 error, plate", plate, 0, "closed form");
    EXPECT_LT(lattice, previous);
    previous = lattice;
  }
  EXPECT_LE(previous, 2e-4);
}

}  // namespace
}  // namespace coupled_kirsch_test
