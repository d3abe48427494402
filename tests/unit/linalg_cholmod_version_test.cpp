#include <gtest/gtest.h>

#include <numeric>

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#endif

#include "linalg/cholmod_handles.hpp"
#include "linalg/sparse_cholesky.hpp"

namespace {

using namespace bempd::linalg;

TEST(Cholmod, of_another_main_version_is_refused_in_a_sentence) {
  EXPECT_NO_THROW(CholmodCommon<int>());
  EXPECT_NO_THROW(CholmodCommon<SuiteSparse_long>());
  try {
    require_cholmod(CHOLMOD_MAIN_VERSION + 1);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("CHOLMOD " + std::to_string(CHOLMOD_MAIN_VERSION + 1) + " runs"), std::string::npos)
        << message;
    EXPECT_NE(message.find("compile bempd again"), std::string::npos) << message;
  }
}

#if __has_include(<sys/resource.h>)
// Star whose hub is eliminated first: its factor is full, with 2.4e9 entries of 20 GB. Indices of 32 bits cannot count
// them, so that wide ones take over, and then memory is missing.
TEST(Cholmod, takes_wide_indices_where_narrow_ones_end) {
  constexpr int n = 70000;
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  rlimit less = before;
  less.rlim_cur = std::min<rlim_t>(before.rlim_cur, rlim_t{8} << 30);
  ASSERT_EQ(setrlimit(RLIMIT_AS, &less), 0);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, i == 0 ? n : 2.0);
  for (int i = 1; i < n; ++i) entries.emplace_back(i, 0, -1.0);
  Eigen::SparseMatrix<double> star(n, n);
  star.setFromTriplets(entries.begin(), entries.end());
  std::vector<int> hub_first(n);
  std::iota(hub_first.begin(), hub_first.end(), 0);
  const std::unique_ptr<SparseCholesky> factor = own_cholesky(false);
  factor->set_elimination_order(hub_first, 0);
  try {
    factor->factorize(star);
    ADD_FAILURE() << "there was memory";
  } catch (const TooLargeForIndices&) {
    ADD_FAILURE() << "the indices are still narrow";
  } catch (const std::bad_alloc&) {
    SUCCEED();
  }
  EXPECT_EQ(setrlimit(RLIMIT_AS, &before), 0);
}
#endif

}  // namespace
