// How long it takes until a request to stop is heard: a run is stopped at many moments, each in a fresh model, and the
// processor time between request and return is measured.
//   bempd_cancellation_delay lattice N [moments]    plate of N x N points with a crack, prepared and run to separation
//   bempd_cancellation_delay plain N [moments]      the same without windows
//   bempd_cancellation_delay first N [moments]      the same, to the first bonds that break
//   bempd_cancellation_delay line N [moments]       the same with a crack that grows as a line
//   bempd_cancellation_delay boundary N [moments]   square of N elements, prepared and one step
//   bempd_cancellation_delay paper N [moments]      the same two side by side in scheme paper, N elements and N / 4
//   rows
// With the word stop behind the number of moments, runs are asked to end and to keep their events instead.
#include <bempd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

// Processor time of this process: other programs on the machine do not count.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void check(const bempd_model* model, bempd_status status) {
  if (status != BEMPD_OK) throw std::runtime_error(bempd_last_error(model));
}

std::string phase;          // what the log said last
bool keeps_events = false;  // whether runs are asked to end, not cancelled

void listen(int32_t, const char* message, void*) { phase = message; }

bempd_model* empty_model() {
  bempd_model* model = nullptr;
  check(nullptr, bempd_model_create(&model));
  bempd_material material;
  check(nullptr, bempd_material_init(&material, sizeof material));
  material.young_modulus = 1;
  material.poisson_ratio = 1.0 / 3;
  material.critical_stretch = 1e-3;
  check(model, bempd_add_material(model, &material, nullptr));
  check(model, bempd_set_option(model, "threads", 1));
  check(model, bempd_set_option_text(model, "crack.rule", "bond"));
  check(model, bempd_set_log(model, &listen, nullptr));
  return model;
}

void pull(bempd_model* model, int32_t right) {
  const double one = 1;
  check(model, bempd_fix_edge(model, 1, 4, BEMPD_BOTH, nullptr));
  check(model, bempd_prescribe_edge(model, right, 2, 0, 1, BEMPD_X, 1, nullptr, &one, nullptr));
}

void add_lattice(bempd_model* model, int n) {
  const double side = n, x = std::floor(0.5 * side) + 0.5, high = std::floor(0.2 * side) + 0.5;
  const double corners[] = {0, 0, side, 0, side, side, 0, side}, crack[] = {x, 0, x, high};
  check(model, bempd_add_pd_region(model, 1, 4, corners, 1, 3, nullptr));
  check(model, bempd_add_crack(model, 2, crack, nullptr));
  pull(model, 1);
}

bempd_status lattice(bempd_model* model, int n) {
  add_lattice(model, n);
  return bempd_run_to_separation(model, 1e9, nullptr);
}

bempd_status plain(bempd_model* model, int n) {
  check(model, bempd_set_option_text(model, "test.solver", "plain"));
  return lattice(model, n);
}

bempd_status first(bempd_model* model, int n) {
  add_lattice(model, n);
  return bempd_step_to_next_event(model, 1e9, nullptr);
}

bempd_status line(bempd_model* model, int n) {
  check(model, bempd_set_option_text(model, "crack.rule", "line"));
  return lattice(model, n);
}

bempd_status boundary(bempd_model* model, int n) {
  const double corners[] = {0, 0, 1, 0, 1, 1, 0, 1};
  check(model, bempd_add_bem_region(model, 1, 4, corners, 4.0 / n, nullptr));
  pull(model, 1);
  return bempd_step(model, 1, nullptr);
}

bempd_status paper(bempd_model* model, int n) {
  const double rows = std::floor(0.25 * n), x = std::floor(0.5 * rows) + 0.5;
  const double body[] = {0, 0, rows, 0, rows, rows, 0, rows};
  const double strip[] = {rows, 0, 2 * rows, 0, 2 * rows, rows, rows, rows};
  const double crack[] = {rows + x, 0, rows + x, std::floor(0.2 * rows)};
  check(model, bempd_set_option_text(model, "scheme", "paper"));
  check(model, bempd_add_bem_region(model, 1, 4, body, 1, nullptr));
  check(model, bempd_add_pd_region(model, 1, 4, strip, 1, 3, nullptr));
  check(model, bempd_add_crack(model, 2, crack, nullptr));
  pull(model, 2);
  return bempd_run_to_separation(model, 1e9, nullptr);
}

using Run = std::function<bempd_status(bempd_model*)>;

// Seconds that a run takes, or, where it is stopped after some, seconds until it returns from then on.
double measure(const Run& run, double stop_after) {
  bempd_model* model = empty_model();
  std::atomic<bool> returned{false};
  std::atomic<double> asked{0};
  phase = "before anything is prepared";
  const double start = processor_time();
  std::thread other([&] {
    while (!returned) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      if (processor_time() - start < stop_after) continue;
      if (asked == 0) asked = processor_time();
      // Requests are repeated, because one before the call is forgotten.
      if (keeps_events)
        bempd_request_stop(model);
      else
        bempd_request_cancel(model);
    }
  });
  const bempd_status status = run(model);
  const double end = processor_time();
  returned = true;
  other.join();
  const bool stopped = keeps_events ? asked > 0 : status == BEMPD_ERROR_CANCELLED;
  if (status != BEMPD_OK && status != BEMPD_ERROR_CANCELLED) std::printf("%s\n", bempd_last_error(model));
  bempd_model_free(model);
  if (std::isinf(stop_after)) return end - start;
  return stopped ? end - asked : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return EXIT_FAILURE;
  const std::string kind = argv[1];
  const int size = std::atoi(argv[2]), moments = argc > 3 ? std::atoi(argv[3]) : 20;
  keeps_events = argc > 4 && std::string(argv[4]) == "stop";
  const std::map<std::string, bempd_status (*)(bempd_model*, int)> kinds = {{"lattice", &lattice},   {"plain", &plain},
                                                                            {"first", &first},       {"line", &line},
                                                                            {"boundary", &boundary}, {"paper", &paper}};
  const auto found = kinds.find(kind);
  if (found == kinds.end()) return EXIT_FAILURE;
  const Run run = [&](bempd_model* model) { return found->second(model, size); };
  const double whole = measure(run, INFINITY);
  std::printf("%s %d: %.2f s\n", kind.c_str(), size, whole);
  std::vector<double> delays;
  for (int k = 0; k < moments; ++k) {
    const double moment = whole * (k + 0.5) / moments;
    delays.push_back(measure(run, moment));
    std::printf("  stopped after %7.2f s: heard within %.3f s (%s)\n", moment, delays.back(), phase.c_str());
    std::fflush(stdout);
  }
  std::sort(delays.begin(), delays.end());
  std::printf("%s %d: median %.3f s, largest %.3f s of %d\n", kind.c_str(), size, delays[delays.size() / 2],
              delays.back(), moments);
}
