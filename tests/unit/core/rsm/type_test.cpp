// TYPE: which texts are types, and which values they have.
#include "core/rsm/type.h"

#include <gtest/gtest.h>

#include "core/value/json.h"

namespace race::rsm {
namespace {

bool is_type(std::string_view type) { return !malformed(parse_json(type).value()); }

std::string reason(std::string_view type, std::string_view value) {
  return mismatch(parse_json(type).value(), parse_json(value).value()).value_or("");
}

bool fits(std::string_view type, std::string_view value) { return reason(type, value).empty(); }

TEST(Type, IsOneOfTheNamesOrOneComposite) {
  for (const auto* type : {R"("any")", R"("pose")", R"({"list": "int"})", R"({"list": "int", "size": 3})",
                           R"({"record": {"a": {"optional": "image"}}})", R"({"enum": [1, "x", null]})"})
    EXPECT_TRUE(is_type(type)) << type;
}

TEST(Type, IsNothingElse) {
  for (const auto* type :
       {R"("float")", "null", "1", "{}", R"({"list": "nope"})", R"({"list": "int", "size": -1})",
        R"({"list": "int", "size": 1.5})", R"({"record": {"a b": "int"}})", R"({"record": ["int"]})",
        R"({"record": {"a": 1}})", R"({"enum": []})", R"({"enum": "x"})", R"({"optional": "x"})",
        R"({"list": "int", "optional": "int"})", R"({"record": {}, "size": 1})", R"({"list": "int", "extra": 1})"})
    EXPECT_FALSE(is_type(type)) << type;
}

TEST(Type, FitsValuesOfItsKind) {
  EXPECT_TRUE(fits(R"("any")", "[1]"));
  EXPECT_TRUE(fits(R"("null")", "null"));
  EXPECT_TRUE(fits(R"("int")", "1"));
  EXPECT_FALSE(fits(R"("int")", "1.0"));
  EXPECT_FALSE(fits(R"("int")", "true"));
  EXPECT_TRUE(fits(R"("number")", "1"));
  EXPECT_TRUE(fits(R"("number")", "1.5"));
  EXPECT_FALSE(fits(R"("string")", "null"));
  EXPECT_TRUE(fits(R"({"optional": "string"})", "null"));
  EXPECT_FALSE(fits(R"({"optional": "string"})", "1"));
}

TEST(Type, ReportsWhereAValueDoesNotFit) {
  EXPECT_EQ(reason(R"({"list": "int", "size": 2})", "[1]"), "expected 2 items, got 1");
  EXPECT_EQ(reason(R"({"list": "int"})", R"([1, "x"])"), "`[1]`: expected an int, got a string");
  EXPECT_EQ(reason(R"({"record": {"a": {"list": "int"}}})", R"({"a": [null]})"), "`a[0]`: expected an int, got null");
  EXPECT_EQ(reason(R"({"record": {"a": {"record": {"b": "bool"}}}})", R"({"a": {"b": 1}})"),
            "`a.b`: expected a bool, got an int");
  EXPECT_EQ(reason(R"({"enum": ["a", 1]})", R"("b")"), R"(expected one of "a", 1)");
}

TEST(Type, OfARecordHasItsFieldsAndNoOthers) {
  const auto* type = R"({"record": {"a": "int", "b": {"optional": "int"}}})";
  EXPECT_TRUE(fits(type, R"({"a": 1})"));
  EXPECT_TRUE(fits(type, R"({"b": 2, "a": 1})"));
  EXPECT_EQ(reason(type, R"({"b": 2})"), "the field `a` is missing");
  EXPECT_EQ(reason(type, R"({"a": 1, "c": 1})"), "unexpected field `c`");
}

TEST(Type, OfAPoseIsPositionAndOrientation) {
  EXPECT_TRUE(fits(R"("pose")", R"({"position": [0, 0.5, 0], "orientation": [0, 0, 0, 1]})"));
  EXPECT_FALSE(fits(R"("pose")", R"({"position": [0, 0.5, 0]})"));
  EXPECT_EQ(reason(R"("pose")", R"({"position": [0, 0, "x"], "orientation": [0, 0, 0, 1]})"),
            "`position[2]`: expected a number, got a string");
}

TEST(Type, OfAnImageHasASize) {
  EXPECT_TRUE(fits(R"("image")", R"({"width": 640, "height": 480, "data": "..."})"));
  EXPECT_FALSE(fits(R"("image")", R"({"width": 640})"));
}

TEST(Type, OfAnEnumComparesNumbersByValue) {
  EXPECT_TRUE(fits(R"({"enum": [1]})", "1.0"));
  EXPECT_FALSE(fits(R"({"enum": [1]})", "true"));
}

}  // namespace
}  // namespace race::rsm
