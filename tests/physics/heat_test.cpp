// Heat and weight in both kinds of region, and where they meet.
#include <gtest/gtest.h>

#include "coupled_scene.hpp"

namespace heat_test {
namespace {

using namespace host;

constexpr double young = 70e9, expansion = 1.2e-5;

bempd_material hot(double ratio, int32_t plane, double coefficient = expansion) {
  bempd_material solid = material(young, ratio, plane, 0.02);
  solid.thermal_expansion = coefficient;
  return solid;
}

void heat(Model& model, int32_t region, double constant, double proportional) {
  model.check(bempd_add_temperature(model.get(), region, constant, proportional, nullptr));
}

using Temperature = double (*)(double, double);

int32_t call_temperature(double x, double y, double* /*constant*/, double* proportional, void* user) {
  proportional[0] = (*static_cast<Temperature*>(user))(x, y);
  return 0;
}

double strain_of(double ratio, int32_t plane, double temperature) {
  return expansion * temperature * (plane == BEMPD_PLANE_STRAIN ? 1 + ratio : 1);
}

struct Case {
  double ratio;
  int32_t plane;
};

class Heat : public testing::TestWithParam<Case> {};

// A lattice between boundary elements, one side of which has elements of its own.
std::vector<int32_t> three_pieces(Model& model, int32_t id) {
  const int32_t left = model.bem(id, rectangle(0, 0, 0.6, 0.8), 0.2);
  const int32_t middle = model.pd(id, rectangle(0.6, 0, 1.6, 0.8), 0.1, 3);
  const int32_t right = model.bem(id, rectangle(1.6, 0, 2, 0.8), 0.2);
  model.mesh(right, 4, 0.26, 1);
  return {left, middle, right};
}

TEST_P(Heat, expands_a_body_without_stress_if_it_is_free) {
  const auto [ratio, plane] = GetParam();
  Model model;
  const std::vector<int32_t> regions = three_pieces(model, model.add(hot(ratio, plane)));
  for (const int32_t region : regions) heat(model, region, 20, 60);
  model.fix_point({0, 0}, BEMPD_BOTH);
  model.fix_point({0, 0.8}, BEMPD_X);
  model.step(0.5);
  const double strain = strain_of(ratio, plane, 20 + 0.5 * 60);
  double displacement = 0, stress = 0;
  for (const int32_t region : regions) {
    const auto x = model.vectors(region, BEMPD_POSITION), u = model.vectors(region, BEMPD_DISPLACEMENT);
    for (std::size_t i = 0; i < x.size(); ++i)
      displacement = largest({displacement, u[i][0] - strain * x[i][0], u[i][1] - strain * x[i][1]});
    for (const double s : model.field(region, BEMPD_STRESS)) stress = std::max(stress, std::abs(s));
  }
  const auto inside = model.evaluate({0.31, 0.47});
  displacement =
      largest({displacement, inside.displacement[0] - strain * 0.31, inside.displacement[1] - strain * 0.47});
  std::printf("error of the displacement over the largest %.1e, stress over E strain %.1e (reference: 0)\n",
              displacement / (2 * strain), stress / (young * strain));
  EXPECT_LE(displacement, 1e-12 * 2 * strain);
  EXPECT_LE(stress, 1e-10 * young * strain);
}

// Held all around it is pressed by E' strain (1 + nu') / (1 - nu'^2) = c11 + c12 times the strain, and nothing moves.
TEST_P(Heat, presses_a_body_that_is_held) {
  const auto [ratio, plane] = GetParam();
  Model model;
  const std::vector<int32_t> regions = three_pieces(model, model.add(hot(ratio, plane)));
  for (std::size_t k = 0; k < regions.size(); ++k) {
    heat(model, regions[k], 0, 50);
    for (const int32_t edge : {1, 3}) model.fix(regions[k], edge, BEMPD_BOTH);
  }
  model.fix(regions[0], 4, BEMPD_BOTH);
  model.fix(regions[2], 2, BEMPD_BOTH);
  model.step(1);
  const double strain = strain_of(ratio, plane, 50), nu = plane == BEMPD_PLANE_STRESS ? ratio / (1 + ratio) : ratio;
  const double pressure = young / (1 + ratio) / (1 - 2 * nu) * strain;
  double error = 0;
  for (const int32_t region : regions) {
    const std::vector<double> stress = model.field(region, BEMPD_STRESS);
    for (std::size_t i = 0; i < stress.size(); ++i)
      error = std::max(error, std::abs(stress[i] + (i % 3 == 2 ? 0 : pressure)) / pressure);
    for (const double u : model.field(region, BEMPD_DISPLACEMENT)) error = std::max(error, std::abs(u) / strain);
  }
  std::printf("error of pressure and displacement, relative, %.1e (reference: 0)\n", error);
  EXPECT_LE(error, 1e-9);
  // What the body stores has been done by heat: pressure times strain, over the volume.
  const bempd_history_entry line = model.history().back();
  EXPECT_NEAR(line.stored_energy, pressure * strain * 2 * 0.8 * 0.02, 1e-8 * line.stored_energy);
  EXPECT_LE(line.energy_balance_error, 1e-10);
}

// A temperature that is linear is followed freely, too, with straight lines that bend.
TEST_P(Heat, that_is_linear_bends_without_stress) {
  const auto [ratio, plane] = GetParam();
  for (const std::string kind : {"lattice", "lattice with its rows turned", "boundary elements"}) {
    Model model;
    if (kind == "lattice with its rows turned") model.lattice_angle = 0.3;
    const int32_t id = model.add(hot(ratio, plane));
    const Outline box = rectangle(0, 0, 1, 0.6);
    const int32_t body = kind == "boundary elements" ? model.bem(id, box, 0.2) : model.pd(id, box, 0.05, 3);
    Temperature field = [](double x, double y) { return 40 - 30 * x + 25 * y; };
    model.check(bempd_add_temperature_function(model.get(), body, &call_temperature, &field, nullptr));
    model.fix_point({0, 0}, BEMPD_BOTH);
    model.fix_point({1, 0}, BEMPD_Y);
    model.step(1);
    const double unit = strain_of(ratio, plane, 1), a = 40 * unit, b = -30 * unit, c = 25 * unit;
    const auto free = [&](double x, double y) {
      return Vector{a * x + b * (x * x - y * y) / 2 + c * x * y, a * y + b * x * y + c * (y * y - x * x) / 2};
    };
    const double turn = free(1, 0)[1];
    const auto x = model.vectors(body, BEMPD_POSITION), u = model.vectors(body, BEMPD_DISPLACEMENT);
    double error = 0, stress = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector e = free(x[i][0], x[i][1]);
      error = largest({error, u[i][0] - e[0] - turn * x[i][1], u[i][1] - e[1] + turn * x[i][0]});
    }
    for (const double s : model.field(body, BEMPD_STRESS)) stress = std::max(stress, std::abs(s));
    std::printf("%s: error over the largest displacement %.1e, stress over E strain %.1e (reference: 0)\n",
                kind.c_str(), error / a, stress / (young * a));
    EXPECT_LE(error, 1e-10 * a);
    EXPECT_LE(stress, 1e-9 * young * a);
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, Heat,
                         testing::Values(Case{1.0 / 3, BEMPD_PLANE_STRESS}, Case{0.2, BEMPD_PLANE_STRESS},
                                         Case{0.45, BEMPD_PLANE_STRAIN}),
                         [](const auto& test) { return "case_" + std::to_string(test.index); });

// Two strips of one stiffness that expand differently (Timoshenko, J. Opt. Soc. Am. 11, 1925): curvature
// 3/2 (difference of strains) / height. Read from deflections of the middle part, away from the ends.
TEST(Bimetal, bends_as_timoshenko_has_it) {
  for (const bool lattice : {true, false}) {
    Model model;
    const int32_t low = model.add(hot(0.3, BEMPD_PLANE_STRESS, 0)), high = model.add(hot(0.3, BEMPD_PLANE_STRESS));
    const auto strip = [&](int32_t id, double y0, double y1) {
      const Outline box = rectangle(0, y0, 16, y1);
      return lattice ? model.pd(id, box, 0.0625, 3) : model.bem(id, box, 0.25);
    };
    strip(low, 0, 0.5);
    heat(model, strip(high, 0.5, 1), 0, 100);
    model.fix_point({0, 0}, BEMPD_BOTH);
    model.fix_point({16, 0}, BEMPD_Y);
    model.step(1);
    const auto at = [&](double x) { return model.evaluate({x, 0.5}).displacement[1]; };
    const double curvature = -(at(5) - 2 * at(8) + at(11)) / 9;
    const double expected = 1.5 * expansion * 100 / 1;
    report(lattice ? "curvature, lattices" : "curvature, boundary elements", curvature, expected, "Timoshenko 1925");
    EXPECT_NEAR(std::abs(curvature) / expected, 1, lattice ? 1e-2 : 1e-3);
  }
}

// Shrinking between ends that are held it cracks from a notch, and the energies go up.
TEST(Cooling, cracks_a_bar_that_is_held) {
  for (const double ratio : {1.0 / 3, 0.2}) {
    Model model;
    bempd_material solid = hot(ratio, BEMPD_PLANE_STRESS);
    solid.critical_stretch = 1e-3;
    const int32_t id = model.add(solid);
    const int32_t left = model.bem(id, rectangle(0, 0, 10, 12), 3);
    const int32_t middle = model.pd(id, rectangle(10, 0, 30, 12), 1, 3);
    const int32_t right = model.bem(id, rectangle(30, 0, 40, 12), 3);
    model.crack({{19.5, 0}, {19.5, 4.4}});
    for (const int32_t region : {left, middle, right}) heat(model, region, 0, -1);
    // What holds along the ends would go on doing so in both halves.
    model.fix(left, 4, BEMPD_X);
    model.fix(right, 2, BEMPD_X);
    model.fix_point({0, 0}, BEMPD_Y);
    model.fix_point({40, 0}, BEMPD_Y);
    const bempd_step_report first = model.next_event(1e6);
    const bempd_step_report last = model.run(1e6);
    std::printf("nu %.2f: first break at %.2f K, %lld bonds, energy balance %.1e (reference: 0)\n", ratio,
                first.load_factor, static_cast<long long>(last.total_broken_bonds), last.energy_balance_error);
    // The notch is felt: earlier than where the bar's strain is the critical stretch.
    EXPECT_LT(expansion * first.load_factor, 1e-3);
    EXPECT_TRUE(last.separated);
    EXPECT_LE(last.energy_balance_error, 1e-10);
  }
}

// A column of lattice on one of boundary elements under their weight: the support carries it, and the top sinks by
// w h^2 / (2 E) of a column on which only its weight acts.
TEST(Weight, is_carried_from_a_lattice_through_boundary_elements) {
  Model model;
  const int32_t id = model.add(material(young, 0.2, BEMPD_PLANE_STRESS, 0.02));
  const int32_t low = model.bem(id, rectangle(0, 0, 1, 4), 0.5), high = model.pd(id, rectangle(0, 4, 1, 10), 0.1, 3);
  constexpr double weight = 25e3;
  for (const int32_t region : {low, high})
    model.check(bempd_add_body_force(model.get(), region, BEMPD_Y, 0, -weight, nullptr));
  const int32_t foot = model.fix(low, 1, BEMPD_Y);
  model.fix_point({0, 0}, BEMPD_X);
  model.step(1);
  const double all = weight * 10 * 0.02, sunk = model.evaluate({0.5, 10}).displacement[1];
  EXPECT_LE(std::abs(report("reaction", model.reaction(foot)[1], all, "weight")), 1e-9 * all);
  EXPECT_LE(std::abs(report("top", sunk, -weight * 100 / (2 * young), "w h^2 / (2 E)")),
            2e-3 * weight * 100 / (2 * young));
}

TEST(Heat, of_boundary_elements_has_to_be_linear) {
  Model model;
  const int32_t body = model.bem(model.add(hot(0.3, BEMPD_PLANE_STRESS)), rectangle(0, 0, 1, 1), 0.2);
  Temperature field = [](double x, double y) { return x * y; };
  model.check(bempd_add_temperature_function(model.get(), body, &call_temperature, &field, nullptr));
  model.fix(body, 4, BEMPD_BOTH);
  EXPECT_EQ(bempd_prepare(model.get()), BEMPD_ERROR_ARGUMENT);
  EXPECT_NE(std::string(bempd_last_error(model.get())).find("linear in x and y"), std::string::npos);
}

}  // namespace
}  // namespace heat_test
