// Order in which tips grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "crack/order.hpp"

namespace {

using namespace bempd::crack;

TEST(CrackOrder, nearest_load_factor_on_the_way) {
  const std::vector<Candidate> candidates{{{1, 0}, 3, 0.5, false}, {{2, 1}, 2, 0.4, false}, {{3, 0}, -1, 0.2, false}};
  EXPECT_EQ(first_to_grow(candidates, false)->index, 0u);
  EXPECT_EQ(first_to_grow(candidates, true)->index, 2u);
  EXPECT_EQ(first_to_grow(candidates, true)->ties, 0);
  EXPECT_FALSE(first_to_grow({}, true));
}

TEST(CrackOrder, overloaded_tips_come_first_the_most_overloaded_one_before_all) {
  std::vector<Candidate> candidates{
      {{1, 0}, 1, 1.2, true}, {{2, 0}, 1, 1.7, true}, {{3, 0}, 0.5, 0.9, false}, {{4, 1}, 1, 1.1, true}};
  for (int turn = 0; turn < 4; ++turn) {
    std::rotate(candidates.begin(), candidates.begin() + 1, candidates.end());
    EXPECT_EQ(candidates[first_to_grow(candidates, true)->index].tip, (TipId{2, 0}));
    EXPECT_EQ(candidates[first_to_grow(candidates, false)->index].tip, (TipId{2, 0}));
  }
}

TEST(CrackOrder, ties_go_by_crack_and_end_whatever_rounding_says) {
  std::vector<Candidate> candidates{
      {{2, 0}, 2, 0.4, false}, {{1, 1}, 2 * (1 + 4e-10), 0.4, false}, {{1, 0}, 2 * (1 + 8e-10), 0.4, false}};
  for (int turn = 0; turn < 3; ++turn) {
    std::rotate(candidates.begin(), candidates.begin() + 1, candidates.end());
    const FirstToGrow first = *first_to_grow(candidates, true);
    EXPECT_EQ(candidates[first.index].tip, (TipId{1, 0}));
    EXPECT_EQ(first.ties, 2);
  }
}

}  // namespace
