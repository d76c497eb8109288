// Lists of errors are bounded, and so are the texts in them.
#include "core/value/error_list.h"

#include <gtest/gtest.h>

#include <string>

#include "core/language/primitives/utf8.h"

namespace race {
namespace {

std::vector<Error> make(std::size_t count) {
  std::vector<Error> errors;
  for (std::size_t i = 0; i < count; ++i) add_error(errors, {ErrorCode::type, "no", std::to_string(i)});
  return errors;
}

TEST(Errors, AreFullWhenThereAreMoreThanAreListed) {
  EXPECT_FALSE(is_full(make(kMaxErrors)));
  EXPECT_TRUE(is_full(make(kMaxErrors + 1)));
  EXPECT_EQ(make(10 * kMaxErrors).size(), kMaxErrors + 1);
  EXPECT_EQ(make(10 * kMaxErrors).back().path, std::to_string(kMaxErrors)) << "the first ones are kept";
}

TEST(Errors, OfSeveralListsAreBoundedTogether) {
  std::vector<Error> errors = make(150);
  append_below(errors, make(150), "below");
  EXPECT_EQ(errors.size(), kMaxErrors + 1);
  EXPECT_EQ(errors.back().path, "below/50");
}

TEST(Errors, HaveTextsThatAreCutAtACharacter) {
  for (std::size_t before = 0; before < 4; ++before) {
    std::string text(before, 'a');
    while (text.size() < 2 * kMaxErrorBytes) text += "🤖";  // four bytes
    std::vector<Error> errors;
    add_error(errors, {ErrorCode::type, text, text});
    for (const std::string& cut : {errors[0].message, errors[0].path}) {
      EXPECT_TRUE(language::utf8::valid(cut));
      EXPECT_LE(cut.size(), kMaxErrorBytes);
      EXPECT_GT(cut.size() + 4, kMaxErrorBytes);
      EXPECT_TRUE(text.starts_with(cut));
    }
  }
  std::vector<Error> errors;
  const std::string longest(kMaxErrorBytes, 'a');
  add_error(errors, {ErrorCode::type, longest});
  EXPECT_EQ(errors[0].message, longest);
}

}  // namespace
}  // namespace race
