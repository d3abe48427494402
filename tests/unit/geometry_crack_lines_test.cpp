#include <gtest/gtest.h>

#include "error.hpp"
#include "geometry/crack_lines.hpp"

namespace {

using namespace bempd;

const std::vector<Edge> square{{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{0, 1}, {0, 0}}};

CrackLines lines_of(const std::vector<std::vector<Point>>& cracks) {
  std::vector<CrackPath> paths;
  for (const auto& points : cracks) paths.push_back({static_cast<int>(paths.size()) + 1, points});
  return crack_lines(paths, square, 1e-9);
}

TEST(CrackLines, an_inner_crack_is_one_line_with_two_tips) {
  const CrackLines found = lines_of({{{0.2, 0.5}, {0.5, 0.5}, {0.7, 0.6}}});
  ASSERT_EQ(found.lines.size(), 1u);
  EXPECT_EQ(found.lines[0].points.size(), 3u);
  EXPECT_EQ(found.lines[0].joints, (std::array<int, 2>{-1, -1}));
  EXPECT_TRUE(found.joints.empty());
}

TEST(CrackLines, an_end_on_the_boundary_is_a_mouth) {
  for (const auto& crack : {std::vector<Point>{{0, 0.5}, {0.5, 0.5}}, std::vector<Point>{{0, 0}, {0.5, 0.5}}}) {
    const CrackLines found = lines_of({crack});
    ASSERT_EQ(found.lines.size(), 1u);
    ASSERT_EQ(found.joints.size(), 1u);
    EXPECT_TRUE(found.joints[0].mouth);
    EXPECT_EQ(found.lines[0].joints, (std::array<int, 2>{0, -1}));
  }
}

TEST(CrackLines, cracks_end_where_they_meet) {
  const CrackLines branch = lines_of({{{0.2, 0.5}, {0.8, 0.5}}, {{0.5, 0.5}, {0.6, 0.8}}});
  EXPECT_EQ(branch.lines.size(), 3u);
  EXPECT_EQ(branch.joints.size(), 1u);
  const CrackLines crossing = lines_of({{{0.2, 0.5}, {0.8, 0.5}}, {{0.5, 0.2}, {0.6, 0.8}}});
  EXPECT_EQ(crossing.lines.size(), 4u);
  ASSERT_EQ(crossing.joints.size(), 1u);
  EXPECT_FALSE(crossing.joints[0].mouth);
  EXPECT_NEAR(crossing.joints[0].place.x(), 0.55, 1e-12);
  const CrackLines itself = lines_of({{{0.2, 0.5}, {0.8, 0.5}, {0.8, 0.8}, {0.5, 0.8}, {0.5, 0.2}}});
  EXPECT_EQ(itself.lines.size(), 3u);
  EXPECT_EQ(itself.lines[1].points.size(), 5u);
}

// Pieces shorter than the distance up to which places count as one do not make their crack meet itself.
TEST(CrackLines, short_pieces_before_an_end_leave_it_a_tip) {
  for (const double piece : {5e-10, 2e-9}) {
    const CrackLines found =
        lines_of({{{0.2, 0.5}, {0.5, 0.5}, {0.5 + piece, 0.5}, {0.5 + 2 * piece, 0.5}, {0.5 + 3 * piece, 0.5}}});
    ASSERT_EQ(found.lines.size(), 1u);
    EXPECT_EQ(found.lines[0].joints, (std::array<int, 2>{-1, -1}));
    EXPECT_TRUE(found.joints.empty());
    EXPECT_NEAR(found.lines[0].length(), 0.3 + 3 * piece, 1e-15);
  }
  const CrackLines bent = lines_of({{{0.2, 0.5}, {0.5, 0.5}, {0.5 + 1e-9, 0.5}, {0.7, 0.6}}});
  ASSERT_EQ(bent.lines.size(), 1u);
  EXPECT_EQ(bent.lines[0].points.size(), 3u);
}

TEST(CrackLines, refuse_what_has_no_meaning) {
  EXPECT_THROW(lines_of({{{0.5, 0.5}, {1.5, 0.5}}}), Error);                            // leaves the body
  EXPECT_THROW(lines_of({{{0.2, 0.5}, {0.2 + 3e-9, 0.5}}}), Error);                     // no length
  EXPECT_THROW(lines_of({{{0.2, 0}, {0.8, 0}}}), Error);                                // along the boundary
  EXPECT_THROW(lines_of({{{0.2, 0.5}, {0.8, 0.5}}, {{0.4, 0.5}, {0.9, 0.5}}}), Error);  // along each other
  EXPECT_THROW(lines_of({{{0.2, 0.5}, {0.8, 0.5}, {0.5, 0.5}}}), Error);                // folded
}

}  // namespace
