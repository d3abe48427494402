#pragma once

#include <string>
#include <string_view>

namespace bempd::linalg {

// BLAS in use, which the host's system chooses when the program is loaded.
struct Blas {
  std::string name;  // name with version; "BLAS" if unknown
  std::string core;  // kind of processor of its kernels; empty if unknown
  int threads = 0;   // 0 if unknown
};

Blas running_blas();

// "OpenBLAS 0.3.21 (Haswell, 4 threads)".
std::string describe(const Blas& blas);

// Whether kernels for this kind of processor are half as wide as those for AVX2.
bool is_before_avx2(std::string_view core);

// Whether the processor of this machine has AVX2 and its fused multiplication and addition.
bool processor_has_avx2();

// Makes OpenBLAS take its buffer of 128 MB before the first computation: it tries forever where the system gives it
// none. Throws NoMemory instead.
void require_blas_buffer();

}  // namespace bempd::linalg
