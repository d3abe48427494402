#include <gtest/gtest.h>

#include "linalg/blas.hpp"

namespace {

using namespace bempd::linalg;

TEST(Blas, describes_itself_in_one_line) {
  EXPECT_EQ(describe({"OpenBLAS 0.3.21", "Haswell", 4}), "OpenBLAS 0.3.21 (Haswell, 4 threads)");
  EXPECT_EQ(describe({"OpenBLAS 0.3.21", "Zen", 1}), "OpenBLAS 0.3.21 (Zen, 1 thread)");
  EXPECT_EQ(describe({"BLAS", "", 0}), "BLAS");
  const Blas running = running_blas();
  EXPECT_FALSE(running.name.empty());
  EXPECT_EQ(running.name.find('\n'), std::string::npos);
  EXPECT_EQ(running.core.empty(), running.threads == 0);
}

TEST(Blas, tells_kernels_of_older_processors) {
  for (const char* core : {"Prescott", "PRESCOTT", "Nehalem", "Sandybridge", "Opteron_SSE3"})
    EXPECT_TRUE(is_before_avx2(core)) << core;
  for (const char* core : {"Haswell", "Zen", "SkylakeX", "Cooperlake", "Sapphirerapids", "neoversen1", "Excavator", ""})
    EXPECT_FALSE(is_before_avx2(core)) << core;
}

}  // namespace
