#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/boundary_elements.hpp"
#include "bem/lanes.hpp"
#include "bem/pair_integrals.hpp"
#include "bem/quadrature.hpp"
#include "bem_moments.hpp"

namespace {

using namespace bempd;
using namespace bempd::bem;

TEST(GaussRule, integrates_polynomials_up_to_twice_its_points) {
  for (int n = 1; n <= max_gauss_points; ++n) {
    const GaussRule& rule = gauss_rule(n);
    for (int power = 0; power < 2 * n; ++power) {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.points[i], power);
      EXPECT_NEAR(sum, 1.0 / (power + 1), 2e-15) << n << " points, power " << power;
    }
  }
}

TEST(GaussRule, logarithmic_weights_are_exact_for_polynomials_below_the_point_count) {
  for (int n = 1; n <= max_gauss_points; ++n) {
    const GaussRule& rule = gauss_rule(n);
    for (int power = 0; power < n; ++power) {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += rule.log_weights[i] * std::pow(rule.points[i], power);
      EXPECT_NEAR(sum, -1.0 / ((power + 1.0) * (power + 1.0)), 2e-15) << n << " points, power " << power;
    }
  }
}

TEST(RegularRules, agree_with_the_point_count_estimate) {
  for (const double tolerance : {1e-6, 1e-14}) {
    const RegularRules rules(tolerance);
    for (double sum = 2; sum < 1000; sum *= 1.003)
      EXPECT_EQ(rules.rule(sum), regular_rule(gauss_points_needed(ellipse_size(sum), tolerance))) << sum;
  }
}

TEST(Lanes, logarithm_and_inverse_are_right_to_the_last_places) {
  using Values = Lanes<2>::Values;
  for (double x = 1e-300; x < 1e300; x *= 1.37) {
    const auto [half_logarithm, inverse] = half_logarithm_and_inverse<2>(Values{x, 1 + 1e-3 * std::sin(x)});
    EXPECT_NEAR(half_logarithm[0], 0.5 * std::log(x), 4e-16 * std::abs(std::log(x))) << x;
    EXPECT_NEAR(inverse[0] * x, 1, 6e-16) << x;
    EXPECT_NEAR(half_logarithm[1], 0.5 * std::log1p(1e-3 * std::sin(x)), 1e-16) << x;
  }
}

TEST(GaussRule, point_count_estimate_bounds_the_error_near_a_pole) {
  // 1 / (x - pole) on [-1, 1].
  for (const double pole : {1.5, 2.0, 3.0, 8.0}) {
    for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
      const int n = gauss_points_needed(ellipse_size((pole - 1) + (pole + 1)), tolerance);
      if (n > max_gauss_points) continue;
      const GaussRule& rule = gauss_rule(n);
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += 2 * rule.weights[i] / (pole - (2 * rule.points[i] - 1));
      const double exact = std::log((pole + 1) / (pole - 1));
      EXPECT_LE(std::abs(sum - exact) / exact, tolerance) << pole << ", " << n << " points";
    }
  }
}

TEST(ElementGeometry, difference_quotients_have_no_cancellation) {
  for (const double half_angle : {0.0, 1e-7, 0.4, -1.1}) {
    const ElementGeometry element{{0.3, 0.1}, {0.5, 0.2}, {0.05, -0.1}, ElementBasis(half_angle)};
    const double from = 0.7, d = 1e-9;
    EXPECT_NEAR((element.quotients(from + d, from).place - element.derivative(from + d / 2)).norm(), 0, 4e-15);
    const auto quotient = element.quotients(-0.4, 0.9).shape, a = element.shape(-0.4), b = element.shape(0.9);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(quotient[k], (a[k] - b[k]) / (-0.4 - 0.9), 1e-15);
  }
}

TEST(ElementGeometry, arc_elements_lie_on_the_circle_and_represent_linear_fields_and_rotated_normals) {
  for (const double sweep : {1e-6, 0.1, -0.78, 2.5}) {
    const Arc arc{{0.2, 0.1}, {0.5, 0.3}, sweep};
    const ElementGeometry element = element_through(arc.start, arc.at(0.5), arc.end, sweep);
    for (const double xi : {-1.0, -0.77, 0.0, 0.31, 1.0}) {
      EXPECT_NEAR((element.at(xi) - arc.at(0.5 * (1 + xi))).norm(), 0, 2e-16);
      EXPECT_NEAR(element.derivative(xi).norm(), 0.5 * arc.length(), 1e-15);
      const auto shape = element.shape(xi);
      Point place = Point::Zero(), tangent = Point::Zero();
      for (int k = 0; k < 3; ++k) {
        place += shape[k] * element.at(k - 1);
        tangent += shape[k] * arc.tangent(0.5 * k);
      }
      EXPECT_NEAR((place - element.at(xi)).norm(), 0, 2e-16);
      EXPECT_NEAR((tangent - arc.tangent(0.5 * (1 + xi))).norm(), 0, 1e-15);
    }
  }
}

