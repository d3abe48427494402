// Stages of the centre-cracked plate of examples/centre_crack, by lattice spacing: one elastic solve, and the run to
// separation. Ratios taken in one run are what counts; seconds depend on the machine.
//   cmake --preset release -D BEMPD_BUILD_BENCHMARKS=ON && cmake --build --preset release --target bempd_benchmark
#include <bempd.h>
#include <benchmark/benchmark.h>

#include <stdexcept>

namespace {

void check(const bempd_model* model, bempd_status status) {
  if (status != BEMPD_OK) throw std::runtime_error(bempd_last_error(model));
}

class Plate {
 public:
  // The spacing [m] must divide 8.5 mm and 49.5 mm, and keep points off the crack at mid width.
  explicit Plate(double spacing) {
    check(nullptr, bempd_model_create(&model_));
    check(model_, bempd_set_option_text(model_, "crack.rule", "bond"));
    bempd_material material;
    check(nullptr, bempd_material_init(&material, sizeof material));
    material.young_modulus = 30e9;
    material.poisson_ratio = 1.0 / 3;
    material.critical_stretch = 8e-4;
    check(model_, bempd_add_material(model_, &material, nullptr));
    add_bem(0, 20.75e-3);
    const double strip[] = {20.75e-3, 0, 29.25e-3, 0, 29.25e-3, 49.5e-3, 20.75e-3, 49.5e-3};
    check(model_, bempd_add_pd_region(model_, 1, 4, strip, spacing, 4, nullptr));
    add_bem(29.25e-3, 50e-3);
    const double crack[] = {25e-3, 19.75e-3 + 1e-6, 25e-3, 29.75e-3 - 1e-6};
    check(model_, bempd_add_crack(model_, 2, crack, nullptr));
    const double left = -2e-8, right = 2e-8;
    check(model_, bempd_prescribe_edge(model_, 1, 4, 0, 1, BEMPD_X, 1, nullptr, &left, nullptr));
    check(model_, bempd_prescribe_edge(model_, 3, 2, 0, 1, BEMPD_X, 1, nullptr, &right, nullptr));
    check(model_, bempd_fix_point(model_, 0, 24.75e-3, BEMPD_Y, nullptr));
  }
  ~Plate() { bempd_model_free(model_); }
  Plate(const Plate&) = delete;
  Plate& operator=(const Plate&) = delete;

  void solve() { check(model_, bempd_step(model_, 1, nullptr)); }
  bempd_step_report tear() {
    bempd_step_report report;
    check(nullptr, bempd_step_report_init(&report, sizeof report));
    check(model_, bempd_run_to_separation(model_, 1e4, &report));
    return report;
  }
  bempd_statistics statistics() const {
    bempd_statistics result;
    check(nullptr, bempd_statistics_init(&result, sizeof result));
    check(model_, bempd_get_statistics(model_, &result));
    return result;
  }

 private:
  void add_bem(double x0, double x1) {
    const double vertices[] = {x0, 0, x1, 0, x1, 49.5e-3, x0, 49.5e-3};
    check(model_, bempd_add_bem_region(model_, 1, 4, vertices, 5e-3, nullptr));
  }
  bempd_model* model_ = nullptr;
};

double spacing_of(const benchmark::State& state) { return 8.5e-3 / static_cast<double>(state.range(0)); }

void elastic_solve(benchmark::State& state) {
  bempd_statistics last{};
  for (auto _ : state) {
    Plate plate(spacing_of(state));
    plate.solve();
    last = plate.statistics();
  }
  state.counters["unknowns"] = static_cast<double>(last.sparse_unknowns);
  state.counters["boundary_ms"] = 1e3 * last.seconds_boundary;
  state.counters["lattice_ms"] = 1e3 * last.seconds_lattice;
  state.counters["assembly_ms"] = 1e3 * last.seconds_assembly;
  state.counters["factor_ms"] = 1e3 * last.seconds_factorization;
  state.counters["solve_ms"] = 1e3 * last.seconds_solve;
}
BENCHMARK(elastic_solve)->Arg(17)->Arg(51)->Unit(benchmark::kMillisecond);

void crack_run(benchmark::State& state) {
  bempd_step_report last{};
  for (auto _ : state) {
    Plate plate(spacing_of(state));
    last = plate.tear();
  }
  state.counters["events"] = static_cast<double>(last.total_events);
  state.counters["bonds"] = static_cast<double>(last.total_broken_bonds);
  state.counters["solve_ms"] = 1e3 * last.seconds_solve;
  state.counters["update_ms"] = 1e3 * last.seconds_update;
  state.counters["search_ms"] = 1e3 * last.seconds_search;
}
BENCHMARK(crack_run)->Arg(17)->Unit(benchmark::kMillisecond);

}  // namespace
