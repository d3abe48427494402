// Lets allocations of the library fail in turn, and prints what came of it. Each program runs in a process of its own,
// so that one that crashes, exits or hangs is counted, and the next failure is tried.
//
//   failing_allocations [--most COUNT] [--program NAME]    COUNT failures a call, 0 for all
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>

#include "trial.hpp"

namespace {

using namespace memory_test;

constexpr unsigned longest_call = 120;  // seconds that a trial may go without a further failure

struct Outcomes {
  std::int64_t failed = 0, told = 0, went_on = 0, spared = 0, bad = 0, signals = 0, exits = 0, hangs = 0;

  void add(const Progress& p) {
    failed += p.failed, told += p.told, went_on += p.went_on, spared += p.spared;
    bad += p.wrong_status + p.lost + p.other_numbers + p.leaked + p.silent;
  }
  std::int64_t all_bad() const { return bad + signals + exits + hangs; }
};

void describe_end(const Program& program, const Progress& progress, int status, Outcomes& outcomes) {
  const char* how = "";
  int number = 0;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) {
    ++outcomes.hangs, how = "hung, killed by signal", number = SIGKILL;
  } else if (WIFSIGNALED(status)) {
    ++outcomes.signals, how = "ended by signal", number = WTERMSIG(status);
  } else {
    ++outcomes.exits, how = "ended the process with", number = WEXITSTATUS(status);
  }
  std::printf("%s, %s (call %zu), allocation %lld: %s %d\n", program.name, program.calls[progress.call].name,
              progress.call, static_cast<long long>(progress.allocation), how, number);
}

// Waits for a process that goes on making progress.
int wait_for(pid_t child, const Progress& progress) {
  int status = 0;
  std::size_t call = 0, position = 0;
  for (unsigned quiet = 0; waitpid(child, &status, WNOHANG) == 0;) {
    usleep(20000);
    const bool moved = call != progress.call || position != progress.position;
    call = progress.call, position = progress.position;
    quiet = moved ? 0 : quiet + 1;
    if (quiet > 50 * longest_call) kill(child, SIGKILL);
  }
  return status;
}

void run(const Program& program, const Plan& plan, const std::string& folder, Outcomes& outcomes) {
  void* const shared = mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) std::abort();
  auto* const progress = new (shared) Progress;
  for (int crashes = 0; !progress->finished && crashes < 50; ++crashes) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      run_trial(program, plan, folder, *progress);
      std::fflush(stdout);
      _exit(0);
    }
    const int status = wait_for(child, *progress);
    if (progress->finished) break;
    describe_end(program, *progress, status, outcomes);
    ++progress->failed;
  }
  if (!progress->finished) std::printf("%s: given up\n", program.name);
  outcomes.add(*progress);
  std::printf("%-9s %-13s %8lld failed: %8lld told, %6lld went on; %lld in libgomp or OpenBLAS spared\n", program.name,
              plan.mode == allocation::Mode::once ? "once" : "from then on", static_cast<long long>(progress->failed),
              static_cast<long long>(progress->told), static_cast<long long>(progress->went_on),
              static_cast<long long>(progress->spared));
  munmap(shared, sizeof(Progress));
}

}  // namespace

int main(int argc, char** argv) {
  Plan plan;
  plan.most_per_call = 20;
  const char* wanted = nullptr;
  for (int k = 1; k + 1 < argc; k += 2) {
    if (std::strcmp(argv[k], "--most") == 0) plan.most_per_call = std::atoll(argv[k + 1]);
    if (std::strcmp(argv[k], "--program") == 0) wanted = argv[k + 1];
  }
  std::string folder = (std::filesystem::temp_directory_path() / "bempd_memory_XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return EXIT_FAILURE;
  Outcomes outcomes;
  for (const Program& program : all_programs()) {
    if (wanted != nullptr && std::strcmp(wanted, program.name) != 0) continue;
    for (const allocation::Mode mode : {allocation::Mode::once, allocation::Mode::from_then_on}) {
      plan.mode = mode;
      run(program, plan, folder, outcomes);
    }
  }
  std::filesystem::remove_all(folder);
  std::printf(
      "allocations failed %lld: BEMPD_ERROR_MEMORY %lld, went on %lld; signals %lld, exits %lld, hangs %lld, "
      "other findings %lld\n",
      static_cast<long long>(outcomes.failed), static_cast<long long>(outcomes.told),
      static_cast<long long>(outcomes.went_on), static_cast<long long>(outcomes.signals),
      static_cast<long long>(outcomes.exits), static_cast<long long>(outcomes.hangs),
      static_cast<long long>(outcomes.bad));
  return outcomes.failed > 0 && outcomes.all_bad() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
