#include <gtest/gtest.h>

#include "model/run_errors.hpp"

using namespace bempd::model;

// Differences of runs of which one has no growth.
namespace {

// A run in which one tip has grown twice by a length of 1, at its load factors.
RunAnswers grown_run() {
  RunAnswers run;
  for (int k = 0; k < 2; ++k) {
    bempd::crack::Extension e;
    e.event = k + 1, e.crack = 1, e.end = 1;
    e.from_x = k, e.x = k + 1, e.length = 1, e.load_factor = 2 - k;
    run.extensions.push_back(e);
    run.places.push_back({static_cast<double>(k), 5.0 - k});
  }
  return run;
}

TEST(RunAnswers, a_run_without_growth_differs_as_a_whole_from_one_with_growth) {
  for (const bool is_first : {true, false}) {
    const RunAnswers grown = grown_run(), none;
    const RunDifference found = is_first ? difference(none, grown) : difference(grown, none);
    EXPECT_EQ(found.first_growth, 1);
    EXPECT_EQ(found.path, 1);  // what it has grown before its last step
    EXPECT_EQ(found.crack, 1);
    EXPECT_EQ(found.peak, 1);
    EXPECT_FALSE(found.is_at_start);
  }
}

TEST(RunAnswers, two_runs_without_growth_do_not_differ) {
  const RunDifference found = difference({}, {});
  EXPECT_EQ(found.first_growth, 0);
  EXPECT_EQ(found.peak, 0);
  EXPECT_EQ(found.path, 0);
}

TEST(RunAnswers, no_resistance_rises_above_a_peak_that_is_unknown) {
  EXPECT_EQ(rise_above_peak({}, grown_run()), 0);
  EXPECT_EQ(rise_above_peak(grown_run(), {}), 0);
}

}  // namespace
