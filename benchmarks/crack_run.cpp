// A square plate of N x N material points with a central crack of 0.2 N rows, torn apart bond by bond by its gripped
// ends until it carries a thousandth of its largest force: the whole run over one elastic solve, and where the time
// goes.
//   bempd_crack_run N [solver] [tie band] [window length] [file for the sequence of events]
#include <bempd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void check(const bempd_model* model, bempd_status status) {
  if (status != BEMPD_OK) throw std::runtime_error(bempd_last_error(model));
}

// Spacing 1, E = 1, nu = 1/3, plane stress, horizon ratio 4; the columns at both ends are held in x and y. The crack
// runs along y, midway between two columns where N is even, and ends midway between two rows.
bempd_model* plate(int n) {
  bempd_model* model = nullptr;
  check(nullptr, bempd_model_create(&model));
  check(model, bempd_set_option_text(model, "crack.rule", "bond"));
  bempd_material material;
  check(nullptr, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1;
  material.poisson_ratio = 1.0 / 3;
  material.critical_stretch = 1e-3;
  check(model, bempd_add_material(model, &material, nullptr));
  const double side = n - 1;
  const double corners[] = {0, 0, side, 0, side, side, 0, side};
  check(model, bempd_add_pd_region(model, 1, 4, corners, 1, 4, nullptr));
  const double rows = std::floor(0.2 * n), middle = 0.5 * side, x = std::floor(middle) + 0.5;
  const double low = std::ceil(middle - 0.5 * rows) - 0.5, high = low + rows;
  const double crack[] = {x, low + 1e-6, x, high - 1e-6};
  check(model, bempd_add_crack(model, 2, crack, nullptr));
  const double left = -1, right = 1, held = 0;
  check(model, bempd_prescribe_edge(model, 1, 4, 0, 1, BEMPD_X, 1, nullptr, &left, nullptr));
  check(model, bempd_prescribe_edge(model, 1, 4, 0, 1, BEMPD_Y, 1, nullptr, &held, nullptr));
  check(model, bempd_prescribe_edge(model, 1, 2, 0, 1, BEMPD_X, 1, nullptr, &right, nullptr));
  check(model, bempd_prescribe_edge(model, 1, 2, 0, 1, BEMPD_Y, 1, nullptr, &held, nullptr));
  return model;
}

bempd_statistics statistics(const bempd_model* model) {
  bempd_statistics result;
  check(nullptr, bempd_statistics_init(&result, sizeof result));
  check(model, bempd_get_statistics(model, &result));
  return result;
}

bempd_history_entry last_line(const bempd_model* model) {
  int64_t count = 0;
  bempd_history_entry line;
  check(model, bempd_history_count(model, &count));
  check(nullptr, bempd_history_entry_init(&line, sizeof line));
  check(model, bempd_history(model, count - 1, &line));
  return line;
}

void print_stages(const char* name, double seconds, const bempd_statistics& s) {
  std::printf("%s %.4f s: lattice %.4f assembly %.4f factorization %.4f (%lld) solve %.4f (%lld) update %.4f\n", name,
              seconds, s.seconds_lattice, s.seconds_assembly, s.seconds_factorization,
              static_cast<long long>(s.sparse_factorizations), s.seconds_solve, static_cast<long long>(s.solves),
              s.seconds_update);
}

double elastic_solve(int n) {
  const double start = now();
  bempd_model* model = plate(n);
  check(model, bempd_step(model, 1e-9, nullptr));
  const double seconds = now() - start;
  print_stages("elastic solve", seconds, statistics(model));
  bempd_model_free(model);
  return seconds;
}

double crack_run(int n, const char* solver, double band, double length, const char* file) {
  const double start = now();
  bempd_model* model = plate(n);
  check(model, bempd_set_option_text(model, "test.solver", solver));
  check(model, bempd_set_option(model, "crack.tie_share", band));
  check(model, bempd_set_option(model, "test.window_length", length));
  bempd_step_report report;
  check(nullptr, bempd_step_report_init(&report, sizeof report));
  double largest_unit_force = 0;
  do {
    check(model, bempd_step_to_next_event(model, 1e9, &report));
    // The opening per load factor is the same all the way, so energy over its square falls as force per opening does.
    const bempd_history_entry line = last_line(model);
    const double unit_force = line.stored_energy / (line.load_factor * line.load_factor);
    largest_unit_force = std::fmax(largest_unit_force, unit_force);
    if (unit_force < 1e-3 * largest_unit_force) break;
  } while (report.stop_reason == BEMPD_STOP_EVENT);
  const double seconds = now() - start;
  print_stages("whole run    ", seconds, statistics(model));
  std::printf("%s: %lld events, %lld bonds, residual %.2g, energy balance %.2g\n", solver,
              static_cast<long long>(report.total_events), static_cast<long long>(report.total_broken_bonds),
              report.residual, report.energy_balance_error);
  if (file) check(model, bempd_write_history(model, file));
  bempd_model_free(model);
  return seconds;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const int n = count > 1 ? std::atoi(arguments[1]) : 100;
    const char* solver = count > 2 ? arguments[2] : "window";
    const double band = count > 3 ? std::atof(arguments[3]) : 1e-3;
    const double length = count > 4 ? std::atof(arguments[4]) : 0;
    double elastic = 1e300, whole = 1e300;
    for (int repeat = 0; repeat < (n > 150 ? 1 : 3); ++repeat) {
      elastic = std::fmin(elastic, elastic_solve(n));
      whole = std::fmin(whole, crack_run(n, solver, band, length, count > 5 ? arguments[5] : nullptr));
    }
    std::printf("N %d, band %g: whole run %.4f s, elastic solve %.4f s, ratio %.2f\n", n, band, whole, elastic,
                whole / elastic);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
