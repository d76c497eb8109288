#include "tests/conformance/line_diff.h"

#include <gtest/gtest.h>

namespace race {
namespace {

TEST(LineDiff, IsEmptyForEqualTexts) { EXPECT_EQ(line_diff("a\nb\n", "a\nb\n"), ""); }

TEST(LineDiff, ShowsWhatDiffersWithThreeLinesAround) {
  EXPECT_EQ(line_diff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n10\n"),
            "...\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n 9\n+10\n");
}

TEST(LineDiff, HasALimit) { EXPECT_EQ(line_diff("", "1\n2\n3\n", 2), "+1\n+2\n... (more lines differ)\n"); }

}  // namespace
}  // namespace race
