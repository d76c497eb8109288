#include "server/commands/completion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace race::server {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using Kind = Completion::Kind;

constexpr std::array kCommands = {&kRun, &kRuns, &kStart, &kTrace, &kCall, &kPull, &kAccount, &kCore};

Completion of(const std::vector<std::string>& words) {
  return complete(kCommands, words, [](std::string_view placeholder) {
    return std::vector<std::string>{"pick", "place", std::string(placeholder)};
  });
}

TEST(Complete, ACommand) {
  EXPECT_THAT(of({"ru"}).words, ElementsAre("run", "runs"));
  EXPECT_THAT(of({""}).words, Contains("help"));
  EXPECT_THAT(of({"--v"}).words, ElementsAre("--version"));
  EXPECT_THAT(of({"help", "st"}).words, ElementsAre("start"));
  EXPECT_THAT(of({"dance", ""}).words, IsEmpty());
}

TEST(Complete, AnOptionAndItsValue) {
  EXPECT_THAT(of({"start", "pick", "--w"}).words, ElementsAre("--wait"));
  EXPECT_THAT(of({"start", "--"}).words, Contains("--help"));
  EXPECT_THAT(of({"account", "add", "ada", "--role", "op"}).words, ElementsAre("operator"));
  EXPECT_THAT(of({"account", "--role=op"}).words, ElementsAre("operator"));
  EXPECT_THAT(of({"start", "--server", ""}).words, IsEmpty());
  EXPECT_THAT(of({"start", "--wait=p"}).words, IsEmpty());
}

TEST(Complete, WhatAServerHas) {
  EXPECT_THAT(of({"start", "p"}).words, ElementsAre("pick", "place"));
  EXPECT_THAT(of({"start", "--server", "x", "--wait", "D"}).words, ElementsAre("DOCUMENT"));
  EXPECT_THAT(of({"start", "pick", "p"}).words, IsEmpty()) << "there is one document";
  EXPECT_THAT(of({"pull", "pick", "pl"}).words, ElementsAre("place"));
  EXPECT_THAT(of({"trace", "I"}).words, ElementsAre("ID"));
  EXPECT_THAT(of({"call", "S"}).words, ElementsAre("SERVICE.OPERATION"));
}

TEST(Complete, FilesAndFolders) {
  EXPECT_EQ(of({"run", ""}).kind, Kind::files);
  EXPECT_EQ(of({"start", "pick", "--ca", "c"}).kind, Kind::files);
  EXPECT_EQ(of({"start", "--ca=c"}).kind, Kind::files);
  EXPECT_EQ(of({"pull", "--into", ""}).kind, Kind::folders);
  EXPECT_EQ(of({"runs", "--data", "d"}).kind, Kind::folders);
}

TEST(Complete, ActionsOfACommand) {
  EXPECT_THAT(of({"core", "st"}).words, ElementsAre("start", "stop"));
  EXPECT_THAT(of({"account", "a"}).words, ElementsAre("add"));
}

}  // namespace
}  // namespace race::server
