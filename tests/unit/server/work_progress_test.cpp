// How far work has come: never back, never beyond its end.
#include "server/threads/work_progress.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

TEST(WorkProgress, IsNotKnownUntilItIsKnownHowMuchThereIs) {
  WorkProgress progress;
  EXPECT_FALSE(progress.state());
  progress.reach(3);
  EXPECT_FALSE(progress.state());
  progress.begin(10, "bytes");
  EXPECT_EQ(progress.state()->done, 0U);
  EXPECT_EQ(progress.state()->total, 10U);
  EXPECT_STREQ(progress.state()->unit, "bytes");
}

TEST(WorkProgress, GoesNeitherBackNorBeyondItsEnd) {
  WorkProgress progress;
  progress.begin(10, "bytes");
  progress.reach(4);
  progress.reach(2);
  EXPECT_EQ(progress.state()->done, 4U);
  progress.reach(11);
  EXPECT_EQ(progress.state()->done, 10U);
}

TEST(WorkProgress, OfNothingIsNotKnown) {
  WorkProgress progress;
  progress.begin(0, "bytes");
  progress.finish();
  EXPECT_FALSE(progress.state());
}

TEST(WorkProgress, HasPartsThatCountInSomethingElse) {
  WorkProgress progress;
  WorkParts parts(&progress, 1000, "bytes");
  const WorkPart first = parts.next(400), second = parts.next(600);
  first.reach(0, 0);
  EXPECT_EQ(progress.state()->done, 0U);
  first.reach(1, 4);
  EXPECT_EQ(progress.state()->done, 100U);
  second.reach(1, 3);
  EXPECT_EQ(progress.state()->done, 600U);
  first.finish();
  EXPECT_EQ(progress.state()->done, 600U);
  second.reach(7, 7);
  EXPECT_EQ(progress.state()->done, 1000U);
}

TEST(WorkProgress, NeedsNobodyWhoWaits) {
  WorkParts parts(nullptr, 10, "bytes");
  parts.next(5).finish();
  WorkPart().reach(1, 2);
}

}  // namespace
}  // namespace race::server
