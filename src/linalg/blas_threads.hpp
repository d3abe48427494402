#pragma once

namespace bempd::linalg {

// Scope in which the BLAS uses `threads` threads; its end restores the host's number. (Several host threads with a
// model each are many times slower if each uses all BLAS threads than with one BLAS thread each.) OpenBLAS with its own
// threads has one number for the whole process: among several scopes the least number counts, and the end of the last
// scope restores the number from before the first. OpenBLAS on OpenMP, MKL and BLIS have a number for each host thread.
// Other BLAS are not changed.
class BlasThreads {
 public:
  explicit BlasThreads(int threads) noexcept;
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

 private:
  int before_ = 0;  // number of the calling thread before, if each thread has its own
};

}  // namespace bempd::linalg
