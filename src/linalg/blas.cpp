#include "linalg/blas.hpp"

#include <dlfcn.h>
#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "no_memory.hpp"

namespace bempd::linalg {

namespace {

// Calls a function that only some BLAS have; returns `unknown` if the function is missing. The function is looked up by
// name at run time, so that the library works with any BLAS.
template <class Result>
Result ask(const char* function, Result unknown) {
  void* const found = dlsym(RTLD_DEFAULT, function);
  return found ? reinterpret_cast<Result (*)()>(found)() : unknown;
}

std::string first_words(const std::string& text, int count) {
  std::size_t end = 0;
  for (int k = 0; k < count && end != std::string::npos; ++k) end = text.find(' ', k == 0 ? 0 : end + 1);
  return text.substr(0, end);
}

// Names of OpenBLAS's kernels for x86 processors without AVX2 (its cpuid_x86.c and dynamic.c).
constexpr std::array older_cores = {
    "Generic", "Katmai",       "Coppermine",    "Northwood",   "Prescott",  "Banias",     "Core2",      "Penryn",
    "Atom",    "Dunnington",   "Nehalem",       "Athlon",      "Opteron",   "Barcelona",  "Bobcat",     "Nano",
    "Unknown", "Opteron_SSE3", "Opteron(SSE3)", "Sandybridge", "Bulldozer", "Piledriver", "Steamroller"};

// Memory that OpenBLAS requests from the system on 64-bit processors (BUFFER_SIZE of its param.h), and a little more.
constexpr std::size_t openblas_buffer = (std::size_t{128} << 20) + (std::size_t{1} << 20);

bool system_gives(std::size_t bytes) {
#if __has_include(<sys/mman.h>)
  void* const block = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (block == MAP_FAILED) return false;
  munmap(block, bytes);
#endif
  return true;
}

// Multiplies matrices that are large enough for OpenBLAS's own kernels, which makes OpenBLAS take its buffer.
void multiply_once() {
  constexpr Eigen::Index size = 64;
  const Eigen::MatrixXd factor = Eigen::MatrixXd::Ones(size, size);
  Eigen::MatrixXd product(size, size);
  product.noalias() = factor * factor;
}

}  // namespace

void require_blas_buffer() {
  static std::atomic<bool> is_taken = false;
  if (is_taken || running_blas().name.rfind("OpenBLAS", 0) != 0) return;
  if (!system_gives(openblas_buffer))
    throw NoMemory(
        "the system gives no 128 MB of memory in one piece, which OpenBLAS needs once; raise the limit of the "
        "process's address space (ulimit -v)");
  multiply_once();
  is_taken = true;
}

int threads_with_blas_buffers(int threads) {
  const int wanted = threads > 0 ? threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  // Each further thread also needs a stack and a heap of its own, together less than another buffer.
  const bool are_given = wanted == 1 || running_blas().name.rfind("OpenBLAS", 0) != 0 ||
                         system_gives(2 * openblas_buffer * static_cast<std::size_t>(wanted - 1));
  return are_given ? wanted : 1;
}

Blas running_blas() {
  const std::string config = ask<const char*>("openblas_get_config", "BLAS");
  return {first_words(config, 2), ask<const char*>("openblas_get_corename", ""), ask("openblas_get_num_threads", 0)};
}

std::string describe(const Blas& blas) {
  if (blas.core.empty()) return blas.name;
  return blas.name + " (" + blas.core + ", " + std::to_string(blas.threads) +
         (blas.threads == 1 ? " thread)" : " threads)");
}

bool is_before_avx2(std::string_view core) {
  const auto same = [](char a, char b) { return (a | 0x20) == (b | 0x20); };  // upper and lower case are the same
  return std::any_of(older_cores.begin(), older_cores.end(), [&](std::string_view older) {
    return std::equal(core.begin(), core.end(), older.begin(), older.end(), same);
  });
}

bool processor_has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

}  // namespace bempd::linalg
