// A further law of bonds is its stages, given to a material: bonds that soften at the critical stretch before they
// break at a larger one run like any other, with and without windows.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "model/model.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/edge_part.hpp"

namespace second_bond_law_test {
namespace {

using namespace bempd;
using model::Model;

// --- The law: at the critical stretch half of the stiffness is left, up to one and a half times that stretch.

const coupling::TermLaw& softening() {
  static const coupling::TermLaw law({{1, 1}, {0.5, 1.5}});
  return law;
}

scene::Material material_of(const coupling::TermLaw& law) {
  scene::Material material;
  material.elasticity = {3e9, 1.0 / 3, PlaneState::stress, 0.01};
  material.critical_stretch = 5e-3;
  material.bond_law = law;
  return material;
}

// --- Scenes

std::vector<Point> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

void hold(scene::Scene& scene, int region, int edge, int component, double constant, double proportional) {
  scene.add_support({std::make_shared<const regions::EdgePart>(region, edge, 0, 1), component,
                     scene::SampledValues{{constant}, {proportional}}});
}

constexpr int along_x = 1, along_y = 2;

// The crack runs to the lower edge's other side between two blocks of boundary elements.
void notched_strip(scene::Scene& scene, const coupling::TermLaw& law) {
  const int id = scene.add_material(material_of(law));
  regions::add_boundary_region(scene, id, rectangle(0, 0, 0.02, 0.02), 0.005);
  regions::add_peridynamic_region(scene, id, rectangle(0.02, 0, 0.04, 0.02), 0.001, 4);
  regions::add_boundary_region(scene, id, rectangle(0.04, 0, 0.06, 0.02), 0.005);
  scene.add_crack({{0.0295, 0}, {0.0295, 0.0045}});
  hold(scene, 1, 4, along_x, 0, 0);
  hold(scene, 1, 4, along_y, 0, 0);
  hold(scene, 3, 2, along_x, 0, 1e-6);
  hold(scene, 3, 2, along_y, 0, 0);
}

// A lattice plate with a crack, whose ends are both moved, with a constant part from the start.
void cracked_plate(scene::Scene& scene, const coupling::TermLaw& law) {
  const int id = scene.add_material(material_of(law));
  regions::add_peridynamic_region(scene, id, rectangle(0, 0, 31, 31), 1, 3);
  scene.add_crack({{15.5, 11.5001}, {15.5, 19.4999}});
  hold(scene, 1, 4, along_x, -1e-3, -1e-3);
  hold(scene, 1, 4, along_y, 0, 0);
  hold(scene, 1, 2, along_x, 1e-3, 1e-3);
  hold(scene, 1, 2, along_y, 0, 0);
}

struct Case {
  const char* name;
  void (*build)(scene::Scene&, const coupling::TermLaw&);
};

std::unique_ptr<Model> model_of(const Case& body, const coupling::TermLaw& law, bool windows) {
  auto model = std::make_unique<Model>();
  body.build(model->editable_scene(), law);
  model->options().set_text("test.solver", windows ? "window" : "plain");
  model->options().set_text("crack.rule", "bond");
  return model;
}

fracture::EvolutionState separated(Model& model) {
  EXPECT_EQ(model.driver().advance(1e6, fracture::Goal::separation).reason, fracture::StopReason::separated);
  return model.prepared().evolution->state();
}

class SecondBondLaw : public testing::TestWithParam<Case> {};

TEST_P(SecondBondLaw, runs_to_separation_with_its_energies_in_balance) {
  const auto model = model_of(GetParam(), softening(), false);
  const fracture::EvolutionState state = separated(*model);
  std::int64_t gone = 0, softened = 0;
  for (const std::uint8_t stage : state.stages) {
    gone += stage == 2;
    softened += stage == 1;
  }
  std::printf("%s: %lld events, %lld bonds gone, %lld softened, energy balance %.1e (reference: 0)\n", GetParam().name,
              static_cast<long long>(state.events), static_cast<long long>(gone), static_cast<long long>(softened),
              state.worst_energy_balance_error);
  EXPECT_EQ(gone, state.broken_bonds + static_cast<std::int64_t>(model->prepared().cut_bonds.size()));
  EXPECT_GT(softened, 0);
  EXPECT_GT(state.released_energy, 0);
  EXPECT_LE(state.worst_energy_balance_error, 1e-12);
}

TEST_P(SecondBondLaw, is_tougher_than_the_brittle_one) {
  const auto soft = model_of(GetParam(), softening(), true);
  const auto brittle = model_of(GetParam(), coupling::TermLaw::brittle(), true);
  const double released = separated(*soft).released_energy;
  EXPECT_GT(released, separated(*brittle).released_energy);
}

TEST_P(SecondBondLaw, goes_through_the_same_events_in_windows) {
  const auto windows = model_of(GetParam(), softening(), true), plain = model_of(GetParam(), softening(), false);
  const fracture::EvolutionState a = separated(*windows), b = separated(*plain);
  EXPECT_LE(a.worst_energy_balance_error, 1e-12);
  // Windows have done a part of the work: the whole body was solved less often than there were events.
  EXPECT_LT(2 * windows->prepared().system->counters().solves, plain->prepared().system->counters().solves);
  ASSERT_EQ(a.history.size(), b.history.size());
  double difference = 0;
  for (std::size_t k = 0; k < a.history.size(); ++k) {
    const fracture::HistoryEntry &one = a.history[k], &other = b.history[k];
    EXPECT_EQ(one.event, other.event);
    EXPECT_EQ(one.total_broken_bonds, other.total_broken_bonds);
    const double energy = b.largest_work;
    difference = std::max({difference, std::abs(one.load_factor / other.load_factor - 1),
                           std::abs(one.stored_energy - other.stored_energy) / energy,
                           std::abs(one.released_energy - other.released_energy) / energy,
                           std::abs(one.work - other.work) / energy});
  }
  std::printf("%s: %zu lines, largest difference %.1e (reference: 0)\n", GetParam().name, a.history.size(), difference);
  EXPECT_LE(difference, 1e-9);
  EXPECT_EQ(a.stages, b.stages);
}

TEST_P(SecondBondLaw, goes_on_from_a_saved_state_in_the_middle) {
  const auto first = model_of(GetParam(), softening(), true), second = model_of(GetParam(), softening(), true);
  for (int event = 0; event < 20; ++event) first->driver().advance(1e6, fracture::Goal::next_event);
  const std::vector<std::uint8_t> bytes = model::to_bytes(first->states().save());
  second->states().restore(model::from_bytes(bytes.data(), bytes.size()));
  const fracture::EvolutionState a = separated(*first), b = separated(*second);
  EXPECT_EQ(a.stages, b.stages);
  EXPECT_EQ(a.work, b.work);
}

TEST(SecondBondLawInAScene, makes_another_body_of_it) {
  const Case body{"", notched_strip};
  const auto soft = model_of(body, softening(), true), brittle = model_of(body, coupling::TermLaw::brittle(), true);
  EXPECT_NE(soft->prepared().fingerprint.body, brittle->prepared().fingerprint.body);
}

INSTANTIATE_TEST_SUITE_P(Bodies, SecondBondLaw,
                         testing::Values(Case{"notched_strip", notched_strip}, Case{"cracked_plate", cracked_plate}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace second_bond_law_test
