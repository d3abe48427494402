// Exponents of stress at corners against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "elasticity/wedge_exponent.hpp"

namespace {

using namespace bempd;

using std::numbers::pi;
constexpr int free_face = 0, clamped = 3;

PlaneElasticity strained(double young, double nu) { return {young, nu, PlaneState::strain, 1}; }
double kappa(const PlaneElasticity& e) { return 3 - 4 * e.effective_poisson_ratio(); }

Wedge single(double opening, int first, int second, const PlaneElasticity& e = strained(3e5, 0.3)) {
  return {0.7, {{opening, e}}, {first, second}, false};
}

// Root of a real function of which the ends of the interval have different signs.
double bisect(const std::function<double(double)>& f, double from, double to) {
  const bool rising = f(to) > f(from);
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (from + to);
    ((f(middle) > 0) == rising ? to : from) = middle;
  }
  return from;
}

void expect_exponent(const char* what, const Wedge& wedge, double real, double imaginary) {
  const auto found = singular_exponent(wedge);
  ASSERT_TRUE(found.has_value()) << what;
  std::printf("%s: %.10f + %.10f i, reference %.10f + %.10f i, difference %.1e\n", what, found->real(), found->imag(),
              real, imaginary, std::abs(*found - std::complex<double>(real, imaginary)));
  EXPECT_NEAR(found->real(), real, 1e-8) << what;
  EXPECT_NEAR(found->imag(), imaginary, 1e-7) << what;
}

// sin(lambda a) = +- lambda sin a between free faces (Williams 1952, equation 16).
TEST(WedgeExponent, of_free_corners_is_that_of_williams) {
  for (const double degrees : {200.0, 225.0, 270.0, 300.0, 330.0, 359.0}) {
    const double a = degrees * pi / 180;
    const double reference =
        bisect([&](double l) { return std::sin(l * a) + l * std::sin(a); }, 0.45, degrees < 220 ? 0.98 : 0.9);
    expect_exponent("free corner", single(a, free_face, free_face), reference, 0);
  }
  expect_exponent("L", single(1.5 * pi, free_face, free_face), 0.5444837368, 0);
  expect_exponent("crack", single(2 * pi, free_face, free_face), 0.5, 0);
}

// kappa sin(lambda a) = +- lambda sin a between clamped faces.
TEST(WedgeExponent, of_clamped_corners_is_that_of_williams) {
  for (const PlaneElasticity& e :
       {strained(2, 0.1), strained(2, 0.45), PlaneElasticity{2, 0.3, PlaneState::stress, 3}}) {
    const double a = 1.5 * pi, k = kappa(e);
    const double reference = bisect([&](double l) { return k * std::sin(l * a) + l * std::sin(a); }, 0.3, 0.95);
    const double other = bisect([&](double l) { return k * std::sin(l * a) - l * std::sin(a); }, 0.3, 0.95);
    expect_exponent("clamped corner", single(a, clamped, clamped, e), std::min(reference, other), 0);
  }
  expect_exponent("clamped slit", single(2 * pi, clamped, clamped), 0.5, 0);
}

// sin^2(lambda a) = ((kappa + 1)^2 - 4 lambda^2 sin^2 a) / (4 kappa) between a clamped and a free face.
TEST(WedgeExponent, between_clamped_and_free_is_that_of_williams) {
  for (const PlaneElasticity& e : {strained(2, 0.3), PlaneElasticity{2, 0.3, PlaneState::stress, 1}}) {
    const double k = kappa(e);
    for (const double degrees : {90.0, 110.0}) {
      const double a = degrees * pi / 180;
      const double reference = bisect(
          [&](double l) {
            return std::pow(std::sin(l * a), 2) - ((k + 1) * (k + 1) - std::pow(2 * l * std::sin(a), 2)) / (4 * k);
          },
          0.3, 0.99);
      expect_exponent("clamped and free", single(a, clamped, free_face, e), reference, 0);
    }
    // The wedge is a straight edge whose clamping ends.
    expect_exponent("end of a support", single(pi, free_face, clamped, e), 0.5, std::log(k) / (2 * pi));
    expect_exponent("clamped and free slit", single(2 * pi, clamped, free_face, e), 0.25, std::log(k) / (4 * pi));
  }
}

