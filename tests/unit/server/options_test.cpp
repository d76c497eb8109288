#include "server/commands/options.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

Expected<Options> read(std::vector<std::string> words) {
  return read_options(words, "FILE... --data DIR [--port N] [--fast]");
}

TEST(Options, StandInAnyOrderBetweenTheRest) {
  const auto options = read({"a", "--port", "80", "--fast", "b", "--data=x=y"});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->rest, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(options->has("--fast"));
  EXPECT_EQ(options->text("--data"), "x=y");
  EXPECT_EQ(options->number("--port", 1, 0, 100), 80);
}

TEST(Options, AreRefusedByName) {
  EXPECT_EQ(read({"--slow"}).error().code, ErrorCode::unknown_field);
  EXPECT_EQ(read({"--fast=1"}).error().code, ErrorCode::unknown_field);
  EXPECT_EQ(read({"--port"}).error().code, ErrorCode::missing);
  EXPECT_EQ(read({"--port", "1", "--port", "2"}).error().code, ErrorCode::duplicate);
}

TEST(Options, NumbersHaveLimits) {
  for (const char* text : {"x", "", "-1", "101", "1x", "nan"})
    EXPECT_FALSE(read({"--port", text})->number("--port", 1, 0, 100)) << text;
  EXPECT_EQ(read({"--port", "0"})->number("--port", 7, 0, 100), 0);
  EXPECT_EQ(read({"--port", "100"})->number("--port", 7, 0, 100), 100);
  EXPECT_EQ(read({})->number("--port", 7, 0, 100), 7);
}

}  // namespace
}  // namespace race::server
