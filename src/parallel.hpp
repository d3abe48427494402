#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "cancellation.hpp"

namespace bempd {

// Calls body(i) for every i < count on up to `threads` threads (0: one per core), which end with the call. All threads
// obey the host's requests to the caller. An exception of body() ends the loop and is thrown again.
//
// OpenMP is not used: its threads spin for a while after every loop and so take the cores from the threads of the BLAS
// and of the host, which made small scenes four times slower.
template <class Body>
void parallel_for(std::size_t count, int threads, const Body& body) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t workers = std::min(count, threads > 0 ? static_cast<std::size_t>(threads) : cores);
  if (workers <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const CancellationScope::Requests requests = CancellationScope::current();
  const auto work = [&] {
    const CancellationScope scope(requests);
    try {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(failing);
      failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t t = 1; t < workers; ++t) others.emplace_back(work);
    } catch (const std::system_error&) {
      // The existing threads do the work if no further thread can be started.
    } catch (const std::bad_alloc&) {
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace bempd
