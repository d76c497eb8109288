#include "server/commands/near_word.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

const std::vector<std::string> kOptions = {"--seed", "--fast", "--keep-runs", "--keep-mb", "--port"};

TEST(NearWord, IsTheOneWithTheFewestSlips) {
  for (const char* word : {"--sed", "--seeds", "--seid", "--esed", "-seed", "seed"})
    EXPECT_EQ(near_word(word, kOptions), "--seed") << word;
  EXPECT_EQ(near_word("--keep-rnus", kOptions), "--keep-runs");
}

TEST(NearWord, IsTheOnlyOneThatTheWordBegins) {
  EXPECT_EQ(near_word("--keep-r", kOptions), "--keep-runs");
  EXPECT_EQ(near_word("--f", kOptions), "--fast");
  EXPECT_EQ(near_word("--keep", kOptions), "") << "two begin so";
}

TEST(NearWord, IsNoneIfNothingOrSeveralAreNear) {
  for (const char* word : {"", "-", "--", "--x", "--colour", "--sxxd"})
    EXPECT_EQ(near_word(word, kOptions), "") << word;
  EXPECT_EQ(near_word("--tap", {"--map", "--cap"}), "");
  EXPECT_EQ(near_word(std::string(1 << 20, 'x'), kOptions), "");
}

TEST(Suggestion, EndsAMessage) {
  EXPECT_EQ(suggestion("--sed", kOptions), "; did you mean `--seed`?");
  EXPECT_EQ(suggestion("--colour", kOptions), "");
}

}  // namespace
}  // namespace race::server
