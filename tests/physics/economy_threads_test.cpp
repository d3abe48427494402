// The number of threads changes no bit of any result: sums are taken in the same order whoever takes them.
#include <gtest/gtest.h>

#include <cstring>

#include "fracture_scenes.hpp"

namespace economy_threads_test {
namespace {

using namespace host;

constexpr int thread_counts[] = {2, 3, 8};

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<double> fields(Model& model, int32_t region, std::initializer_list<int32_t> which) {
  std::vector<double> all;
  for (int32_t field : which) append(all, model.field(region, field));
  return all;
}

std::vector<double> torn_plate(int threads, const char* solver) {
  Model model;
  model.set("threads", threads);
  model.set_text("test.solver", solver);
  CentreCrack scene = CentreCrack::small();
  scene.horizon_ratio = 3;
  scene.element_length = 0.5;  // enough elements for the library to share them among threads
  const CentreCrackIds ids = build(model, scene);
  const bempd_step_report run = model.run(1e9);
  EXPECT_EQ(run.stop_reason, BEMPD_STOP_SEPARATED);
  std::vector<double> all;
  for (const bempd_history_entry& h : model.history()) {
    append(all, {static_cast<double>(h.event), static_cast<double>(h.total_broken_bonds), h.load_factor,
                 h.stretch_ratio, h.stored_energy, h.released_energy, h.work, h.energy_balance_error, h.residual});
  }
  for (int32_t region : {ids.left, ids.right})
    append(all, fields(model, region, {BEMPD_DISPLACEMENT, BEMPD_STRESS, BEMPD_TRACTION, BEMPD_ELEMENT_STRESS}));
  append(all, fields(model, ids.strip, {BEMPD_DISPLACEMENT, BEMPD_STRESS, BEMPD_DAMAGE, BEMPD_BOND_STRETCH}));
  for (int32_t support : {ids.left_end, ids.right_end}) {
    const Vector force = model.reaction(support);
    append(all, {force[0], force[1]});
  }
  return all;
}

// A plate with a round hole and a bonded disk of another material.
std::vector<double> round_bodies(int threads, const char* scheme) {
  Model model;
  model.set("threads", threads);
  model.set_text("scheme", scheme);
  const int32_t plate = model.add(material(3e9, 0.3)), disk = model.add(material(70e9, 0.2));
  const int32_t outer = model.bem(plate, rectangle(-2, -1.5, 2, 1.5), 0.1);
  model.circular_hole(outer, {-0.9, 0.1}, 0.4);
  model.circular_hole(outer, {0.9, 0}, 0.5);
  const int32_t inner = model.disk(disk, {0.9, 0}, 0.5, 0.1);
  model.fix(outer, 4, BEMPD_BOTH);
  model.traction(outer, 2, 0, 1, BEMPD_X, 0, 1e6);
  model.step(1);
  std::vector<double> all;
  for (int32_t region : {outer, inner})
    append(all, fields(model, region, {BEMPD_DISPLACEMENT, BEMPD_STRESS, BEMPD_TRACTION, BEMPD_ELEMENT_STRESS}));
  for (const Vector& place : {Vector{-1.6, -1}, Vector{0.9, 0.3}}) {
    const auto at = model.evaluate(place);
    append(all, {at.displacement[0], at.displacement[1], at.stress[0], at.stress[1], at.stress[2]});
  }
  return all;
}

template <class Run>
void expect_same_bits(const char* what, const Run& run) {
  const std::vector<double> reference = run(1);
  for (int threads : thread_counts) {
    const std::vector<double> other = run(threads);
    ASSERT_EQ(other.size(), reference.size()) << what << ", " << threads << " threads";
    int different = 0;
    for (std::size_t i = 0; i < other.size(); ++i)
      different += std::memcmp(&other[i], &reference[i], sizeof(double)) != 0;
    std::printf("%s, %d threads: %d of %zu numbers differ from one thread\n", what, threads, different, other.size());
    EXPECT_EQ(different, 0);
  }
}

TEST(Threads, do_not_change_a_bit_of_a_plate_torn_in_two) {
  for (const char* solver : {"plain", "window"})
    expect_same_bits(solver, [solver](int threads) { return torn_plate(threads, solver); });
}

TEST(Threads, do_not_change_a_bit_of_round_bodies) {
  for (const char* scheme : all_schemes())
    expect_same_bits(scheme, [scheme](int threads) { return round_bodies(threads, scheme); });
}

}  // namespace
}  // namespace economy_threads_test
