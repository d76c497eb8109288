#include "server/http/message.h"

#include <gtest/gtest.h>

#include "server/http/encode_part.h"

namespace race::server {
namespace {

TEST(Target, IsDecodedInPathAndQuery) {
  const auto target = parse_target("/a%20b/c+d?port=Root%2FA.go&x=1+2&port=other&flag");
  ASSERT_TRUE(target);
  EXPECT_EQ(target->first, "/a b/c+d");
  EXPECT_EQ(target->second.at("port"), "Root/A.go");
  EXPECT_EQ(target->second.at("x"), "1 2");
  EXPECT_EQ(target->second.at("flag"), "");
}

TEST(Target, ThatIsNoneIsRefused) {
  for (const char* text : {"", "*", "a", "http://x/", "/%", "/%4", "/%4g", "/%0d", "/%00", "/%ff", "/?a=%e2%28"})
    EXPECT_FALSE(parse_target(text)) << text;
}

TEST(Target, HasPartsThatAreDecodedAsTheyWere) {
  for (const std::string text : {"a-b_c.d~9", "a/b", "%2F ?#", "\u00e9\u4e2d", "..", ""}) {
    const auto target = parse_target("/x/" + encode_part(text));
    ASSERT_TRUE(target) << text;
    EXPECT_EQ(target->first, "/x/" + text);
  }
  EXPECT_EQ(encode_part("a/ b"), "a%2F%20b");
}

TEST(Request, GivesHeadersAsOftenAsTheyCame) {
  Request request;
  request.headers = {{"host", "a"}, {"origin", "x"}, {"host", "b"}};
  EXPECT_EQ(request.count("host"), 2U);
  EXPECT_EQ(request.header("host"), "a");
  EXPECT_EQ(request.header("cookie"), "");
}

}  // namespace
}  // namespace race::server
