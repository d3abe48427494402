#include "linalg/blas.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>

namespace bempd::linalg {

namespace {

// Calls a function that only some BLAS have, which is looked up by name, so that any other BLAS can take its place.
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

// Names of OpenBLAS's kernels for x86 without AVX2 (its cpuid_x86.c and dynamic.c).
constexpr std::array older_cores = {
    "Generic", "Katmai",       "Coppermine",    "Northwood",   "Prescott",  "Banias",     "Core2",      "Penryn",
    "Atom",    "Dunnington",   "Nehalem",       "Athlon",      "Opteron",   "Barcelona",  "Bobcat",     "Nano",
    "Unknown", "Opteron_SSE3", "Opteron(SSE3)", "Sandybridge", "Bulldozer", "Piledriver", "Steamroller"};

}  // namespace

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
  const auto same = [](char a, char b) { return (a | 0x20) == (b | 0x20); };  // in either case
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
