#pragma once

#include <cholmod.h>

#include <Eigen/SparseCore>

namespace bempd::linalg {

// Computes the values of a supernodal factor that CHOLMOD has analysed for the pattern of `lower` and given memory. It
// follows CHOLMOD's own function (Chen, Davis, Hager and Rajamanickam 2008, section 3) in the order of its calls of
// BLAS and LAPACK, and so has its digits, but does long supernodes in parts. CHOLMOD's function cannot be cancelled,
// and uses OpenMP, which ends the process when memory is missing. Returns false if a pivot is not positive.
bool factorize_supernodes(const Eigen::SparseMatrix<double>& lower, cholmod_factor& factor);

}  // namespace bempd::linalg