// What holds one component is a plane of symmetry, in which the wedge is reflected.
TEST(WedgeExponent, of_sliding_faces_is_that_of_the_reflected_wedge) {
  const PlaneElasticity e = strained(2, 0.2);
  const auto sliding = [&](double opening) { return Wedge{0, {{opening, e}}, {2, free_face}, false}; };
  EXPECT_FALSE(singular_exponent(sliding(0.5 * pi)).has_value());
  expect_exponent("sliding, 135 degrees", sliding(0.75 * pi), 0.5444837368, 0);
  expect_exponent("sliding, 180 degrees", sliding(pi), 0.5, 0);
}

TEST(WedgeExponent, of_regular_places_is_none) {
  EXPECT_FALSE(singular_exponent(single(pi, free_face, free_face)).has_value());
  EXPECT_FALSE(singular_exponent(single(0.5 * pi, free_face, free_face)).has_value());
  EXPECT_FALSE(singular_exponent(single(pi, clamped, clamped)).has_value());
  EXPECT_FALSE(singular_exponent(single(pi / 4, clamped, free_face)).has_value());
  const PlaneElasticity e = strained(2, 0.2);
  // A place inside, and a straight free edge, of two pieces of one material.
  EXPECT_FALSE(singular_exponent({0.3, {{1, e}, {2 * pi - 1, e}}, {0, 0}, true}).has_value());
  EXPECT_FALSE(singular_exponent({0.3, {{1, e}, {pi - 1, e}}, {0, 0, 0}, false}).has_value());
}

// Stresses oscillate at the tip of a crack between two materials (M. L. Williams, Bull. Seismol. Soc. Am. 49, 1959).
TEST(WedgeExponent, of_cracks_between_materials_is_that_of_williams) {
  const PlaneElasticity a = strained(10, 0.2), b = strained(1, 0.4);
  const double ma = a.shear_modulus(), mb = b.shear_modulus();
  const double reference = std::log((kappa(a) / ma + 1 / mb) / (kappa(b) / mb + 1 / ma)) / (2 * pi);
  expect_exponent("interface crack", {0.4, {{pi, a}, {pi, b}}, {0, 0, 0}, false}, 0.5, std::abs(reference));
  // Thickness counts as stiffness does.
  PlaneElasticity thick = a;
  thick.young_modulus /= 4;
  thick.thickness = 4;
  const auto found = singular_exponent({0.4, {{pi, thick}, {pi, b}}, {0, 0, 0}, false});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->imag(), std::abs(reference), 1e-7);
}

TEST(WedgeExponent, of_one_material_does_not_depend_on_how_it_is_divided_or_turned) {
  const PlaneElasticity e = strained(2, 0.3);
  for (const double angle : {0.0, 1.3, -2.0, 5.0})
    expect_exponent("L of three", {angle, {{0.7, e}, {2, e}, {1.5 * pi - 2.7, e}}, {0, 0, 0, 0}, false}, 0.5444837368,
                    0);
}

// A crack perpendicular to the interface with a stiffer or softer half-plane (A. R. Zak and M. L. Williams, J. Appl.
// Mech. 30, 1963).
TEST(WedgeExponent, of_cracks_up_to_an_interface_is_that_of_zak_and_williams) {
  const auto touching = [](double young) {
    const PlaneElasticity cracked = strained(1, 0.3), ahead = strained(young, 0.3);
    return Wedge{pi, {{0.5 * pi, cracked}, {pi, ahead}, {0.5 * pi, cracked}}, {0, 0, 0, 0}, false};
  };
  expect_exponent("crack up to its like", touching(1), 0.5, 0);
  // The equation of the two materials in Dundurs' parameters for the order s of stress (J. L. Beuth, Int. J. Solids
  // Struct. 29, 1992).
  for (const double ratio : {0.1, 10.0}) {
    const PlaneElasticity one = strained(1, 0.3), two = strained(ratio, 0.3);
    const double g1 = one.shear_modulus(), g2 = two.shear_modulus(), k1 = kappa(one), k2 = kappa(two);
    const double alpha = (g1 * (k2 + 1) - g2 * (k1 + 1)) / (g1 * (k2 + 1) + g2 * (k1 + 1));
    const double beta = (g1 * (k2 - 1) - g2 * (k1 - 1)) / (g1 * (k2 + 1) + g2 * (k1 + 1));
    const auto equation = [&](double l) {
      const double s = 1 - l;
      return std::cos(s * pi) - 2 * (alpha - beta) / (1 - beta) * (1 - s) * (1 - s) +
             (alpha - beta * beta) / (1 - beta * beta);
    };
    expect_exponent(ratio < 1 ? "crack up to a softer body" : "crack up to a stiffer body", touching(ratio),
                    bisect(equation, 0.05, 0.95), 0);
  }
}

}  // namespace
