#include "linalg/blas_threads.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <mutex>

namespace bempd::linalg {

namespace {

using Get = int (*)();
using Set = void (*)(int);
using Exchange = int (*)(int);

// Functions of the BLAS in use that get and set its number of threads; null if the BLAS has none. They are looked up by
// name, so that the library works with any BLAS.
struct ThreadControl {
  Get get = nullptr;
  Set set = nullptr;
  Exchange exchange = nullptr;  // function of MKL that sets the number of this thread and returns the old one
  bool whole_process = false;
};

template <class Function>
Function find(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

ThreadControl find_control() {
  ThreadControl control;
  if (const auto parallel = find<Get>("openblas_get_parallel")) {
    constexpr int own_threads = 1, open_mp = 2;  // OpenBLAS's cblas.h
    if (parallel() == own_threads) {
      control.get = find<Get>("openblas_get_num_threads");
      control.set = find<Set>("openblas_set_num_threads");
      control.whole_process = true;
    } else if (parallel() == open_mp) {
      control.get = find<Get>("omp_get_max_threads");
      control.set = find<Set>("omp_set_num_threads");
    }
  } else if (const auto exchange = find<Exchange>("MKL_Set_Num_Threads_Local")) {
    control.exchange = exchange;
  } else {
    control.get = find<Get>("bli_thread_get_num_threads");
    control.set = find<Set>("bli_thread_set_num_threads");
  }
  if (!control.get || !control.set) control.get = nullptr, control.set = nullptr;
  return control;
}

const ThreadControl& control() {
  static const ThreadControl found = find_control();
  return found;
}

// State of all scopes of the process: number of scopes, number of BLAS threads before the first scope, and present
// number of BLAS threads.
struct ScopeState {
  std::mutex mutex;
  int scopes = 0, before = 0, now = 0;
};

ScopeState& scope_state() {
  static ScopeState only;
  return only;
}

}  // namespace

BlasThreads::BlasThreads(int threads) noexcept {
  const ThreadControl& blas = control();
  if (blas.exchange) {
    before_ = blas.exchange(threads);
  } else if (blas.whole_process && blas.get) {
    ScopeState& state = scope_state();
    const std::lock_guard<std::mutex> lock(state.mutex);
    if (state.scopes++ == 0) state.before = state.now = blas.get();
    const int wanted = std::min(state.now, threads);
    if (wanted != state.now) blas.set(state.now = wanted);
  } else if (blas.get) {
    before_ = blas.get();
    blas.set(threads);
  }
}

BlasThreads::~BlasThreads() {
  const ThreadControl& blas = control();
  if (blas.exchange) {
    blas.exchange(before_);
  } else if (blas.whole_process && blas.get) {
    ScopeState& state = scope_state();
    const std::lock_guard<std::mutex> lock(state.mutex);
    // A number that the host has set meanwhile, in another thread or a callback, is left alone.
    if (--state.scopes == 0 && state.now != state.before && blas.get() == state.now) blas.set(state.before);
  } else if (blas.get) {
    blas.set(before_);
  }
}

}  // namespace bempd::linalg
