#pragma once

#include <cholmod.h>

#include <Eigen/SparseCore>

namespace bempd::linalg {

// Computes the values of a supernodal factor that CHOLMOD has analysed for the pattern of `lower` and given memory.
// Returns false if a pivot is not positive. The BLAS and LAPACK calls are those of CHOLMOD's own function (Chen, Davis,
// Hager and Rajamanickam 2008, section 3) in the same order, so that the digits are the same, except that long
// supernodes are done in parts. CHOLMOD's function cannot be cancelled, and uses OpenMP, which ends the process if
// memory is missing.
template <class Index>
bool factorize_supernodes(const Eigen::SparseMatrix<double>& lower, cholmod_factor& factor);

}  // namespace bempd::linalg
