#include "core/value/base64.h"

#include <gtest/gtest.h>

namespace race {
namespace {

TEST(Base64, IsThatOfTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, HasAllBytesAndDigits) {
  EXPECT_EQ(base64(std::string_view("\0\xff\xfe", 3)), "AP/+");
  EXPECT_TRUE(is_base64("AP/+"));
}

TEST(Base64, RejectsTextThatIsEmptyTruncatedOrHasOtherCharacters) {
  for (const char* text : {"", "Zg", "Zg=", "Zm9vY", "Z g=", "Zg_-", "Z=g=", "====", "A===", "Zm9v===="})
    EXPECT_FALSE(is_base64(text)) << text;
}

}  // namespace
}  // namespace race
