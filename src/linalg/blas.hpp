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

// Text such as "OpenBLAS 0.3.21 (Haswell, 4 threads)".
std::string describe(const Blas& blas);

// Whether BLAS kernels for this kind of processor (Blas::core) are older than AVX2, so that their vectors are half as
// wide.
bool is_before_avx2(std::string_view core);

// Whether the processor of this machine has AVX2 and FMA (fused multiply-add).
bool processor_has_avx2();

// Makes OpenBLAS take its buffer of 128 MB before the first computation. Throws NoMemory if the system does not give
// this memory; OpenBLAS alone would try forever.
void require_blas_buffer();

// Number of threads on which a loop may call the BLAS, at most `threads` (0: one per core). OpenBLAS takes a buffer for
// each thread; if the system does not give these buffers, the result is 1, because one buffer exists already.
int threads_with_blas_buffers(int threads);

}  // namespace bempd::linalg
