#pragma once

namespace bempd::linalg {

// What one core does, in operations a second.
struct MachineRates {
  double arithmetic;      // multiplications and additions without memory, with the widest instructions there are
  double matrix_product;  // of the BLAS
};

// Measured at the first call of a process, within some milliseconds.
const MachineRates& machine_rates();

// A BLAS made for the processor reaches most of its arithmetic; one that takes it for an older one a quarter or less.
inline bool blas_misses_the_processor(const MachineRates& rates) {
  return rates.matrix_product < 0.3 * rates.arithmetic;
}

}  // namespace bempd::linalg
