// The fit of Williams' series to stresses ahead of a tip, in sums of the series' own terms and against another fit.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

#include "elasticity/crack_tip_field.hpp"
#include "fracture/line/williams_fit.hpp"

namespace fracture_williams_fit_test {
namespace {

using namespace bempd;
using fracture::AffineIntensity;
using fracture::WilliamsFit;

constexpr double horizon = 0.3;
const PlaneElasticity material{2, 0.3, PlaneState::stress, 1};

// Places around a tip, their distances in horizons.
std::vector<TipPolar> places() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> distance(0.5, 2.5), angle(-1.6, 1.6);
  std::vector<TipPolar> found;
  for (int k = 0; k < 40; ++k) found.push_back({distance(random), angle(random)});
  return found;
}

// Term of power n / 2 that has a stress of about 1 at the distance of a horizon.
CrackTipField term(int n, const std::complex<double>& factor) {
  return {material, 0.5 * n, std::pow(horizon, 1 - 0.5 * n) * factor};
}

Eigen::Vector3d stress_at(const CrackTipField& field, const TipPolar& place) {
  return field.stress({horizon * place.radius, place.angle});
}

const std::complex<double> factors[2][WilliamsFit::most_terms] = {
    {{0.7, -0.4}, {0.3, 0}, {-0.2, 0.1}, {0.15, 0.25}, {0.1, -0.3}},
    {{-0.2, 0.9}, {-0.6, 0}, {0.1, 0.4}, {-0.35, 0.05}, {0.2, 0.1}}};

WilliamsFit fit_of(int fitted, int present) {
  WilliamsFit fit(fitted);
  for (const TipPolar& place : places()) {
    WilliamsFit::Stress stress = WilliamsFit::Stress::Zero();
    for (int part = 0; part < 2; ++part)
      for (int n = 1; n <= present; ++n) stress.col(part) += stress_at(term(n, factors[part][n - 1]), place);
    fit.add(place.radius, place.angle, stress);
  }
  return fit;
}

TEST(WilliamsFit, finds_the_factors_of_any_sum_of_its_terms) {
  const double root = std::sqrt(2 * M_PI * horizon);
  for (int terms = 1; terms <= WilliamsFit::most_terms; ++terms) {
    const WilliamsFit fit = fit_of(terms, terms);
    const AffineIntensity found = fit.factors(horizon);
    for (int part = 0; part < 2; ++part) {
      EXPECT_NEAR(found.one[part], root * factors[part][0].real(), 1e-8) << terms;
      EXPECT_NEAR(found.two[part], -root * factors[part][0].imag(), 1e-8) << terms;
      if (terms > 1) {
        EXPECT_NEAR(fit.t_stress()[part], 4 * factors[part][1].real(), 1e-8) << terms;
      }
    }
    EXPECT_NEAR(fit.residual(0.7), 0, 1e-6) << terms;
  }
}

// Least squares by a QR decomposition of all equations, each weighted with the root of its distance.
TEST(WilliamsFit, is_that_of_least_squares_where_terms_are_left_out) {
  const std::vector<TipPolar> around = places();
  constexpr double load_factor = -1.3;
  const WilliamsFit fit = fit_of(3, 5);
  for (const int terms : {1, 2, 3}) {
    Eigen::MatrixXd equations(3 * around.size(), 2 * terms - (terms > 1 ? 1 : 0));
    Eigen::VectorXd stress = Eigen::VectorXd::Zero(equations.rows());
    for (std::size_t k = 0; k < around.size(); ++k) {
      const double weight = std::sqrt(around[k].radius);
      const auto row = 3 * static_cast<Eigen::Index>(k);
      int column = 0;
      for (int n = 1; n <= terms; ++n)
        for (const std::complex<double> unit : {std::complex<double>(1, 0), std::complex<double>(0, -1)})
          if (n != 2 || unit.imag() == 0)
            equations.block<3, 1>(row, column++) = weight * stress_at(term(n, unit), around[k]);
      for (int n = 1; n <= 5; ++n)
        stress.segment<3>(row) +=
            weight * stress_at(term(n, factors[0][n - 1] + load_factor * factors[1][n - 1]), around[k]);
    }
    const Eigen::VectorXd known = equations.colPivHouseholderQr().solve(stress);
    const AffineIntensity found = fit.factors(horizon, terms);
    const Eigen::Vector2d at(1, load_factor);
    const double root = std::sqrt(2 * M_PI * horizon);
    EXPECT_NEAR(found.one.dot(at), root * known[0], 1e-9) << terms;
    EXPECT_NEAR(found.two.dot(at), root * known[1], 1e-9) << terms;
    if (terms == 3) {
      EXPECT_NEAR(fit.residual(load_factor), (stress - equations * known).norm() / stress.norm(), 1e-9);
    }
  }
}

TEST(WilliamsFit, reaches_as_far_as_its_farthest_point) {
  WilliamsFit fit(2);
  fit.add(1.5, 0.2, WilliamsFit::Stress::Zero());
  fit.add(0.5, 0, WilliamsFit::Stress::Zero());
  EXPECT_EQ(fit.reach(), 1.5);
  EXPECT_EQ(fit.residual(1), 0);
}

}  // namespace
}  // namespace fracture_williams_fit_test
