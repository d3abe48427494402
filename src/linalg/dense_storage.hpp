#pragma once

#include <Eigen/Core>

// Safe resizing for Eigen 3.4. If there is no memory for a new size, Eigen's matrices keep a pointer to freed memory,
// and their next use or destructor damages the heap. With the functions below such a matrix is empty. They replace
// Eigen's own functions for the types that this library resizes; this header comes first in every source file
// (src/CMakeLists.txt).
namespace Eigen {

template <>
inline void DenseStorage<double, Dynamic, Dynamic, Dynamic, ColMajor>::resize(Index size, Index rows, Index cols) {
  if (size != m_rows * m_cols) {
    DenseStorage().swap(*this);
    DenseStorage(size, rows, cols).swap(*this);
  }
  m_rows = rows;
  m_cols = cols;
}

template <>
inline void DenseStorage<double, Dynamic, Dynamic, Dynamic, RowMajor>::resize(Index size, Index rows, Index cols) {
  if (size != m_rows * m_cols) {
    DenseStorage().swap(*this);
    DenseStorage(size, rows, cols).swap(*this);
  }
  m_rows = rows;
  m_cols = cols;
}

template <>
inline void DenseStorage<double, Dynamic, Dynamic, 1, ColMajor>::resize(Index size, Index rows, Index cols) {
  if (size != m_rows) {
    DenseStorage().swap(*this);
    DenseStorage(size, rows, cols).swap(*this);
  }
  m_rows = rows;
}

template <>
inline void DenseStorage<double, Dynamic, Dynamic, 2, ColMajor>::resize(Index size, Index rows, Index cols) {
  if (size != 2 * m_rows) {
    DenseStorage().swap(*this);
    DenseStorage(size, rows, cols).swap(*this);
  }
  m_rows = rows;
}

template <>
inline void DenseStorage<double, Dynamic, 1, Dynamic, RowMajor>::resize(Index size, Index rows, Index cols) {
  if (size != m_cols) {
    DenseStorage().swap(*this);
    DenseStorage(size, rows, cols).swap(*this);
  }
  m_cols = cols;
}

template <>
inline void DenseStorage<double, Dynamic, 3, Dynamic, ColMajor>::resize(Index size, Index rows, Index cols) {
  if (size != 3 * m_cols) {
    DenseStorage().swap(*this);
    DenseStorage(size, rows, cols).swap(*this);
  }
  m_cols = cols;
}

// Resizing of arrays of integers, in which Eigen stores permutations.
template <>
inline void DenseStorage<int, Dynamic, Dynamic, 1, ColMajor>::resize(Index size, Index rows, Index cols) {
  if (size != m_rows) {
    DenseStorage().swap(*this);
    DenseStorage(size, rows, cols).swap(*this);
  }
  m_rows = rows;
}

}  // namespace Eigen
