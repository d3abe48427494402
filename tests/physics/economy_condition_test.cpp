// The figure of the condition tells how many digits of a solution are lost, and a warning comes with a figure that
// leaves few. Reference: pure bending, Timoshenko and Goodier, Theory of Elasticity, 3rd ed., art. 102, in bars of
// growing slenderness: bending is about slenderness^4 times softer than stretching.
#include <gtest/gtest.h>

#include "host.hpp"

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
    EXPECT_LE(bar.error, 1e-14 / bar.reciprocal_condition);
    EXPECT_EQ(bar.warnings.size(), slenderness == 1000 ? 1u : 0u);
  }
}

TEST(Condition, is_one_before_anything_is_solved_and_does_not_depend_on_units_or_stiff_neighbours) {
  const auto figure = [](double unit, double stiff) {
    Model model;
    const int32_t soft = model.add(material(3e9 * unit, 1.0 / 3)), hard = model.add(material(3e9 * stiff * unit, 0.2));
    const int32_t lattice = model.pd(soft, rectangle(0, 0, 1 / unit, 0.5 / unit), 0.1 / unit, 3);
    const int32_t block = model.bem(hard, rectangle(1 / unit, 0, 2 / unit, 0.5 / unit), 0.25 / unit);
    model.fix(lattice, 4, BEMPD_BOTH);
    model.traction(block, 2, 0, 1, BEMPD_Y, 0, 1e3);
    EXPECT_EQ(model.statistics().reciprocal_condition, 1);
    model.step(1);
    return model.statistics().reciprocal_condition;
  };
  const double reference = figure(1, 1);
  std::printf("reciprocal condition %.3g, in other units %.3g, beside a block 1e6 times as stiff %.3g\n", reference,
              figure(1e3, 1), figure(1, 1e6));
  EXPECT_GT(reference, 1e-6);
  EXPECT_LT(reference, 1);
  EXPECT_NEAR(figure(1e3, 1) / reference, 1, 1e-6);
  EXPECT_GT(figure(1, 1e6), 1e-6);
}

}  // namespace
