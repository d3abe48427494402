#include "trial.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace memory_test {

namespace {

// Relative difference allowed after a failure: systems are then factorized anew, so the last digits may differ.
constexpr double rounding = 1e-8;

struct Undisturbed {
  std::vector<std::int64_t> allocations;     // of each call
  std::vector<std::vector<double>> results;  // of each call
  std::vector<double> books;
  std::int64_t blocks_left = 0;
};

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  double scale = 0;
  for (double value : a) scale = std::max(scale, std::abs(value));
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(a[i] - b[i]) <= rounding * scale)) return false;
  return true;
}

std::vector<double> result_of(const Call& call, Host& host) {
  return call.result ? call.result(host) : std::vector<double>{};
}

class Trial {
 public:
  Trial(const Program& program, const Plan& plan, const std::string& folder, Progress& progress)
      : program_(program), plan_(plan), folder_(folder), progress_(progress) {}

  void run() {
    run_undisturbed();  // what libraries keep for good is taken here
    run_undisturbed();
    build(progress_.call);
    for (; progress_.call < program_.calls.size(); ++progress_.call, progress_.position = 0) disturb(progress_.call);
    const std::int64_t left = blocks_since_build();
    if (left != known_.blocks_left) {
      ++progress_.leaked;
      std::printf("%s: %lld blocks are left, %lld without failures\n", program_.name, static_cast<long long>(left),
                  static_cast<long long>(known_.blocks_left));
    }
    progress_.finished = true;
  }

 private:
  std::int64_t blocks_since_build() const { return allocation::blocks_held() - held_before_; }

  bempd_status make(const Call& call, std::int64_t first_failure, allocation::Count& count) {
    allocation::start(plan_.mode, first_failure);
    const bempd_status status = call.make(*host_);
    count = allocation::stop();
    return status;
  }

  void run_undisturbed() {
    known_ = {};
    fresh_host();
    for (const Call& call : program_.calls) {
      allocation::Count count;
      const bempd_status status = make(call, allocation::never, count);
      if (status != call.expected) complain(call, "undisturbed: ", status);
      known_.allocations.push_back(count.asked_for);
      known_.results.push_back(result_of(call, *host_));
      if (host_->model != nullptr) known_.books = books(*host_);
    }
    known_.blocks_left = blocks_since_build();
  }

  void fresh_host() {
    host_.reset();
    held_before_ = allocation::blocks_held();
    host_ = std::make_unique<Host>(folder_);
  }

  // A model as it is before a call.
  void build(std::size_t next) {
    fresh_host();
    for (std::size_t k = 0; k < next; ++k) {
      allocation::Count count;
      make(program_.calls[k], allocation::never, count);
      result_of(program_.calls[k], *host_);
    }
  }

  std::vector<std::int64_t> positions(std::size_t which) const {
    const std::int64_t all = known_.allocations[which], most = plan_.most_per_call;
    std::vector<std::int64_t> chosen;
    if (most == 0 || all <= most) {
      for (std::int64_t n = 1; n <= all; ++n) chosen.push_back(n);
      return chosen;
    }
    // One in each of equal parts, at places that do not repeat themselves: multiples of the golden section.
    for (std::int64_t k = 0; k < most; ++k) {
      const double fraction = std::fmod(0.618033988749895 * static_cast<double>(k + 1), 1.0);
      const double place = (static_cast<double>(k) + fraction) / static_cast<double>(most);
      chosen.push_back(1 + static_cast<std::int64_t>(place * static_cast<double>(all)));
    }
    return chosen;
  }

  void disturb(std::size_t which) {
    const Call& call = program_.calls[which];
    const std::vector<std::int64_t> chosen = positions(which);
    bool done = false;
    while (progress_.position < chosen.size()) {
      progress_.allocation = chosen[progress_.position];
      ++progress_.position;
      done = fail_at(call, progress_.allocation);
      if (!done || call.can_be_repeated) continue;
      if (progress_.position < chosen.size()) {
        build(which);
        done = false;
      }
    }
    progress_.allocation = 0;
    allocation::Count count;
    if (!done || call.can_be_repeated) {
      const bempd_status status = make(call, allocation::never, count);
      if (status != call.expected) complain(call, "without failures, after some: ", status);
    }
    compare(call, which);
  }

  void compare(const Call& call, std::size_t which) {
    if (same(result_of(call, *host_), known_.results[which])) return;
    ++progress_.other_numbers;
    std::printf("%s, %s (call %zu): other numbers than without failures\n", program_.name, call.name, which);
  }

  // True if the call has done its work.
  bool fail_at(const Call& call, std::int64_t allocation) {
    const std::vector<double> before = books(*host_);
    allocation::Count count;
    const bempd_status status = make(call, allocation, count);
    progress_.spared += count.spared;
    if (count.failed == 0) return status == call.expected;
    ++progress_.failed;
    if (status == call.expected) {
      ++progress_.went_on;
      return true;
    }
    if (status != BEMPD_ERROR_MEMORY) {
      complain(call, "", status);
      return false;
    }
    ++progress_.told;
    // The message of a call without a model is that of the thread.
    if (bempd_last_error(host_->model)[0] == '\0' && bempd_last_error(nullptr)[0] == '\0') {
      if (progress_.silent++ == 0) std::printf("%s, %s: no sentence\n", program_.name, call.name);
    }
    if (books(*host_) != before) {
      ++progress_.lost;
      std::printf("%s, %s, allocation %lld: history or load factor is another\n", program_.name, call.name,
                  static_cast<long long>(allocation));
      build(progress_.call);
    }
    return false;
  }

  void complain(const Call& call, const char* when, bempd_status status) {
    ++progress_.wrong_status;
    std::printf("%s, %s, allocation %lld: %s%s (%s)\n", program_.name, call.name,
                static_cast<long long>(progress_.allocation), when, bempd_status_name(status),
                bempd_last_error(host_->model));
    if (status == BEMPD_ERROR_INTERNAL) build(progress_.call);
  }

  const Program& program_;
  const Plan& plan_;
  const std::string& folder_;
  Progress& progress_;
  Undisturbed known_;
  std::unique_ptr<Host> host_;
  std::int64_t held_before_ = 0;
};

}  // namespace

void run_trial(const Program& program, const Plan& plan, const std::string& folder, Progress& progress) {
  Trial(program, plan, folder, progress).run();
}

}  // namespace memory_test
