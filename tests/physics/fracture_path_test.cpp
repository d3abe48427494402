// The centre-cracked plate run to separation: where the crack goes and whether forces and energies balance on the way.
#include <gtest/gtest.h>

#include "fracture_scenes.hpp"

namespace fracture_path_test {
namespace {

using namespace host;

// One run serves several questions.
struct WholeRun {
  CentreCrack scene;
  BondModel model;
  CentreCrackIds ids = build(model, scene);
  bempd_step_report end = model.run(1000);
};

class CrackPath : public testing::Test {
 protected:
  static void SetUpTestSuite() { run = std::make_unique<WholeRun>(); }
  static void TearDownTestSuite() { run.reset(); }
  static std::unique_ptr<WholeRun> run;
};
std::unique_ptr<WholeRun> CrackPath::run;

TEST_F(CrackPath, the_plate_separates) {
  EXPECT_EQ(run->end.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_EQ(run->end.separated, 1);
  std::printf("events %lld, broken bonds %lld\n", static_cast<long long>(run->end.total_events),
              static_cast<long long>(run->end.total_broken_bonds));
  const double increment = std::ceil(run->end.load_factor);
  report("increment of complete separation", increment, 316, "prototype, worst bonds first");
  report("increment of complete separation", increment, 308, "prototype, breaking all critical bonds at once");
  EXPECT_GE(run->end.load_factor, 278.6);
  EXPECT_TRUE(all_finite(run->model.displacements()));
}

// Places in half lattice spacings: the two columns of points beside the line are at -1 and 1.
TEST_F(CrackPath, the_crack_is_one_crisp_line_to_both_edges) {
  const BondSets sets = bond_sets(run->model, run->scene, run->ids);
  const auto crosses = [](const BondKey& b) { return (b[0] < 0) != (b[2] < 0); };
  // Bonds beside the line part too: those along the pull next to the tip are as stretched as those across it. They stay
  // in the two columns of points next to the line, but for the corner points where the crack leaves the plate, and
  // every point keeps a hold on its own side.
  const auto beside = [&](const BondKey& b) { return !crosses(b); };
  const auto at_the_exit = [](const BondKey& b) { return std::max(std::abs(b[1]), std::abs(b[3])) == 99; };
  const auto stray = [&](const BondKey& b) {
    const int reach = std::max(std::abs(b[0]), std::abs(b[2]));
    return beside(b) && (at_the_exit(b) ? reach > 7 : reach > 5 || b[1] != b[3]);
  };
  const auto astray = std::count_if(sets.parted.begin(), sets.parted.end(), stray);
  std::printf("parted bonds beside the line: %lld of %zu\n",
              static_cast<long long>(std::count_if(sets.parted.begin(), sets.parted.end(), beside)),
              sets.parted.size());
  EXPECT_EQ(run->end.fragments, 0);
  const auto bridging = std::count_if(sets.intact.begin(), sets.intact.end(), crosses);
  EXPECT_EQ(report("parted bonds away from the line", static_cast<double>(astray), 0, "mode I, symmetry"), 0);
  EXPECT_EQ(report("intact bonds across the line", static_cast<double>(bridging), 0, "separation"), 0);
}

TEST_F(CrackPath, the_broken_bonds_are_symmetric) {
  const std::set<BondKey> parted = bond_sets(run->model, run->scene, run->ids).parted;
  EXPECT_EQ(parted, mirrored(parted, true));
  EXPECT_EQ(parted, mirrored(parted, false));
}

TEST_F(CrackPath, energy_balances_at_every_event) {
  const auto history = run->model.history();
  EXPECT_EQ(static_cast<int64_t>(events(run->model).size()), run->end.total_events);
  double released = 0, largest_work = 0, worst = 0;
  for (const bempd_history_entry& line : history) {
    EXPECT_GE(line.released_energy, released);
    released = line.released_energy;
    largest_work = std::max(largest_work, line.work);
    worst = largest({worst, (line.work - line.stored_energy - line.released_energy) / largest_work});
  }
  EXPECT_LE(report("energy balance, worst event", worst, 0, "first law"), 1e-8);
  EXPECT_LE(report("energy balance as reported", worst_energy_balance(run->model), 0, "first law"), 1e-8);
  EXPECT_LE(report("stored energy at the end", run->end.stored_energy / largest_work, 0, "no resistance left"), 1e-8);
}

TEST_F(CrackPath, forces_balance_after_the_last_event) {
  EXPECT_LE(report("residual", run->end.residual, 0, "equilibrium"), 1e-9);
  for (const bempd_history_entry& line : run->model.history()) EXPECT_LE(line.residual, 1e-9) << "event " << line.event;
}

// A state without a factorization makes a new model factorize afresh what a run without interruption has updated bond
// by bond.
TEST_F(CrackPath, updated_factors_answer_as_fresh_ones) {
  if (std::string(bempd_build_info()).find("eigen") != std::string::npos)
    GTEST_SKIP() << "this backend updates no factor, and its fresh ones take minutes here";
  BondModel updated, first, second, third;
  for (Model* model : {&updated, &first, &second, &third}) build(*model, run->scene);
  int64_t done = 0;
  const auto go = [](Model& model, int64_t events) {
    for (; events > 0; --events) ASSERT_EQ(model.next_event(1000).stop_reason, BEMPD_STOP_EVENT);
  };
  const auto compare_one_event_later = [&](Model& source, Model& fresh, int64_t stop) {
    source.set_text("test.factorization", "fresh");
    go(source, 1);
    fresh.restore(source.save());
    ASSERT_EQ(fresh.next_event(1000).total_events, stop);
    go(updated, stop - done);
    done = stop;
    const std::vector<double> u = updated.displacements();
    std::printf("after %lld events: ", static_cast<long long>(stop));
    const double difference = largest_difference(u, fresh.displacements()) / largest(u);
    EXPECT_LE(report("largest difference of u", difference, 0, "fresh factorization"), 1e-8);
  };
  const int64_t half = run->end.total_events / 2, last = run->end.total_events - 1;
  go(first, half - 2);
  compare_one_event_later(first, second, half);
  go(second, last - 2 - half);
  compare_one_event_later(second, third, last);

  const bempd_step_report end = third.run(1000);
  EXPECT_EQ(end.total_broken_bonds, run->end.total_broken_bonds);
  EXPECT_EQ(end.stop_reason, BEMPD_STOP_SEPARATED);
  EXPECT_LE(report("energy balance to the end", end.energy_balance_error, 0, "first law"), 1e-8);
}

// A crack that runs at a body which cannot break has to turn, and the host is told.
TEST(Interface, breaks_that_reach_a_boundary_element_region_are_warned_of) {
  for (bool runs_at_it : {true, false}) {
    BondModel model;
    const int32_t id = model.add(material(30e9, 1.0 / 3, BEMPD_PLANE_STRESS, 1, 8e-4));
    const int32_t lattice = model.pd(id, rectangle(0, 0, 12, 20), 1, 3);
    const int32_t block = model.bem(id, rectangle(12, 0, 24, 20), 4);
    if (runs_at_it) {
      model.crack({{0, 10.5}, {8.5, 10.5}});
    } else {
      model.crack({{4.5, 0}, {4.5, 12.5}});
    }
    std::vector<std::string> lines;
    const auto keep = [](int32_t, const char* line, void* user) {
      static_cast<std::vector<std::string>*>(user)->emplace_back(line);
    };
    model.check(bempd_set_log(model.get(), keep, &lines));
    if (runs_at_it) {
      for (const auto& [region, edge] : {std::pair{lattice, 1}, {block, 1}}) model.fix(region, edge, BEMPD_BOTH);
      for (const auto& [region, edge] : {std::pair{lattice, 3}, {block, 3}})
        model.prescribe(region, edge, BEMPD_Y, 0, 1e-3);
    } else {
      model.fix(lattice, 4, BEMPD_BOTH);
      model.prescribe(block, 2, BEMPD_X, 0, 1e-3);
    }
    model.run(1e4);
    const auto warns = [](const std::string& line) { return line.find("cannot go on into") != std::string::npos; };
    const auto told = std::find_if(lines.begin(), lines.end(), warns);
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(), warns), runs_at_it ? 1 : 0);
    if (runs_at_it && told != lines.end()) {
      EXPECT_NE(told->find("regions 1 and 2 meet, at (12, "), std::string::npos) << *told;
    }
  }
}

}  // namespace
}  // namespace fracture_path_test