TEST(ElementGeometry, points_seen_from_another_are_those_at_their_parameter) {
  for (const double half_angle : {0.0, 1e-7, 0.4, -1.1}) {
    const ElementGeometry element{{0.3, 0.1}, {0.5, 0.2}, {0.05, -0.1}, ElementBasis(half_angle)};
    for (const double from : {-1.0, 0.2, 1.0})
      for (const double way : {-0.7, 1e-3, 0.6}) {
        const auto [values, quotients] =
            element.values_and_quotients(from, way, element.basis.half(from), element.basis.half(way));
        const ElementGeometry::Values at = element.values(from + way, element.basis.at(from + way));
        const ElementGeometry::Quotients between = element.quotients(from + way, from);
        EXPECT_NEAR((values.derivative - at.derivative).norm(), 0, 1e-15);
        EXPECT_NEAR((quotients.place - between.place).norm(), 0, 1e-15);
        for (int k = 0; k < 3; ++k) {
          EXPECT_NEAR(values.shape[k], at.shape[k], 1e-15);
          EXPECT_NEAR(values.shape_derivative[k], at.shape_derivative[k], 2e-15);
          EXPECT_NEAR(quotients.shape[k], between.shape[k], 1e-15);
        }
      }
  }
}

TEST(ArcParameters, places_differ_by_no_more_than_said) {
  const double sweep = -0.9;
  const ElementGeometry arc =
      element_through({1, 0}, {std::cos(0.45), -std::sin(0.45)}, {std::cos(0.9), -std::sin(0.9)}, sweep);
  const ArcParameters parameters(arc);
  const Interval part{-0.5, 1};
  for (const double radius : {0.3, 0.9, 1.0, 1.4, 5.0})
    for (double angle = 0.05; angle < 6.3; angle += 0.25) {
      const Point middle = radius * Point(std::cos(angle), std::sin(angle)), half = 0.2 * Point(0.6, 0.8);
      const std::array<Point, 3> places{middle - half, middle, middle + half};
      const double change = parameters.largest_change(places, part),
                   at_middle = parameters.sum_of_distances(middle, part);
      for (const Point& x : places) {
        const double sum = parameters.sum_of_distances(x, part);
        EXPECT_NEAR(sum, singularities_from(arc, x).sum_of_distances(part), 1e-13 * sum);
        EXPECT_LE(std::abs(sum - at_middle), change) << radius << ", " << angle;
      }
    }
  // All places on an arc have the same distance from its centre.
  EXPECT_GT(parameters.sum_of_distances({0, 0}, part), 50);
}

// Integral of ln|x - y| over [0, 1] x [c, c + 1]; in extended precision, since large terms cancel.
double log_double_integral(long double c) {
  const auto f = [](long double z) { return z == 0 ? 0.0L : 0.5L * z * z * std::log(std::abs(z)) - 0.75L * z * z; };
  return static_cast<double>(f(c + 1) - 2 * f(c) + f(c - 1));
}

std::vector<ElementGeometry> collinear(double second_start) {
  return {{{0.5, 0}, {0.5, 0}, {0, 0}}, {{second_start + 0.5, 0}, {0.5, 0}, {0, 0}}};
}

TEST(PairIntegrator, logarithm_agrees_with_closed_form_for_equal_touching_near_and_far_elements) {
  const PairIntegrator same(collinear(1), 1e-14);
  EXPECT_NEAR(total(same.integrate(0, 0, Contact::same, PairPart::everything).mass[0]), -1.5, 1e-14);
  EXPECT_NEAR(total(same.integrate(0, 1, Contact::end_to_start, PairPart::everything).mass[0]), log_double_integral(1),
              1e-14);
  for (const double gap : {1e-6, 1e-3, 0.1, 1.0, 20.0}) {
    const double start = 1 + gap;
    const PairIntegrator apart(collinear(start), 1e-14);
    const double value = total(apart.integrate(0, 1, Contact::none, PairPart::everything).mass[0]);
    EXPECT_NEAR(value / log_double_integral(start), 1, 2e-14) << gap;
  }
}

