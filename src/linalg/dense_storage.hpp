#pragma once

#include <Eigen/Core>

// Safe resizing for Eigen 3.4, whose matrices keep a pointer to freed memory when there is no memory for a new size;
// the next use or the destructor then damages the heap. Here such a matrix is empty. Eigen's own function is replaced
// for the types that this library resizes; the header comes first in every source file (src/CMakeLists.txt).
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

// Storage of permutations.
template <>
inline void DenseStorage<int, Dynamic, Dynamic, 1, ColMajor>::resize(Index size, Index rows, Index cols) {
  if (size != m_rows) {
    DenseStorage().swap(*this);
    DenseStorage(size, rows, cols).swap(*this);
  }
  m_rows = rows;
}

}  // namespace Eigen
