#include "server/commands/pulled_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "server/commands/document_file.h"
#include "server/store/files.h"

namespace race::server {
namespace {

const std::string kA = hash_of("a"), kB = hash_of("b"), kC = hash_of("c");

PulledRevision revision(std::int64_t number, const std::string& hash) { return {number, hash}; }

TEST(PullStep, OverwritesOnlyWhatTheServerHas) {
  EXPECT_EQ(pull_step({{}, {}, revision(1, kA)}), PullStep::write) << "there is no file";
  EXPECT_EQ(pull_step({{}, revision(1, kA), revision(1, kA)}), PullStep::write) << "it was removed here";
  EXPECT_EQ(pull_step({kA, {}, revision(1, kA)}), PullStep::unchanged);
  EXPECT_EQ(pull_step({kA, {}, revision(1, kB)}), PullStep::conflict) << "nobody knows whose it is";
  EXPECT_EQ(pull_step({kA, revision(1, kA), revision(2, kB)}), PullStep::write);
  EXPECT_EQ(pull_step({kB, revision(1, kA), revision(1, kA)}), PullStep::keep);
  EXPECT_EQ(pull_step({kB, revision(1, kA), revision(2, kC)}), PullStep::conflict);
  EXPECT_EQ(pull_step({kB, revision(1, kA), revision(2, kB)}), PullStep::unchanged) << "both have changed it alike";
}

TEST(PullStep, NoticesAnotherServerWithTheSameNumber) {
  EXPECT_EQ(pull_step({kB, revision(1, kA), revision(1, kC)}), PullStep::conflict);
}

TEST(PushStep, SendsOnlyAChangeOfTheLastRevision) {
  EXPECT_EQ(push_step({kB, revision(1, kA), revision(1, kA)}), PushStep::send);
  EXPECT_EQ(push_step({kA, revision(1, kA), revision(1, kA)}), PushStep::unchanged);
  EXPECT_EQ(push_step({kB, revision(1, kA), revision(2, kC)}), PushStep::conflict);
  EXPECT_EQ(push_step({kB, revision(1, kA), revision(1, kC)}), PushStep::conflict) << "of another server";
  EXPECT_EQ(push_step({kA, revision(1, kA), revision(2, kC)}), PushStep::conflict) << "would take the change back";
  EXPECT_EQ(push_step({kC, revision(1, kA), revision(2, kC)}), PushStep::unchanged);
}

TEST(PushStep, MakesADocumentOnlyWhereThereIsNone) {
  EXPECT_EQ(push_step({kA, {}, {}}), PushStep::create);
  EXPECT_EQ(push_step({kA, revision(1, kA), {}}), PushStep::removed);
  EXPECT_EQ(push_step({kA, {}, revision(1, kB)}), PushStep::unknown);
  EXPECT_EQ(push_step({kA, {}, revision(1, kA)}), PushStep::unchanged);
}

struct PulledFilesTest : testing::Test {
  PulledFilesTest() {
    std::string made = std::filesystem::temp_directory_path() / "pulled-XXXXXX";
    folder = ::mkdtemp(made.data());
  }
  ~PulledFilesTest() override { std::filesystem::remove_all(folder); }
  std::string file() const { return folder + '/' + PulledFiles::kFile; }
  std::string folder;
};

TEST_F(PulledFilesTest, AreReadAsTheyWereWritten) {
  auto files = PulledFiles::read(folder).value();
  EXPECT_FALSE(files.find("pick"));
  files.set("pick", revision(3, kA));
  files.set("drop", revision(1, kB));
  ASSERT_TRUE(files.write());
  const auto again = PulledFiles::read(folder).value();
  EXPECT_EQ(again.find("pick"), revision(3, kA));
  EXPECT_EQ(again.find("drop"), revision(1, kB));
}

// What git merges: documents in order of their names, lines of two of them apart.
TEST_F(PulledFilesTest, HaveAFieldALine) {
  auto files = PulledFiles::read(folder).value();
  files.set("pick", revision(3, kA));
  files.set("drop", revision(1, kB));
  ASSERT_TRUE(files.write());
  EXPECT_EQ(read_file(file()).value(),
            "{\n  \"race_pulled\": 1,\n  \"documents\": {\n"
            "    \"drop\": {\n      \"revision\": 1,\n      \"sha256\": \"" +
                kB +
                "\"\n    },\n"
                "    \"pick\": {\n      \"revision\": 3,\n      \"sha256\": \"" +
                kA + "\"\n    }\n  }\n}\n");
}

TEST_F(PulledFilesTest, AreWrittenIfSomethingChangesAlone) {
  auto files = PulledFiles::read(folder).value();
  ASSERT_TRUE(files.write());
  EXPECT_FALSE(std::filesystem::exists(file()));
  files.set("pick", revision(3, kA));
  ASSERT_TRUE(files.write());
  std::filesystem::remove(file());
  files.set("pick", revision(3, kA));
  ASSERT_TRUE(files.write());
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(PulledFilesTest, WhatIsNoneIsRefused) {
  const std::string one = R"({"revision": 1, "sha256": ")" + kA + "\"}";
  for (const std::string& text :
       {std::string(), std::string("<<<<<<< ours"), std::string("{}"),
        R"({"race_pulled": 2, "documents": {}})" + std::string(),
        R"({"race_pulled": 1, "documents": {"a/b": )" + one + "}}",
        std::string(R"({"race_pulled": 1, "documents": {"a": {"revision": 0, "sha256": ""}}})"),
        R"({"race_pulled": 1, "documents": {}, "more": )" + one + "}"}) {
    ASSERT_TRUE(write_file(file(), text, 0644));
    const auto read = PulledFiles::read(folder);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().code, ErrorCode::not_accepted);
    EXPECT_EQ(read.error().path, file());
  }
}

}  // namespace
}  // namespace race::server
