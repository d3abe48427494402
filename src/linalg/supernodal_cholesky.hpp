#pragma once

#include <cholmod.h>

#include <Eigen/SparseCore>

namespace bempd::linalg {

// Numbers of a supernodal factor that CHOLMOD has analysed for the pattern of `lower` and given memory: in the order
// and by the calls of BLAS and LAPACK of CHOLMOD's own function (Chen, Davis, Hager and Rajamanickam 2008, section 3),
// so with the same digits but in supernodes that take long, which are done in parts. That one cannot be stopped, and
// works with OpenMP, which ends the process where memory is missing. False if a pivot is not positive.
bool factorize_supernodes(const Eigen::SparseMatrix<double>& lower, cholmod_factor& factor);

}  // namespace bempd::linalg
