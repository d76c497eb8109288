#include "server/commands/input.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace race::server {
namespace {

struct InputTest : testing::Test {
  ~InputTest() override { std::filesystem::remove(path); }

  const std::string path = testing::TempDir() + "input_test." + std::to_string(::getpid());
};

TEST_F(InputTest, IsTheWholeFile) {
  for (const std::size_t size : {0UL, 1UL, (1UL << 16U) - 1, 1UL << 16U, (1UL << 16U) + 1, 1UL << 20U}) {
    std::ofstream(path) << std::string(size, 'x');
    EXPECT_EQ(read_input(path).value(), std::string(size, 'x'));
  }
}

TEST_F(InputTest, IsBounded) {
  std::ofstream(path) << "x";
  std::filesystem::resize_file(path, kMaxInput);
  EXPECT_EQ(read_input(path).value().size(), kMaxInput);
  std::filesystem::resize_file(path, kMaxInput + 1);
  EXPECT_EQ(read_input(path).error().code, ErrorCode::too_large);
  EXPECT_EQ(read_input("/dev/zero").error().code, ErrorCode::too_large);
}

TEST_F(InputTest, WhatCannotBeReadIsAnError) {
  EXPECT_EQ(read_input(path).error(), (Error{ErrorCode::io, "cannot be read: No such file or directory"}));
  EXPECT_EQ(read_input(testing::TempDir()).error().message, "cannot be read: Is a directory");
  EXPECT_EQ(read_input("").error().code, ErrorCode::io);
}

}  // namespace
}  // namespace race::server
