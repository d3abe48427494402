// The figure of the condition tells how many digits of a solution are lost, and a warning comes with a figure that
// leaves few. Reference: pure bending, Timoshenko and Goodier, Theory of Elasticity, 3rd ed., art. 102, in bars of
// growing slenderness: bending is about slenderness^4 times softer than stretching.
#include <gtest/gtest.h>

#include "host.hpp"

namespace economy_condition_test {
namespace {

using namespace host;

constexpr double young = 2.5, poisson = 0.3;

struct Outcome {
  double error, reciprocal_condition;
  std::vector<std::string> warnings;
};

void keep_warning(int32_t level, const char* message, void* user) {
  if (level == 1) static_cast<std::vector<std::string>*>(user)->push_back(message);
}

Outcome bent_bar(double slenderness) {
  const auto exact = [](double x, double y) {
    return Vector{x * (y - 0.5), -(x * x + poisson * (y - 0.5) * (y - 0.5)) / 2};
  };
  Outcome outcome{};
  Model model;
  model.check(bempd_set_log(model.get(), keep_warning, &outcome.warnings));
  const int32_t bar = model.bem(model.add(material(young, poisson)), rectangle(0, 0, slenderness, 1), slenderness / 20);
  model.prescribe(bar, 4, 0, 1, exact);
  model.traction(bar, 2, [](double, double y) { return Vector{young * (y - 0.5), 0}; });
  model.step(1);
  model.step(2);
  const auto x = model.vectors(bar, BEMPD_POSITION), u = model.vectors(bar, BEMPD_DISPLACEMENT);
  double error = 0, size = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vector e = exact(x[i][0], x[i][1]);
    error = largest({error, u[i][0] - 2 * e[0], u[i][1] - 2 * e[1]});
    size = largest({size, 2 * e[0], 2 * e[1]});
  }
  outcome.error = error / size;
  outcome.reciprocal_condition = model.statistics().reciprocal_condition;
  return outcome;
}

TEST(Condition, of_slender_bars_tells_the_digits_lost_and_warns_once) {
  for (double slenderness : {2.0, 10.0, 100.0, 1000.0}) {
    const Outcome bar = bent_bar(slenderness);
    std::printf("bar %g : 1, reciprocal condition %.2g, error %.2g, %zu warnings\n", slenderness,
                bar.reciprocal_condition, bar.error, bar.warnings.size());
    for (const std::string& warning : bar.warnings) std::printf("  %s\n", warning.c_str());
    // Rounding times condition, give or take what a crude figure is off.
    EXPECT_LE(bar.error, 1e-15 / bar.reciprocal_condition);
    EXPECT_GE(bar.error, 1e-19 / bar.reciprocal_condition);
    EXPECT_EQ(bar.warnings.size(), slenderness == 1000 ? 1u : 0u);
  }
}

TEST(Condition, of_a_coupled_body_is_one_before_it_is_solved_and_does_not_depend_on_units) {
  const auto figure = [](double metre, double pascal) {
    Model model;
    const int32_t id = model.add(material(3e9 * pascal, 1.0 / 3));
    const int32_t lattice = model.pd(id, rectangle(0, 0, 1 * metre, 0.5 * metre), 0.1 * metre, 3);
    const int32_t block = model.bem(id, rectangle(1 * metre, 0, 2 * metre, 0.5 * metre), 0.25 * metre);
    model.fix(lattice, 4, BEMPD_BOTH);
    model.traction(block, 2, 0, 1, BEMPD_Y, 0, 1e3);
    EXPECT_EQ(model.statistics().reciprocal_condition, 1);
    model.step(1);
    return model.statistics().reciprocal_condition;
  };
  const double reference = figure(1, 1), other = figure(1e3, 1e-9);
  report("reciprocal condition in mm and GPa", other, reference, "in m and Pa");
  EXPECT_NEAR(other / reference, 1, 1e-6);
  EXPECT_LT(reference, 1);
  EXPECT_GT(reference, 1e-6);
}

}  // namespace
}  // namespace economy_condition_test
