#include "server/stream/outbox.h"

#include <gmock/gmock.h>

namespace race::server {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Text text(std::string content) {
  return std::make_shared<const StreamMessage>(StreamMessage{1, "delta", std::move(content)});
}

std::vector<std::string> all(Outbox& outbox) {
  std::vector<std::string> out;
  while (const auto next = outbox.pop()) out.push_back((*next)->json);
  return out;
}

TEST(Outbox, KeepsTheOrder) {
  Outbox outbox;
  outbox.push("a", text("1"), false);
  outbox.push("b", text("2"), false);
  outbox.push("a", text("3"), false);
  EXPECT_THAT(all(outbox), ElementsAre("1", "2", "3"));
}

TEST(Outbox, GivesTogetherWhatFitsAndTheFirstHoweverLargeItIs) {
  Outbox outbox;
  for (const char* each : {"12345", "6", "78", "9"}) outbox.push("a", text(each), false);
  const auto together = [&](std::size_t limit) {
    std::vector<std::string> texts;
    for (const Text& each : outbox.pop_together(limit)) texts.push_back(each->json);
    return texts;
  };
  EXPECT_THAT(together(3), ElementsAre("12345"));
  EXPECT_EQ(outbox.bytes(), 9U) << "with what is on its way";
  EXPECT_THAT(together(3), ElementsAre("6", "78"));
  EXPECT_EQ(outbox.bytes(), 4U);
  EXPECT_THAT(together(3), ElementsAre("9"));
  EXPECT_THAT(together(3), IsEmpty());
  EXPECT_EQ(outbox.bytes(), 0U);
}

TEST(Outbox, OfASampledChannelOnlyTheNewestWaits) {
  Outbox outbox;
  for (int i = 0; i < 100; ++i) outbox.push("pose", text(std::to_string(i)), true);
  outbox.push("a", text("x"), false);
  EXPECT_THAT(all(outbox), ElementsAre("99", "x"));
}

TEST(Outbox, AStateChannelThatOverflowsIsDroppedAndNeedsASnapshot) {
  Outbox outbox;
  outbox.push("pose", text("p"), true);
  for (std::size_t i = 0; i < 10 * Outbox::kMessages; ++i) {
    outbox.push("a", text("x"), false);
    EXPECT_LE(outbox.size(), Outbox::kMessages);
  }
  EXPECT_THAT(outbox.take_stale_channels(), IsEmpty()) << "not before the client has caught up";
  EXPECT_THAT(all(outbox), ElementsAre("p"));
  EXPECT_THAT(outbox.take_stale_channels(), ElementsAre("a"));
  EXPECT_THAT(outbox.take_stale_channels(), IsEmpty());
  outbox.push("a", text("a delta that was on its way"), false);
  EXPECT_THAT(all(outbox), IsEmpty());
  outbox.drop("a");
  outbox.push("a", text("snapshot"), false);
  EXPECT_THAT(all(outbox), ElementsAre("snapshot"));
}

TEST(Outbox, IsEmptyOnceItsChannelsThatNeedASnapshotAreTaken) {
  Outbox outbox;
  EXPECT_TRUE(outbox.is_empty());
  for (std::size_t i = 0; i <= Outbox::kMessages; ++i) outbox.push("a", text("x"), false);
  EXPECT_THAT(all(outbox), IsEmpty());
  EXPECT_FALSE(outbox.is_empty());
  EXPECT_THAT(outbox.take_stale_channels(), ElementsAre("a"));
  EXPECT_TRUE(outbox.is_empty());
  outbox.push("b", text("x"), false);
  EXPECT_FALSE(outbox.is_empty());
}

TEST(Outbox, BytesCountToo) {
  Outbox outbox;
  const Text large = text(std::string(Outbox::kBytes / 3, 'x'));
  for (int i = 0; i < 3; ++i) outbox.push("a", large, false);
  EXPECT_EQ(outbox.size(), 3U);
  outbox.push("b", large, false);
  EXPECT_EQ(outbox.size(), 1U);
  all(outbox);
  EXPECT_THAT(outbox.take_stale_channels(), ElementsAre("a"));
}

TEST(Outbox, OneMessageMayBeLargerThanAll) {
  Outbox outbox;
  outbox.push("a", text(std::string(2 * Outbox::kBytes, 'x')), false);
  EXPECT_EQ(all(outbox).size(), 1U);
}

TEST(Outbox, AnUnsubscribedChannelIsForgotten) {
  Outbox outbox;
  outbox.push("a", text("1"), false);
  outbox.push("b", text("2"), false);
  outbox.drop("a");
  EXPECT_THAT(all(outbox), ElementsAre("2"));
}

}  // namespace
}  // namespace race::server
