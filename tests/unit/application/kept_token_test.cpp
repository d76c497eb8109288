#include "server/commands/kept_token.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "server/store/files.h"

namespace race::server {
namespace {

constexpr const char* kUrl = "http://127.0.0.1:8080";
const KeptToken kToken{"ada", "race_abc-DEF_1", 1'800'000'000'000};

struct KeptTokensTest : testing::Test {
  KeptTokensTest() {
    std::string made = std::filesystem::temp_directory_path() / "kept-XXXXXX";
    folder = std::string(::mkdtemp(made.data())) + "/state/race";
  }
  ~KeptTokensTest() override { std::filesystem::remove_all(std::filesystem::path(folder).parent_path().parent_path()); }

  std::string file() const { return folder + "/http_127.0.0.1_8080.json"; }
  // What stands in the file instead.
  ErrorCode code_of(const std::string& text) {
    EXPECT_TRUE(write_file(file(), text, 0600));
    const auto found = tokens().find(kUrl);
    EXPECT_FALSE(found) << text;
    return found ? ErrorCode::json : found.error().code;
  }
  KeptTokens tokens() const { return KeptTokens(folder); }

  std::string folder;
};

TEST_F(KeptTokensTest, AreFoundForTheServerTheyAreOf) {
  EXPECT_FALSE(tokens().find(kUrl).value());
  ASSERT_TRUE(tokens().keep(kUrl, kToken));
  for (const char* url : {kUrl, "http://127.0.0.1:8080/"}) {
    const auto found = tokens().find(url).value();
    ASSERT_TRUE(found) << url;
    EXPECT_EQ(found->account + found->token, "adarace_abc-DEF_1");
    EXPECT_EQ(found->expires, kToken.expires);
  }
}

TEST_F(KeptTokensTest, AreOfNoOtherServer) {
  ASSERT_TRUE(tokens().keep(kUrl, kToken));
  for (const char* url :
       {"https://127.0.0.1:8080", "http://127.0.0.1:8081", "http://127.0.0.1", "http://localhost:8080"})
    EXPECT_FALSE(tokens().find(url).value()) << url;
  std::filesystem::copy(file(), folder + "/http_localhost_8080.json");  // by hand
  EXPECT_EQ(tokens().find("http://localhost:8080").error().code, ErrorCode::not_accepted);
}

TEST_F(KeptTokensTest, AreForTheirUserAlone) {
  ASSERT_TRUE(tokens().keep(kUrl, kToken));
  struct stat known {};
  ASSERT_EQ(::stat(file().c_str(), &known), 0);
  EXPECT_EQ(known.st_mode & 0777U, 0600U);
  ASSERT_EQ(::stat(folder.c_str(), &known), 0);
  EXPECT_EQ(known.st_mode & 0777U, 0700U);
  std::filesystem::permissions(file(), std::filesystem::perms::group_read, std::filesystem::perm_options::add);
  EXPECT_EQ(tokens().find(kUrl).error(),
            (Error{ErrorCode::not_accepted, "others may use this file: it needs the permissions 0600", file()}));
}

TEST_F(KeptTokensTest, AreNotWrittenThroughLinks) {
  ASSERT_TRUE(tokens().keep(kUrl, kToken));
  const std::string elsewhere = folder + "/elsewhere";
  ASSERT_TRUE(write_file(elsewhere, "as it was", 0644));
  std::filesystem::remove(file());
  std::filesystem::create_symlink(elsewhere, file());
  ASSERT_TRUE(tokens().keep(kUrl, kToken));
  EXPECT_EQ(read_file(elsewhere).value(), "as it was");
  EXPECT_TRUE(tokens().find(kUrl).value());
}

TEST_F(KeptTokensTest, WhatIsNoTokenIsNotSent) {
  ASSERT_TRUE(tokens().keep(kUrl, kToken));
  EXPECT_EQ(code_of("{"), ErrorCode::not_accepted);
  EXPECT_EQ(code_of("{}"), ErrorCode::not_accepted);
  EXPECT_EQ(code_of(R"({"server": "http://127.0.0.1:8080", "account": "ada", "expires": 1, "token": "x"})"),
            ErrorCode::not_accepted);
  EXPECT_EQ(code_of(R"({"server": "http://127.0.0.1:8080", "account": "ada", "expires": 1, "token": "race_\r\nX: y"})"),
            ErrorCode::not_accepted);
  EXPECT_EQ(code_of(std::string(2000, ' ')), ErrorCode::too_large);
}

TEST_F(KeptTokensTest, AreRemoved) {
  EXPECT_FALSE(tokens().remove(kUrl).value());
  ASSERT_TRUE(tokens().keep(kUrl, kToken));
  EXPECT_TRUE(tokens().remove(kUrl).value());
  EXPECT_FALSE(tokens().find(kUrl).value());
}

TEST(KeptTokens, WithoutAFolderThereAreNone) {
  EXPECT_FALSE(KeptTokens("").find(kUrl).value());
  EXPECT_FALSE(KeptTokens("").remove(kUrl).value());
  EXPECT_EQ(KeptTokens("").keep(kUrl, kToken).error().code, ErrorCode::io);
}

TEST(OriginOf, IsTheSameHoweverAServerIsWritten) {
  EXPECT_EQ(origin_of("http://Cell.Example/").value(), "http://cell.example:80");
  EXPECT_EQ(origin_of("https://cell.example").value(), "https://cell.example:443");
  EXPECT_EQ(origin_of("ftp://cell").error().code, ErrorCode::syntax);
}

}  // namespace
}  // namespace race::server
