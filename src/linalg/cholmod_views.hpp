#pragma once

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <cholmod.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "linalg/cholmod_handles.hpp"

namespace bempd::linalg {

// View of a compressed matrix for CHOLMOD. Indices of 32 bits are those of the matrix itself; wider indices are a copy.
template <class Index>
class CholmodMatrix {
 public:
  CholmodMatrix(const Eigen::SparseMatrix<double>& matrix, int symmetry) {
    assert(matrix.isCompressed());
    view_.nrow = static_cast<std::size_t>(matrix.rows());
    view_.ncol = static_cast<std::size_t>(matrix.cols());
    view_.nzmax = static_cast<std::size_t>(matrix.nonZeros());
    view_.p = indices(matrix.outerIndexPtr(), view_.ncol + 1, begin_);
    view_.i = indices(matrix.innerIndexPtr(), view_.nzmax, rows_);
    view_.x = const_cast<double*>(matrix.valuePtr());
    view_.stype = symmetry;
    view_.itype = Cholmod<Index>::index_type;
    view_.xtype = CHOLMOD_REAL;
    view_.dtype = CHOLMOD_DOUBLE;
    view_.sorted = 1;
    view_.packed = 1;
  }
  CholmodMatrix(const CholmodMatrix&) = delete;
  CholmodMatrix& operator=(const CholmodMatrix&) = delete;

  cholmod_sparse* get() { return &view_; }

 private:
  static Index* indices(const int* own, std::size_t count, std::vector<Index>& copy) {
    if constexpr (std::is_same_v<Index, int>) {
      return const_cast<int*>(own);
    } else {
      copy.assign(own, own + count);
      return copy.data();
    }
  }

  cholmod_sparse view_ = {};
  std::vector<Index> begin_, rows_;
};

inline cholmod_dense view(Eigen::Ref<Eigen::MatrixXd> matrix) {
  cholmod_dense out = {};
  out.nrow = static_cast<std::size_t>(matrix.rows());
  out.ncol = static_cast<std::size_t>(matrix.cols());
  out.d = static_cast<std::size_t>(std::max(matrix.outerStride(), matrix.rows()));
  out.nzmax = out.d * out.ncol;
  out.x = matrix.data();
  out.xtype = CHOLMOD_REAL;
  out.dtype = CHOLMOD_DOUBLE;
  return out;
}

// Requests large pages for a block of memory: the first access to many small pages costs a third of a factorization.
inline void use_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  if (bytes > before + page) madvise(static_cast<char*>(memory) + before, bytes - before, MADV_HUGEPAGE);
#endif
}

}  // namespace bempd::linalg