// Neighbours on a circle of four to thirty-two arcs, and each with itself: what a loose tolerance says holds.
TEST(PairIntegrator, curved_elements_that_touch_keep_loose_tolerances_too) {
  for (const int arcs : {4, 8, 32}) {
    const double step = 2 * std::numbers::pi / arcs;
    const auto on_circle = [](double angle) { return Point(std::cos(angle), std::sin(angle)); };
    std::vector<ElementGeometry> elements;
    for (int k = 0; k < 2; ++k)
      elements.push_back(
          element_through(on_circle(k * step), on_circle((k + 0.5) * step), on_circle((k + 1) * step), step));
    for (const auto& [inner, contact] : {std::pair(0, Contact::same), {1, Contact::end_to_start}}) {
      const PairMoments tight = PairIntegrator(elements, 1e-14).integrate(0, inner, contact, PairPart::everything);
      for (const double tolerance : {1e-6, 1e-3}) {
        const PairMoments loose =
            PairIntegrator(elements, tolerance).integrate(0, inner, contact, PairPart::everything);
        const auto difference = [](const auto& one, const auto& other) {
          double largest = 0, off = 0;
          for (std::size_t c = 0; c < one.size(); ++c)
            for (std::size_t b = 0; b < one[c].size(); ++b)
              for (std::size_t a = 0; a < 3; ++a) {
                largest = std::max(largest, std::abs(one[c][b][a]));
                off = std::max(off, std::abs(one[c][b][a] - other[c][b][a]));
              }
          return off / largest;
        };
        const double mass = difference(tight.mass, loose.mass), slopes = difference(tight.derivative, loose.derivative);
        const double layer = difference(tight.double_layer, loose.double_layer);
        std::printf("%2d arcs, contact %d, tolerance %g: off by %.1e, %.1e, %.1e with %.2f of the points\n", arcs,
                    static_cast<int>(contact), tolerance, mass, slopes, layer,
                    static_cast<double>(loose.evaluations) / tight.evaluations);
        EXPECT_LE(std::max({mass, slopes, layer}), tolerance);
        EXPECT_LT(loose.evaluations, 0.5 * tight.evaluations);
      }
    }
  }
}

TEST(PairIntegrator, touching_elements_agree_with_their_halves) {
  // A corner of 60 degrees between lengths 1 and 1/3, and a curved neighbour.
  const Point tip{0.5, std::sqrt(0.75)};
  const auto bulging = [](double bulge, double sweep) {  // ends in (1, 0)
    return element_through({0, 0}, {0.5, bulge}, {1, 0}, sweep);
  };
  const auto arc = [&](double bulge) { return bulging(bulge, -4 * std::atan(2 * bulge)); };
  for (const ElementGeometry& first : {bulging(0, 0), bulging(0.04, 0), arc(0.04), arc(0.0999), arc(-0.0999)}) {
    const double bulge = first.c0.y();
    const std::vector<ElementGeometry> elements{first,
                                                {Point(1, 0) - tip / 6, -tip / 6, {0, 0}},
                                                {Point(1, 0) - tip / 12, -tip / 12, {0, 0}},
                                                {Point(1, 0) - tip / 4, -tip / 12, {0, 0}}};
    const PairIntegrator integrator(elements, 1e-15);
    const PairMoments whole = integrator.integrate(0, 1, Contact::end_to_start, PairPart::everything);
    const PairMoments near = integrator.integrate(0, 2, Contact::end_to_start, PairPart::everything);
    const PairMoments far = integrator.integrate(0, 3, Contact::none, PairPart::everything);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(total(whole.mass[c]), total(near.mass[c]) + total(far.mass[c]), 3e-14) << c << ", bulge " << bulge;
    // A test function that vanishes at the common end leaves the double layer of a constant integrable.
    for (int c = 0; c < 4; ++c) {
      const auto start = [c](const PairMoments& m) {
        return m.double_layer[c][3][0] + m.double_layer[c][4][0];  // N_b(x) of the nodes apart from the common one
      };
      EXPECT_NEAR(start(whole), start(near) + start(far), 3e-14) << c << ", bulge " << bulge;
    }
  }
}

}  // namespace
