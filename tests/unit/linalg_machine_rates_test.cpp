#include <gtest/gtest.h>

#include "linalg/machine_rates.hpp"

namespace {

using bempd::linalg::blas_misses_the_processor;
using bempd::linalg::machine_rates;

TEST(MachineRates, are_measured_once) {
  const bempd::linalg::MachineRates& rates = machine_rates();
  EXPECT_GT(rates.arithmetic, 1e6);
  EXPECT_GT(rates.matrix_product, 1e6);
  EXPECT_LT(rates.arithmetic, 1e13);
  EXPECT_EQ(&rates, &machine_rates());
}

TEST(MachineRates, tell_a_blas_of_another_processor) {
  EXPECT_FALSE(blas_misses_the_processor({80e9, 45e9}));
  EXPECT_FALSE(blas_misses_the_processor({80e9, 150e9}));  // on several cores
  EXPECT_TRUE(blas_misses_the_processor({80e9, 17e9}));
}

}  // namespace
