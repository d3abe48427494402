// A host that the system gives little memory: below what a run needs, it is told so, and goes on once there is more.
#include <bempd.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace {

constexpr unsigned longest_run = 30;  // seconds
constexpr rlim_t megabyte = 1 << 20;

enum Outcome { done = 0, told_and_done = 10, wrong_status = 11, other_numbers = 12 };

rlim_t address_space() {
  std::ifstream file("/proc/self/statm");
  rlim_t pages = 0;
  file >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void limit_address_space(rlim_t bytes) {
  const rlimit limit{bytes, RLIM_INFINITY};
  if (setrlimit(RLIMIT_AS, &limit) != 0) std::abort();
}

bempd_model* scene() {
  bempd_model* model = nullptr;
  bempd_material material;
  if (bempd_model_create(&model) != BEMPD_OK || bempd_material_init(&material, sizeof material) != BEMPD_OK)
    return nullptr;
  material.young_modulus = 1000;
  material.poisson_ratio = 1.0 / 3;
  material.critical_stretch = 1e-3;
  const double lattice[] = {0, 0, 140, 0, 140, 100, 0, 100}, body[] = {140, 0, 240, 0, 240, 100, 140, 100};
  const double crack[] = {70.5, 0, 70.5, 20.5}, one = 1;
  bempd_add_material(model, &material, nullptr);
  bempd_add_pd_region(model, 1, 4, lattice, 1, 3, nullptr);
  bempd_add_bem_region(model, 1, 4, body, 1, nullptr);
  bempd_add_crack(model, 2, crack, nullptr);
  bempd_fix_edge(model, 1, 4, BEMPD_BOTH, nullptr);
  bempd_prescribe_edge(model, 2, 2, 0, 1, BEMPD_X, 1, nullptr, &one, nullptr);
  return model;
}

// Runs until a few bonds have broken, and tells the load factor then.
bempd_status run(bempd_model* model, double& load_factor) {
  bempd_step_report report;
  bempd_step_report_init(&report, sizeof report);
  const bempd_status status = bempd_step_to_next_event(model, 1e9, &report);
  load_factor = report.load_factor;
  return status;
}

Outcome run_within(rlim_t spare, double known) {
  limit_address_space(address_space() + spare);
  bempd_model* model = scene();
  double load_factor = 0;
  bempd_status status = model == nullptr ? BEMPD_ERROR_MEMORY : run(model, load_factor);
  const bool told = status == BEMPD_ERROR_MEMORY;
  limit_address_space(RLIM_INFINITY);
  if (told) {
    if (model == nullptr) return told_and_done;
    // Parts of the scene may be missing where memory ended that early.
    int32_t regions = 0;
    bempd_region_count(model, &regions);
    if (regions < 2) return told_and_done;
    status = run(model, load_factor);
  }
  if (status != BEMPD_OK) {
    std::printf("%s ", bempd_last_error(model));
    return wrong_status;
  }
  if (!std::isnan(known) && !(std::abs(load_factor - known) <= 1e-9 * known)) return other_numbers;
  bempd_model_free(model);
  return told ? told_and_done : done;
}

// Runs `work` in a process of its own; its end as waitpid() tells it.
template <class Work>
int in_a_process(const Work& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    alarm(longest_run);
    const Outcome outcome = work();
    std::fflush(stdout);
    _exit(outcome);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

// The first call already lacks memory, even for the buffer that OpenBLAS takes once.
bool first_call_is_told() {
  const int status = in_a_process([] { return run_within(100 * megabyte, std::nan("")); });
  const bool good = WIFEXITED(status) && WEXITSTATUS(status) == told_and_done;
  std::printf("100 MB to spare for the first call: %s\n", good ? "told, and done with more" : "hung or failed");
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  const bool every_one = argc > 1 && std::string(argv[1]) == "all";
  if (!first_call_is_told()) return EXIT_FAILURE;
  double known = 0;
  bempd_model* model = scene();
  if (run(model, known) != BEMPD_OK) return EXIT_FAILURE;
  bempd_model_free(model);
  int bad = 0, told = 0, all_done = 0;
  for (rlim_t spare = 0; spare <= 640; spare += every_one ? 8 : 160) {
    const int status = in_a_process([&] { return run_within(spare * megabyte, known); });
    const bool ended_well = WIFEXITED(status) && (WEXITSTATUS(status) == done || WEXITSTATUS(status) == told_and_done);
    const char* const what = WIFSIGNALED(status)                    ? WTERMSIG(status) == SIGALRM ? "hung" : "signal"
                             : WEXITSTATUS(status) == done          ? "done"
                             : WEXITSTATUS(status) == told_and_done ? "told, and done with more"
                             : WEXITSTATUS(status) == wrong_status  ? "wrong status"
                             : WEXITSTATUS(status) == other_numbers ? "other numbers"
                                                                    : "ended the process";
    std::printf("%4llu MB to spare: %s\n", static_cast<unsigned long long>(spare), what);
    bad += ended_well ? 0 : 1;
    told += ended_well && WEXITSTATUS(status) == told_and_done ? 1 : 0;
    all_done += ended_well && WEXITSTATUS(status) == done ? 1 : 0;
  }
  std::printf("%d done, %d told of missing memory and done with more, %d otherwise\n", all_done, told, bad);
  return bad == 0 && told > 0 && all_done > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
