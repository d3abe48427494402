#include <gtest/gtest.h>

#include "scene/names.hpp"

using bempd::scene::Names;
using Kind = Names::Kind;

// Names stand in sentences behind the numbers of what they name.
namespace {

Names names_of_a_strip() {
  Names names;
  names.set(Kind::region, 1, "left");
  names.set(Kind::region, 2, "middle");
  names.set(Kind::support, 1, "clamp");
  names.set(Kind::load, 3, "wind");
  names.set_edge(1, 4, "end");
  names.set_edge(2, 1, "bottom");
  names.set_edge(2, 3, "top");
  return names;
}

TEST(Names, stand_behind_numbers) {
  const Names names = names_of_a_strip();
  EXPECT_EQ(names.in("region 2 can translate"), "region 2 (\"middle\") can translate");
  EXPECT_EQ(names.in("support 1 and load 3"), "support 1 (\"clamp\") and load 3 (\"wind\")");
  EXPECT_EQ(names.in("bempd_fix_edge: edge 4 of region 1 is held"),
            "bempd_fix_edge: edge 4 (\"end\") of region 1 (\"left\") is held");
  EXPECT_EQ(names.in("region 12, region 2."), "region 12, region 2 (\"middle\").");
}

TEST(Names, stand_behind_each_number_of_a_row) {
  const Names names = names_of_a_strip();
  EXPECT_EQ(names.in("bonds have broken where regions 1 and 2 meet"),
            "bonds have broken where regions 1 (\"left\") and 2 (\"middle\") meet");
  EXPECT_EQ(names.in("edges 1, 2 and 3 of region 2"),
            "edges 1 (\"bottom\"), 2 and 3 (\"top\") of region 2 (\"middle\")");
  EXPECT_EQ(names.in("regions 3 or 1, 5 of them"), "regions 3 or 1 (\"left\"), 5 of them");
}

TEST(Names, of_an_edge_are_those_of_its_region) {
  const Names names = names_of_a_strip();
  EXPECT_EQ(names.in("region 2 has a corner where edge 3 begins"),
            "region 2 (\"middle\") has a corner where edge 3 (\"top\") begins");
  // An edge without its region, or with two regions, is not named.
  EXPECT_EQ(names.in("edge 3 of the outline crosses edge 1"), "edge 3 of the outline crosses edge 1");
  EXPECT_EQ(names.in("edge 3 lies between region 1 and region 2"),
            "edge 3 lies between region 1 (\"left\") and region 2 (\"middle\")");
}

TEST(Names, do_not_stand_behind_other_numbers_and_words) {
  const Names names = names_of_a_strip();
  for (const char* sentence : {"load 3.5 times the first", "overload 3", "subregion 1", "load factor 3", "region -1",
                               "load 3e5", "region 1st", "regions", "region ", "support 0", "support 99999999999"})
    EXPECT_EQ(names.in(sentence), sentence);
  EXPECT_EQ(names.in("at load 3."), "at load 3 (\"wind\").");
}

TEST(Names, are_not_looked_for_in_names) {
  Names names;
  names.set(Kind::region, 1, "region 2");
  names.set(Kind::region, 2, "region 1");
  EXPECT_EQ(names.in("region 1"), "region 1 (\"region 2\")");
}

TEST(Names, can_be_taken_away) {
  Names names;
  EXPECT_TRUE(names.empty());
  names.set(Kind::region, 1, "left");
  names.set_edge(1, 2, "side");
  EXPECT_EQ(names.called(Kind::region, 1), "region 1 (\"left\")");
  EXPECT_EQ(names.edges(1, "side"), std::vector<int>{2});
  EXPECT_TRUE(names.edges(2).empty());
  names.set(Kind::region, 1, "");
  names.set_edge(1, 2, "");
  EXPECT_TRUE(names.empty());
  EXPECT_EQ(names.called(Kind::region, 1), "region 1");
}

}  // namespace
