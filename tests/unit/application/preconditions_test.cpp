#include "server/handlers/preconditions.h"

#include <gtest/gtest.h>

#include "server/handlers/query.h"
#include "server/http/field_list.h"

namespace race::server {
namespace {

Request with(const std::string& name, std::initializer_list<std::string> values) {
  Request request;
  for (const std::string& value : values) request.headers.emplace_back(name, value);
  return request;
}

TEST(IfMatch, IsOneStrongTag) {
  EXPECT_EQ(if_match(Request()).value(), std::nullopt);
  EXPECT_EQ(if_match(with("if-match", {"\"3\""})).value(), 3);
  for (const char* tag :
       {"", "3", "\"\"", "\"0\"", "\"-1\"", "\"3", "W/\"3\"", "*", "\"3\", \"4\"", "\"3 \"", "\"9223372036854775808\""})
    EXPECT_EQ(if_match(with("if-match", {tag})).error().code, ErrorCode::out_of_range) << tag;
  EXPECT_FALSE(if_match(with("if-match", {"\"3\"", "\"3\""})));
}

TEST(IfNoneMatch, OfAChangeIsAStar) {
  EXPECT_FALSE(requires_absence(Request()).value());
  EXPECT_TRUE(requires_absence(with("if-none-match", {"*"})).value());
  EXPECT_EQ(requires_absence(with("if-none-match", {"\"3\""})).error().path, "If-None-Match");
  EXPECT_FALSE(requires_absence(with("if-none-match", {"*", "*"})));
}

TEST(IfNoneMatch, OfAQuestionIsAListOfTags) {
  for (const char* tags : {"*", "\"3\"", "W/\"3\"", "\"2\",\"3\"", "\"2\" , W/\"3\" ,\"4\""})
    EXPECT_TRUE(if_none_match_lists(with("if-none-match", {tags}), tag_of(3))) << tags;
  for (const char* tags : {"", ",", "\"2\"", "3", "\"33\"", " ", "\"3"})
    EXPECT_FALSE(if_none_match_lists(with("if-none-match", {tags}), tag_of(3))) << tags;
  EXPECT_TRUE(if_none_match_lists(with("if-none-match", {"\"2\"", "\"3\""}), tag_of(3)));
  EXPECT_FALSE(if_none_match_lists(Request(), tag_of(3)));
}

TEST(Query, HasWholeNumbersWithinARange) {
  Request request;
  const auto number = [&](const std::string& text, NumberRange range = {}) {
    request.query = {{"n", text}};
    return query_number(request, "n", range);
  };
  EXPECT_EQ(query_number(request, "n").value(), std::nullopt);
  EXPECT_EQ(number("1").value(), 1);
  EXPECT_EQ(number("9223372036854775807").value(), NumberRange{}.most);
  EXPECT_EQ(number("0", {0, 2}).value(), 0);
  EXPECT_EQ(number("2", {0, 2}).value(), 2);
  for (const char* text : {"", "0", "-1", "+1", " 1", "1 ", "1.0", "1e3", "0x1", "9223372036854775808"})
    EXPECT_EQ(number(text).error().code, ErrorCode::out_of_range) << text;
  EXPECT_EQ(number("3", {0, 2}).error().message, "must be a whole number from 0 to 2");
}

}  // namespace
}  // namespace race::server
