#pragma once

namespace bempd::linalg {

// Scope in which products and factorizations of this process use a number of BLAS threads; its end restores the host's
// choice. One host thread for each model, each with all BLAS threads, is many times slower than one BLAS thread each.
// OpenBLAS with threads of its own has one number for the whole process: among several scopes the least counts, and the
// last one to end restores what there was before the first. OpenBLAS on OpenMP, MKL and BLIS have a number for each
// thread of the host. Nothing is changed for another BLAS.
class BlasThreads {
 public:
  explicit BlasThreads(int threads) noexcept;
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

 private:
  int before_ = 0;  // number of this thread, where it has one of its own
};

}  // namespace bempd::linalg
