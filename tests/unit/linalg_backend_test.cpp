#include <gtest/gtest.h>

#include "linalg/sparse_cholesky.hpp"

TEST(LinearAlgebra, backend_is_the_configured_one) {
  EXPECT_STREQ(bempd::linalg::backend_name(), BEMPD_EXPECTED_BACKEND);
}
