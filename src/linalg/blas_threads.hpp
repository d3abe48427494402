#pragma once

namespace bempd::linalg {

// While it lives, products and factorizations of this process use so many threads of the BLAS; then again as many as
// the host has chosen. A thread of the host for each model, each with all threads of the BLAS, is many times slower
// than one with one thread each. OpenBLAS with threads of its own knows one number for the whole process: among several
// scopes the least counts, and the last one to end brings back what there was before the first. OpenBLAS on OpenMP, MKL
// and BLIS have a number for each thread of the host. Of another BLAS nothing is changed.
class BlasThreads {
 public:
  explicit BlasThreads(int threads) noexcept;
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

 private:
  int before_ = 0;  // of this thread, where it has a number of its own
};

}  // namespace bempd::linalg
