// Fields lists every violation of an object, each with its code and the path of the element.
#include "core/value/fields.h"

#include <gtest/gtest.h>

#include "core/value/json.h"

namespace race {
namespace {

using Need = Fields::Need;

// The violations, as "code path" in the order they were found.
std::vector<std::string> codes(const std::vector<Error>& errors) {
  std::vector<std::string> out;
  for (const Error& error : errors) out.push_back(std::string(name(error.code)) + " " + error.path);
  return out;
}

class FieldsOf : public testing::Test {
 protected:
  Fields open(std::string_view text) {
    json_ = *parse_json(text, {.keep_out_of_range = true});
    return Fields(json_, "Root/A", "state `A`", errors_);
  }
  Value json_;
  std::vector<Error> errors_;
};

TEST_F(FieldsOf, ACorrectObjectHasNoViolations) {
  Fields fields = open(R"({"name": "A", "on": true, "width": 2, "names": ["x", "y"], "any": {"a": [1.5]}})");
  EXPECT_EQ(fields.text("name", Need::required), "A");
  EXPECT_EQ(fields.boolean("on"), true);
  EXPECT_EQ(fields.number("width"), 2.0);
  EXPECT_EQ(fields.texts("names"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(fields.constant("any"), Value(Dict{{"a", List{1.5}}}));
  EXPECT_EQ(fields.text("absent"), std::nullopt);
  fields.close();
  EXPECT_TRUE(errors_.empty());
}

TEST_F(FieldsOf, EveryViolationIsListedAtOnce) {
  Fields fields = open(R"({"name": 1, "on": "yes", "names": ["x", 2], "more": null})");
  EXPECT_EQ(fields.text("name", Need::required), std::nullopt);
  EXPECT_EQ(fields.boolean("on"), std::nullopt);
  EXPECT_EQ(fields.texts("names"), std::vector<std::string>{"x"});
  EXPECT_EQ(fields.text("first", Need::required), std::nullopt);
  fields.close();
  EXPECT_EQ(codes(errors_), (std::vector<std::string>{"type Root/A", "type Root/A", "type Root/A", "missing Root/A",
                                                      "unknown_field Root/A"}));
}

TEST_F(FieldsOf, WithoutAnElementThePathIsThatOfTheField) {
  const Value json = parse_json(R"({"kind": 1, "far": ["x", 2], "more": null})").value();
  Fields fields(json, "", "the step", errors_, Fields::Paths::field);
  fields.text("kind");
  fields.texts("far");
  fields.text("path", Need::required);
  fields.violation(ErrorCode::type, "too much");
  fields.close();
  Fields inner(json, "steps/0", "a step", errors_, Fields::Paths::field);
  inner.text("path", Need::required);
  EXPECT_EQ(codes(errors_), (std::vector<std::string>{"type kind", "type far", "missing path", "type ",
                                                      "unknown_field more", "missing steps/0/path"}));
}

TEST_F(FieldsOf, AnIntegerIsWholeAndInItsRange) {
  Fields fields =
      open(R"({"least": -2, "most": 9, "below": -3, "above": 10, "float": 1.0, "huge": 99999999999999999999})");
  EXPECT_EQ(fields.integer("least", -2, 9), -2);
  EXPECT_EQ(fields.integer("most", -2, 9), 9);
  EXPECT_EQ(fields.integer("absent", -2, 9), std::nullopt);
  EXPECT_TRUE(errors_.empty());
  for (const char* key : {"below", "above", "float", "huge"}) EXPECT_EQ(fields.integer(key, -2, 9), std::nullopt);
  EXPECT_EQ(fields.integer("absent", -2, 9, Need::required), std::nullopt);
  EXPECT_EQ(codes(errors_), (std::vector<std::string>{"out_of_range Root/A", "out_of_range Root/A", "type Root/A",
                                                      "type Root/A", "missing Root/A"}));
}

TEST_F(FieldsOf, WhatIsNoObjectIsOneViolation) {
  Fields fields = open("[1]");
  EXPECT_FALSE(fields.is_object());
  EXPECT_EQ(fields.text("name", Need::required), std::nullopt);
  fields.close();
  EXPECT_EQ(codes(errors_), std::vector<std::string>{"type Root/A"});
}

TEST_F(FieldsOf, ANumberOutOfRangeIsFoundAtAnyLevel) {
  Fields fields = open(R"({"constant": {"a": [1, 9223372036854775808]}})");
  EXPECT_EQ(fields.constant("constant"), std::nullopt);
  EXPECT_EQ(codes(errors_), std::vector<std::string>{"constant Root/A"});
}

TEST(Name, StartsWithALetterOrUnderscore) {
  for (const char* text : {"a", "_", "Pick2", "f_ext_hat"}) EXPECT_TRUE(is_name(text)) << text;
  for (const char* text : {"", "2a", "a-b", "a b", "ä", "a.b", "a/b"}) EXPECT_FALSE(is_name(text)) << text;
}

}  // namespace
}  // namespace race
