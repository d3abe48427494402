// A scene pays for what it has, counted in kernel evaluations, factorizations, changes of the factor and solutions.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace economy_test {
namespace {

using namespace host;

constexpr double nu = 1.0 / 3;

void expect_no_new_matrix_work(const bempd_statistics& before, const bempd_statistics& after) {
  EXPECT_EQ(after.kernel_evaluations, before.kernel_evaluations);
  EXPECT_EQ(after.dense_factorizations, before.dense_factorizations);
  EXPECT_EQ(after.sparse_factorizations, before.sparse_factorizations);
  EXPECT_EQ(after.factor_updates, before.factor_updates);
}

struct Strip {
  BondModel model;
  int32_t left, middle, right, load;
};

// BEM | PD | BEM, held at the left end and pulled at the right one.
void build(Strip& s, double pull, double critical_stretch = 0) {
  const int32_t id = s.model.add(material(3e9, nu, BEMPD_PLANE_STRESS, 1, critical_stretch));
  s.left = s.model.bem(id, rectangle(0, 0, 1, 0.5), 0.25);
  s.middle = s.model.pd(id, rectangle(1, 0, 2, 0.5), 0.1, 3);
  s.right = s.model.bem(id, rectangle(2, 0, 3, 0.5), 0.25);
  s.model.fix(s.left, 4, BEMPD_BOTH);
  s.load = s.model.traction(s.right, 2, 0, 1, BEMPD_X, 0, pull);
}

TEST(Economy, an_uncracked_scene_costs_one_solution) {
  Strip s;
  build(s, 1e3);
  for (double load_factor : {0.5, 1.0, -2.0}) s.model.step(load_factor);
  for (int32_t region : {s.left, s.middle, s.right}) s.model.field(region, BEMPD_STRESS);
  s.model.evaluate({0.5, 0.2});
  EXPECT_EQ(s.model.statistics().solves, 1);
  EXPECT_EQ(s.model.statistics().sparse_factorizations, 1);
  EXPECT_EQ(s.model.statistics().factor_updates, 0);
}

TEST(Economy, bonds_that_could_break_but_do_not_cost_nothing_more) {
  Strip s;
  build(s, 1e3, 1e-3);
  EXPECT_EQ(s.model.step(1).events, 0);
  EXPECT_EQ(s.model.statistics().solves, 1);
  EXPECT_EQ(s.model.statistics().factor_updates, 0);
}

TEST(Economy, an_unloaded_scene_is_not_solved) {
  Strip s;
  build(s, 0);
  s.model.step(1);
  const bempd_statistics idle = s.model.statistics();
  EXPECT_EQ(idle.solves, 0);
  EXPECT_EQ(idle.sparse_factorizations, 0);
  EXPECT_EQ(idle.dense_factorizations, 0);
  EXPECT_EQ(largest(s.model.displacements()), 0);

  Strip loaded;
  build(loaded, 1e3);
  loaded.model.step(1);
  const double pull = 1e3;
  s.model.check(bempd_set_load_values(s.model.get(), s.load, 1, nullptr, &pull));
  s.model.step(1);
  EXPECT_EQ(s.model.statistics().solves, 1);
  EXPECT_EQ(s.model.displacements(), loaded.model.displacements());
}

TEST(Economy, new_loads_change_right_hand_sides_only) {
  Strip s;
  build(s, 1e3);
  s.model.step(1);
  const bempd_statistics before = s.model.statistics();
  const std::vector<double> once = s.model.displacements();
  const double pull = 2e3;
  s.model.check(bempd_set_load_values(s.model.get(), s.load, 1, nullptr, &pull));
  s.model.step(1);
  expect_no_new_matrix_work(before, s.model.statistics());
  EXPECT_GT(s.model.statistics().solves, before.solves);
  EXPECT_LE(largest_difference(s.model.displacements(), once, 2), 1e-12 * largest(once));
}

TEST(Economy, kernels_are_evaluated_for_operators_once_and_for_places_when_asked) {
  Strip s;
  build(s, 1e3);
  s.model.prepare();
  const int64_t operators = s.model.statistics().kernel_evaluations;
  s.model.step(1);
  for (int32_t region : {s.left, s.right})
    for (int32_t field : {BEMPD_DISPLACEMENT, BEMPD_STRESS, BEMPD_TRACTION, BEMPD_ELEMENT_STRESS})
      s.model.field(region, field);
  s.model.evaluate({1.5, 0.25});
  EXPECT_EQ(s.model.statistics().kernel_evaluations, operators);
  s.model.evaluate({0.5, 0.2});
  const int64_t one_place = s.model.statistics().kernel_evaluations - operators;
  EXPECT_GT(one_place, 0);
  s.model.evaluate({0.5, 0.2});
  EXPECT_EQ(s.model.statistics().kernel_evaluations, operators + 2 * one_place);
}

TEST(Economy, scenes_without_cracks_or_without_a_method_do_not_pay_for_it) {
  BondModel boundary, lattice;
  boundary.bem(boundary.add(material(3e9, 0.2)), rectangle(0, 0, 1, 0.5), 0.25);
  lattice.pd(lattice.add(material(3e9, nu)), rectangle(0, 0, 1, 0.5), 0.1, 3);
  for (Model* model : {&boundary, &lattice}) {
    model->fix(1, 4, BEMPD_BOTH);
    model->traction(1, 2, 0, 1, BEMPD_X, 0, 1e3);
    model->step(1);
  }
  EXPECT_GT(boundary.statistics().kernel_evaluations, 0);
  EXPECT_EQ(boundary.statistics().bonds, 0);
  EXPECT_EQ(boundary.statistics().sparse_unknowns, 0);
  EXPECT_EQ(boundary.statistics().sparse_factorizations, 0);
  EXPECT_GT(lattice.statistics().bonds, 0);
  EXPECT_EQ(lattice.statistics().kernel_evaluations, 0);
  EXPECT_EQ(lattice.statistics().dense_factorizations, 0);
}

TEST(Economy, a_crack_run_leaves_boundary_regions_alone_and_factorizes_much_less_often_than_it_breaks) {
  BondModel model;
  build(model, CentreCrack::small());
  model.prepare();
  const bempd_statistics before = model.statistics();
  const bempd_step_report run = model.run(1e9);
  const bempd_statistics after = model.statistics();
  ASSERT_GT(run.events, 100);
  EXPECT_EQ(after.kernel_evaluations, before.kernel_evaluations);
  EXPECT_EQ(after.dense_factorizations, 2);
  EXPECT_LT(after.sparse_factorizations, run.events / 4);
  std::printf("%lld events, %lld sparse factorizations\n", static_cast<long long>(run.events),
              static_cast<long long>(after.sparse_factorizations));
}

struct Row {
  int64_t evaluations;
  std::vector<double> values;  // displacements and strains at a place in every block
};

// Blocks between peridynamic strips, all meshed alike. With `turned` the outline of every second one begins at another
// corner: the same body in another numbering.
Row row_of_blocks(int count, const char* scheme, bool turned) {
  constexpr double young = 3e9, height = 0.6;
  BondModel model;
  model.set_text("scheme", scheme);
  const int32_t id = model.add(material(young, nu));
  int32_t strip = model.pd(id, rectangle(0, 0, 0.3, height), 0.05, 3);
  model.fix(strip, 4, BEMPD_BOTH);
  for (int k = 0; k < count; ++k) {
    const double x = 0.3 + 0.7 * k;
    Outline outline = rectangle(x, 0, x + 0.4, height);
    if (turned && k % 2 == 1) std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    model.bem(id, outline, 0.15);
    strip = model.pd(id, rectangle(x + 0.4, 0, x + 0.7, height), 0.05, 3);
  }
  model.traction(strip, 2, 0, 1, BEMPD_Y, 0, 1e3);
  model.step(1);
  Row row{model.statistics().kernel_evaluations, {}};
  for (int k = 0; k < count; ++k) {
    const auto at = model.evaluate({0.4 + 0.7 * k, 0.2});
    row.values.insert(row.values.end(), {at.displacement[0], at.displacement[1]});
    for (double stress : at.stress) row.values.push_back(stress / young);
  }
  return row;
}

TEST(Economy, equal_regions_share_one_boundary_operator) {
  for (const char* scheme : all_schemes()) {
    const Row one = row_of_blocks(1, scheme, false), four = row_of_blocks(4, scheme, false),
              numbered_anew = row_of_blocks(4, scheme, true);
    std::printf("%s: %lld evaluations for one block, %lld for four, %lld for four in two numberings\n", scheme,
                static_cast<long long>(one.evaluations), static_cast<long long>(four.evaluations),
                static_cast<long long>(numbered_anew.evaluations));
    EXPECT_GT(one.evaluations, 0);
    EXPECT_EQ(four.evaluations, one.evaluations);
    EXPECT_GT(numbered_anew.evaluations, 3 * one.evaluations / 2);
    const double difference = largest_difference(four.values, numbered_anew.values) / largest(four.values);
    EXPECT_LE(report("results of shared operators", difference, 0, "operators of their own"), 1e-10);
  }
}

// Kernel evaluations of two blocks side by side, the second with a property that differs or not.
int64_t evaluations_of_two(double young, double poisson, double length, double height, bool loaded) {
  BondModel model;
  const int32_t first = model.add(material(3e9, 0.2)), second = model.add(material(young, poisson));
  model.bem(first, rectangle(0.1, 0.3, 0.5, 0.9), 0.15);
  model.bem(second, rectangle(0.6, 0.3, 1.0, 0.3 + height), length);
  for (int32_t region : {1, 2}) model.fix(region, 4, BEMPD_BOTH);
  model.traction(1, 2, 0, 1, BEMPD_X, 0, 1e3);
  if (loaded) model.traction(2, 2, 0, 0.5, BEMPD_X, 0, 1e3);
  model.prepare();
  return model.statistics().kernel_evaluations;
}

TEST(Economy, operators_are_shared_by_equal_shape_material_and_mesh_only) {
  BondModel single;
  single.bem(single.add(material(3e9, 0.2)), rectangle(0.1, 0.3, 0.5, 0.9), 0.15);
  single.fix(1, 4, BEMPD_BOTH);
  single.traction(1, 2, 0, 1, BEMPD_X, 0, 1e3);
  single.prepare();
  const int64_t one = single.statistics().kernel_evaluations;
  EXPECT_EQ(evaluations_of_two(3e9, 0.2, 0.15, 0.6, false), one);
  EXPECT_EQ(evaluations_of_two(4e9, 0.2, 0.15, 0.6, false), 2 * one);
  EXPECT_GT(evaluations_of_two(3e9, 0.3, 0.15, 0.6, false), one);
  EXPECT_GT(evaluations_of_two(3e9, 0.2, 0.10, 0.6, false), one);
  EXPECT_GT(evaluations_of_two(3e9, 0.2, 0.15, 0.6001, false), one);
  EXPECT_GT(evaluations_of_two(3e9, 0.2, 0.15, 0.6, true), one);
}

// Factorizations of a run between clamps, whose ends are nearly as critical as the crack where Poisson's ratio is high:
// the window stays at the crack.
int64_t factorizations_of_a_run(double ratio, const bempd_plane plane) {
  BondModel model;
  model.set_text("stepping.control", "path");
  const int32_t id = model.add(material(1, ratio, plane, 1, 1e-3));
  const int32_t strip = model.pd(id, rectangle(0, 0, 80, 31), 1, 3);
  model.crack({{0, 15.5}, {25.5, 15.5}});
  for (const int32_t edge : {1, 3}) {
    model.prescribe(strip, edge, BEMPD_X, 0, 0);
    model.prescribe(strip, edge, BEMPD_Y, 0, edge == 1 ? -1 : 1);
  }
  for (int event = 0; event < 40; ++event) model.next_event(1e9);
  return model.statistics().sparse_factorizations;
}

TEST(Economy, a_growing_crack_takes_one_factorization_at_any_ratio) {
  EXPECT_EQ(factorizations_of_a_run(1.0 / 3, BEMPD_PLANE_STRESS), 1);
  EXPECT_EQ(factorizations_of_a_run(0.49, BEMPD_PLANE_STRESS), 1);
  EXPECT_EQ(factorizations_of_a_run(0.45, BEMPD_PLANE_STRAIN), 1);
}

}  // namespace
}  // namespace economy_test
