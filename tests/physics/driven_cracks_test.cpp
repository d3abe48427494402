// Steps that grow cracks in boundary element regions: loads of growth against handbook factors, both directions of the
// load, energies, states, and what a host hears of it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "closing_cracks.hpp"
#include "contact_bodies.hpp"
#include "error.hpp"
#include "regions/boundary/boundary_description.hpp"
#include "regions/lattice/peridynamic_description.hpp"
#include "regions/places/edge_part.hpp"
#include "regions/places/single_point.hpp"
#include "scene/load_table.hpp"

namespace driven_cracks_test {
namespace {

using namespace bempd;
using fracture::Goal, fracture::StopReason;
using std::numbers::pi;

const fracture::EvolutionState& state(model::Model& model) { return model.prepared().evolution->state(); }

using Cracks = std::vector<std::vector<Point>>;
const Cracks centre{{{-0.3, 0}, {0.3, 0}}};

// A plate 2 wide and 6 high with a modulus and a fracture energy of 1, pulled at its ends by a stress of 1.
std::unique_ptr<model::Model> plate(const Cracks& cracks, double pull = 1, double fracture_energy = 1) {
  auto model = std::make_unique<model::Model>();
  scene::Scene& scene = model->editable_scene();
  scene::Material material;
  material.elasticity = {1, 0.3, PlaneState::stress, 0.5};
  material.fracture_energy = fracture_energy;
  regions::add_boundary_region(scene, scene.add_material(material), {{-1, -3}, {1, -3}, {1, 3}, {-1, 3}}, 0.5);
  for (const std::vector<Point>& crack : cracks) scene.add_crack(crack);
  const auto fix = [&](const Point& where, int component) {
    scene.add_support(
        {std::make_shared<const regions::SinglePoint>(where), component, scene::SampledValues{{0.0}, {0.0}}});
  };
  fix({-1, -3}, 1), fix({-1, -3}, 2), fix({1, -3}, 2);
  for (const int edge : {1, 3})
    scene.add_load({std::make_shared<const regions::EdgePart>(1, edge, 0, 1), 2,
                    scene::SampledValues{{0.0}, {edge == 3 ? pull : -pull}}});
  return model;
}

// A strip 4 long and 2 high with a crack from its left side, whose halves are moved apart: the crack grows stably.
std::unique_ptr<model::Model> opened_strip(const char* control) {
  auto model = std::make_unique<model::Model>();
  model->options().set_text("stepping.control", control);
  scene::Scene& scene = model->editable_scene();
  scene::Material material;
  material.elasticity = {1, 0.3, PlaneState::stress, 1};
  material.fracture_energy = 1e-2;
  regions::add_boundary_region(scene, scene.add_material(material), {{0, -0.5}, {4, -0.5}, {4, 0.5}, {0, 0.5}}, 0.25);
  scene.add_crack({{0, 0}, {1, 0}});
  for (const double side : {-1.0, 1.0})
    scene.add_support(
        {std::make_shared<const regions::SinglePoint>(Point(0, 0.5 * side)), 2, scene::SampledValues{{0.0}, {side}}});
  for (const int component : {1, 2})
    scene.add_support(
        {std::make_shared<const regions::SinglePoint>(Point(4, 0.5)), component, scene::SampledValues{{0.0}, {0.0}}});
  return model;
}

// Feddersen's factor in a strip, within 0.3 %.
double handbook_load(double half_crack) { return 1 / std::sqrt(pi * half_crack / std::cos(pi * half_crack / 2)); }

double new_length(model::Model& model) {
  double sum = 0;
  for (const fracture::CrackExtension& e : model.cracks().extensions()) sum += e.length;
  return sum;
}

TEST(DrivenCracks, grow_at_the_load_of_fracture_mechanics_in_both_directions) {
  for (const double pull : {1.0, -1.0}) {
    const auto model = plate(centre, pull);
    EXPECT_EQ(model->driver().advance(-5 * pull, Goal::load_factor).events, 0);
    const model::StepResult result = model->driver().advance(5 * pull, Goal::next_event);
    std::printf("grows at %.6f, handbook %.6f\n", model->load_factor(), pull * handbook_load(0.3));
    EXPECT_EQ(result.reason, StopReason::event);
    EXPECT_EQ(result.events, 1);
    EXPECT_NEAR(model->load_factor(), pull * handbook_load(0.3), 3e-3);
    EXPECT_EQ(result.unstable_event, 0);
    ASSERT_EQ(model->cracks().extensions().size(), 1U);
    EXPECT_EQ(model->cracks().extensions()[0].end, 0);
    EXPECT_EQ(model->cracks().extensions()[0].from_x, -0.3);
    EXPECT_NEAR(model->cracks().extensions()[0].resistance, 1, 1e-12);
    EXPECT_NEAR(state(*model).resistance.peak, 2 * 0.5 * std::abs(model->load_factor()), 1e-9);
  }
}

TEST(DrivenCracks, stay_below_their_load_without_fracture_energy_or_frozen) {
  const auto below = plate(centre), weightless = plate(centre, 1, 0), frozen = plate(centre);
  EXPECT_EQ(below->driver().advance(0.9, Goal::separation).reason, StopReason::load_factor);
  EXPECT_EQ(weightless->driver().advance(5, Goal::load_factor).events, 0);
  for (const int end : {0, 1}) frozen->growth().set_frozen(1, end, true);
  EXPECT_EQ(frozen->driver().advance(5, Goal::load_factor).events, 0);
  EXPECT_EQ(frozen->driver().advance(6, Goal::separation).reason, StopReason::no_further_event);
  EXPECT_NEAR(frozen->cracks().tips()[0].factors.x(), weightless->cracks().tips()[0].factors.x(), 1e-12);
  frozen->growth().set_frozen(1, 1, false);
  EXPECT_EQ(frozen->driver().advance(7, Goal::next_event).events, 1);
  EXPECT_EQ(frozen->cracks().extensions()[0].end, 1);
}

// Growth at a held load factor is unstable from its second event on; on the equilibrium path the tip just reaches its
// toughness at every event.
TEST(DrivenCracks, follow_the_load_factor_or_the_path_of_equilibrium) {
  const auto held = plate(centre), path = plate(centre);
  path->options().set_text("stepping.control", "path");
  double last = 1e9;
  for (int k = 0; k < 6; ++k) {
    const model::StepResult a = held->driver().advance(5, Goal::next_event),
                            b = path->driver().advance(5, Goal::next_event);
    EXPECT_EQ(a.events, 1);
    EXPECT_EQ(b.events, 1);
    EXPECT_NEAR(held->load_factor(), handbook_load(0.3), 3e-3);
    EXPECT_EQ(a.unstable_event, k == 0 ? 0 : k + 1);
    EXPECT_EQ(b.unstable_event, 0);
    EXPECT_LT(path->load_factor(), last);
    last = path->load_factor();
    EXPECT_NEAR(path->cracks().extensions()[static_cast<std::size_t>(k)].rate_before, 1, 1e-9);
  }
  // The largest ratio goes first: the tip that has grown is nearer to its side.
  for (const fracture::CrackExtension& e : held->cracks().extensions()) EXPECT_EQ(e.end, 0);
  for (const model::Model* model : {held.get(), path.get()}) {
    auto& one = const_cast<model::Model&>(*model);
    EXPECT_LE(state(one).worst_energy_balance_error, 1e-12);
    EXPECT_NEAR(state(one).bond_energy, 0.5 * new_length(one), 1e-12);
  }
  std::printf("path: released %.6f of %.6f\n", state(*path).released_energy, state(*path).bond_energy);
  EXPECT_NEAR(state(*path).released_energy / state(*path).bond_energy, 1, 2e-3);
  // What dead loads give beyond that would have become motion.
  EXPECT_NEAR(state(*held).released_energy / state(*held).bond_energy, 1, 2e-3);
}

// Steps of 0.14 of half the crack.
TEST(DrivenCracks, release_their_fracture_energy_at_long_steps) {
  const auto pulled = plate(centre), strip = opened_strip("path"), by_length = plate(centre);
  pulled->options().set_text("stepping.control", "path");
  pulled->options().set("crack.step", 0.14 * 0.3);
  strip->options().set("crack.step", 0.14);
  for (int k = 0; k < 4; ++k) {
    pulled->driver().advance(5, Goal::next_event);
    strip->driver().advance(5, Goal::next_event);
    by_length->growth().grow(0.14 * 0.3);
  }
  for (model::Model* model : {pulled.get(), strip.get(), by_length.get()}) {
    const double ratio = state(*model).released_energy / state(*model).bond_energy;
    std::printf("released over fracture energy times new area %.6f\n", ratio);
    EXPECT_NEAR(ratio, 1, 3e-3);
    EXPECT_LE(state(*model).worst_energy_balance_error, 1e-12);
  }
}

// A crack that has to be opened further to grow stops where it is in equilibrium.
TEST(DrivenCracks, stop_where_growth_is_stable) {
  const auto held = opened_strip("load"), path = opened_strip("path");
  const model::StepResult a = held->driver().advance(1.0, Goal::load_factor),
                          b = path->driver().advance(1.0, Goal::load_factor);
  EXPECT_EQ(a.reason, StopReason::load_factor);
  EXPECT_EQ(b.reason, StopReason::load_factor);
  EXPECT_GT(a.events, 3);
  EXPECT_EQ(a.events, b.events);
  EXPECT_EQ(a.unstable_event, 0);
  EXPECT_EQ(held->cracks().tips()[0].place, path->cracks().tips()[0].place);
  EXPECT_LE(held->cracks().tips()[0].factors.x(), held->cracks().tips()[0].toughness);
  EXPECT_GT(held->cracks().tips()[0].factors.x(), 0.8 * held->cracks().tips()[0].toughness);
}

TEST(DrivenCracks, repeat_their_steps_from_states) {
  const auto model = plate(centre), other = plate(centre);
  model->driver().advance(5, Goal::next_event);
  const model::SavedState saved = model->states().save();
  const auto three = [](model::Model& one) {
    for (int k = 0; k < 3; ++k) one.driver().advance(5, Goal::next_event);
    return std::pair(one.cracks().extensions().back().x, state(one).total_displacement);
  };
  const auto first = three(*model);
  model->states().restore(saved);
  EXPECT_EQ(model->cracks().extensions().size(), 1U);
  const auto second = three(*model);
  const std::vector<std::uint8_t> bytes = model::to_bytes(saved);
  other->states().restore(model::from_bytes(bytes.data(), bytes.size()));
  const auto third = three(*other);
  EXPECT_EQ(first.first, second.first);
  EXPECT_EQ(first.first, third.first);
  EXPECT_EQ(first.second, second.second);
  EXPECT_EQ(first.second, third.second);
}

TEST(DrivenCracks, a_cancelled_step_returns_to_its_start) {
  const auto model = plate(centre), undisturbed = plate(centre);
  model->options().set_text("stepping.control", "path");
  undisturbed->options().set_text("stepping.control", "path");
  model->options().set("tips.record", 1);
  for (model::Model* one : {model.get(), undisturbed.get()}) one->driver().advance(5, Goal::next_event);
  const Eigen::VectorXd before = state(*model).total_displacement;
  const std::size_t lines = state(*model).history.size(), recorded = model->cracks().history().size();
  int heard = 0;
  model->host().set_progress([&](double, std::int64_t, std::int64_t) { return ++heard < 3; });
  EXPECT_THROW(model->driver().advance(5, Goal::load_factor), Error);
  model->host().set_progress({});
  EXPECT_EQ(heard, 3);
  EXPECT_EQ(model->cracks().extensions().size(), 1U);
  EXPECT_EQ(state(*model).history.size(), lines);
  EXPECT_EQ(model->cracks().history().size(), recorded);
  EXPECT_EQ(state(*model).total_displacement, before);
  EXPECT_EQ(model->scene().crack(1).points.size(), 3U);
  for (model::Model* one : {model.get(), undisturbed.get()}) one->driver().advance(5, Goal::next_event);
  EXPECT_EQ(model->load_factor(), undisturbed->load_factor());
  EXPECT_EQ(state(*model).total_displacement, state(*undisturbed).total_displacement);
  // A step with too many events returns to its start, too.
  model->options().set("stepping.max_events", 2);
  try {
    model->driver().advance(5, Goal::separation);
    ADD_FAILURE() << "more events than allowed";
  } catch (const Error& error) {
    EXPECT_EQ(error.failure(), Failure::convergence);
    EXPECT_NE(std::string(error.what()).find("2 events"), std::string::npos) << error.what();
  }
  EXPECT_EQ(model->cracks().extensions().size(), 2U);
}

TEST(DrivenCracks, a_stop_that_is_asked_for_keeps_what_has_grown) {
  const auto model = plate(centre);
  model->host().set_progress([&](double, std::int64_t events, std::int64_t) {
    if (events == 2) model->host().request_stop();
    return true;
  });
  const model::StepResult result = model->driver().advance(5, Goal::separation);
  EXPECT_EQ(result.reason, StopReason::requested);
  EXPECT_EQ(result.events, 2);
  EXPECT_EQ(model->cracks().extensions().size(), 2U);
}

TEST(DrivenCracks, programs_and_ways_of_values_grow_them) {
  // The program goes up to 0.8 of the load, back through zero to a closed crack, and up to where the crack grows.
  const auto program = plate(centre), values = plate(centre);
  const scene::LoadTable table{{1, 2, 3}, {}, {0.8, -0.5, 0.99}};
  const model::StepResult result = program->driver().run_program(table, Goal::next_event);
  const double factor = -0.5 + (program->load_factor() - 2) * 1.49;
  std::printf("program: grows at time %.6f, factor %.6f\n", program->load_factor(), factor);
  EXPECT_EQ(result.events, 1);
  EXPECT_NEAR(factor, handbook_load(0.3), 3e-3);
  for (const int load : {1, 2})
    values->loads().set_load_values(load, scene::SampledValues{{load == 1 ? -2.0 : 2.0}, {0.0}});
  EXPECT_EQ(values->driver().advance_to_values(10, Goal::next_event).events, 1);
  EXPECT_NEAR(values->load_factor() / 5, factor, 1e-9);
  // The state of the body is the same in both runs.
  EXPECT_NEAR(state(*values).history.back().stored_energy, state(*program).history.back().stored_energy, 1e-9);
}

TEST(DrivenCracks, the_longest_goes_first_and_of_ties_the_first_added) {
  const std::vector<Point> longer{{-1, 1}, {-0.4, 1}}, shorter{{-1, -1}, {-0.6, -1}};
  const auto one = plate({longer, shorter}), other = plate({shorter, longer});
  // The constant load exceeds what either crack bears, at once.
  for (model::Model* model : {one.get(), other.get()}) {
    for (const int crack : {1, 2}) model->growth().set_frozen(crack, 1, true);
    model->driver().advance(2, Goal::load_factor);
    for (const int crack : {1, 2}) model->growth().set_frozen(crack, 1, false);
    model->driver().advance(2, Goal::next_event);
  }
  EXPECT_EQ(one->cracks().extensions()[0].crack, 1);
  EXPECT_EQ(other->cracks().extensions()[0].crack, 2);
  const std::vector<Point> left{{-1, 0}, {-0.6, 0}}, right{{1, 0}, {0.6, 0}};
  for (const Cracks& cracks : {Cracks{left, right}, Cracks{right, left}}) {
    const auto model = plate(cracks);
    model->driver().advance(5, Goal::next_event);
    EXPECT_EQ(model->cracks().extensions()[0].crack, 1);
  }
}

// A crack in boundary elements beside a lattice: it grows as it does where all of the body has elements.
TEST(DrivenCracks, beside_a_lattice) {
  const auto body = [](bool lattice, const Cracks& cracks) {
    auto model = std::make_unique<model::Model>();
    scene::Scene& scene = model->editable_scene();
    scene::Material material;
    material.elasticity = {1, 1.0 / 3, PlaneState::stress, 1};
    material.fracture_energy = 1;
    const int id = scene.add_material(material);
    if (lattice) {
      regions::add_boundary_region(scene, id, {{0, 0}, {24, 0}, {24, 12}, {0, 12}}, 2);
      regions::add_peridynamic_region(scene, id, {{0, 12}, {24, 12}, {24, 24}, {0, 24}}, 1, 3);
    } else {
      regions::add_boundary_region(scene, id, {{0, 0}, {24, 0}, {24, 24}, {0, 24}}, 2);
    }
    for (const std::vector<Point>& crack : cracks) scene.add_crack(crack);
    contact_bodies::hold(*model, 1, 1, 0, 0);
    contact_bodies::hold(*model, 1, 2, 0, 0);
    scene.add_support(
        {std::make_shared<const regions::EdgePart>(lattice ? 2 : 1, 3, 0, 1), 2, scene::SampledValues{{0.0}, {1.0}}});
    model->options().set_text("stepping.control", "path");
    model->options().set("crack.step", 1);
    return model;
  };
  const std::vector<Point> low{{0, 5}, {8, 5.5}}, high{{24, 18.5}, {17.5, 18.5}};
  const auto mixed = body(true, {low}), elements = body(false, {low});
  for (int k = 0; k < 5; ++k) {
    mixed->driver().advance(1e3, Goal::next_event);
    elements->driver().advance(1e3, Goal::next_event);
    const Point off = mixed->cracks().tips()[0].place - elements->cracks().tips()[0].place;
    std::printf("beside a lattice: load %.5f of elements alone, path off by %.4f\n",
                mixed->load_factor() / elements->load_factor(), off.norm());
    EXPECT_NEAR(mixed->load_factor() / elements->load_factor(), 1, 1e-2);
    EXPECT_LE(off.norm(), 0.05);
  }
  EXPECT_EQ(state(*mixed).broken_bonds, 0);
  EXPECT_LE(state(*mixed).worst_energy_balance_error, 1e-11);
  // A shorter crack in the lattice grows, too: both cracks grow in turn, and each affects the other.
  const auto both = body(true, {low, high});
  bool in_lattice = false, in_elements = false;
  for (int k = 0; k < 24; ++k) {
    const std::int64_t bonds = state(*both).broken_bonds;
    if (both->driver().advance(1e3, Goal::next_event).reason != StopReason::event) break;
    (state(*both).broken_bonds > bonds ? in_lattice : in_elements) = true;
  }
  std::printf("both: %lld bonds, %zu extensions, energy balance %.1e\n",
              static_cast<long long>(state(*both).broken_bonds), both->cracks().extensions().size(),
              state(*both).worst_energy_balance_error);
  EXPECT_TRUE(in_elements);
  EXPECT_LE(state(*both).worst_energy_balance_error, 1e-10);
  // The run goes on in the same way from a state with broken bonds and grown elements.
  const model::SavedState saved = both->states().save();
  both->driver().advance(1e3, Goal::next_event);
  const Eigen::VectorXd after = state(*both).total_displacement;
  both->states().restore(saved);
  both->driver().advance(1e3, Goal::next_event);
  EXPECT_LE((state(*both).total_displacement - after).lpNorm<Eigen::Infinity>(),
            1e-10 * after.lpNorm<Eigen::Infinity>());
}

// A tip that comes to the interface with another material can go on nowhere.
TEST(DrivenCracks, stop_before_an_interface) {
  auto model = std::make_unique<model::Model>();
  scene::Scene& scene = model->editable_scene();
  scene::Material weak, strong;
  weak.elasticity = {1, 0.3, PlaneState::stress, 1};
  weak.fracture_energy = 1;
  strong.elasticity = {2, 0.3, PlaneState::stress, 1};
  regions::add_boundary_region(scene, scene.add_material(weak), {{0, -3}, {2, -3}, {2, 3}, {0, 3}}, 0.5);
  regions::add_boundary_region(scene, scene.add_material(strong), {{2, -3}, {3, -3}, {3, 3}, {2, 3}}, 0.5);
  scene.add_crack({{0, 0}, {0.8, 0}});
  for (const int region : {1, 2})
    for (const int edge : {1, 3})
      scene.add_support({std::make_shared<const regions::EdgePart>(region, edge, 0, 1), 3,
                         scene::SampledValues{{0.0}, {edge == 1 ? 0.0 : 1.0}}});
  const model::StepResult first = model->driver().advance(10, Goal::separation);
  EXPECT_EQ(first.reason, StopReason::crack_stopped);
  EXPECT_GT(first.events, 2);
  const fracture::CrackExtension last = model->cracks().extensions().back();
  EXPECT_EQ(last.state, crack::TipState::at_interface);
  EXPECT_LT(last.x, 2);
  EXPECT_GT(last.x, 1.7);
  ASSERT_EQ(model->cracks().tips().size(), 1U);
  EXPECT_EQ(model->cracks().tips()[0].critical_load_factor, std::numeric_limits<double>::max());
  // Steps go on without that tip.
  EXPECT_EQ(model->driver().advance(11, Goal::load_factor).reason, StopReason::load_factor);
  EXPECT_EQ(model->driver().advance(12, Goal::separation).reason, StopReason::no_further_event);
}

// A refused growth leaves the model on the way on which a program has left it.
TEST(DrivenCracks, refused_growth_changes_nothing) {
  const auto model = plate(centre);
  model->driver().run_program({{1, 2}, {}, {0.5, 0.2}}, Goal::load_factor);
  for (const int end : {0, 1}) model->growth().set_frozen(1, end, true);
  const Eigen::VectorXd before = state(*model).total_displacement;
  const double work = model->prepared().evolution->records().work();
  EXPECT_THROW(model->growth().grow(0.1), Error);
  EXPECT_EQ(state(*model).total_displacement, before);
  EXPECT_EQ(model->prepared().evolution->records().work(), work);
  for (const int end : {0, 1}) model->growth().set_frozen(1, end, false);
  EXPECT_EQ(model->driver().run_program({{3, 4}, {}, {0.5, 1.0}}, Goal::next_event).events, 1);
}

}  // namespace
}  // namespace driven_cracks_test
