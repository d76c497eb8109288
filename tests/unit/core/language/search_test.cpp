#include "core/language/primitives/search.h"

#include <gtest/gtest.h>

#include <string>

namespace race::language {
namespace {

// The texts of up to `size` letters a and b, the `number`-th.
std::string word(std::size_t number) {
  std::string text;
  for (; number > 1; number /= 2) text += number % 2 == 0 ? 'a' : 'b';
  return text;
}

TEST(Search, FindsWhatTheStandardLibraryFinds) {
  for (std::size_t t = 1; t < 512; ++t)
    for (std::size_t p = 1; p < 32; ++p) {
      const std::string text = word(t), part = word(p);
      for (std::size_t from = 0; from <= text.size(); ++from)
        EXPECT_EQ(find_first(text, part, from), text.find(part, from));
      EXPECT_EQ(find_last(text, part), text.rfind(part)) << text << " " << part;
    }
}

TEST(Search, FindsNothingInAnEmptyText) {
  EXPECT_EQ(find_first("", "a"), kNowhere);
  EXPECT_EQ(find_first("", ""), 0U);
  EXPECT_EQ(find_last("", "a"), kNowhere);
}

// In proportion to the product of the lengths, each would take minutes.
TEST(Search, TakesTimeInProportionToTheLengths) {
  const std::string text(8'000'000, 'a'), half(2'000'000, 'a');
  EXPECT_EQ(find_first(text, half + "b" + half), kNowhere);
  EXPECT_EQ(find_last(text, half + "b" + half), kNowhere);
  EXPECT_EQ(find_first(text, std::string(200, 'a') + "b"), kNowhere);
  EXPECT_EQ(find_first(text, "b" + std::string(200, 'a')), kNowhere);
  EXPECT_EQ(find_first(text + "b" + half, "ab" + half), text.size() - 1);
}

}  // namespace
}  // namespace race::language
