// JSON, rule by rule: what is read, what is rejected and with which code, and how values are written.
#include "core/value/json.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace race {
namespace {

using namespace std::string_literals;

Value read(std::string_view text) {
  auto value = parse_json(text);
  if (!value) ADD_FAILURE() << text << ": " << value.error().message;
  return value.value_or(Value::unknown());
}

// The code that `text` is refused with, as documents show it; "read" if it is not refused.
std::string refusal(std::string_view text, const JsonLimits& limits = {}) {
  const auto value = parse_json(text, limits);
  return value ? "read" : std::string(name(value.error().code));
}

std::string nested(std::size_t levels, const std::string& open, const std::string& close) {
  std::string text;
  for (std::size_t i = 0; i < levels; ++i) text += open;
  text += "1";
  for (std::size_t i = 0; i < levels; ++i) text += close;
  return text;
}

TEST(ReadJson, GivesEachKindOfValue) {
  EXPECT_EQ(read(" null "), Value());
  EXPECT_EQ(read("true"), Value(true));
  EXPECT_EQ(read("-12"), Value(-12));
  EXPECT_EQ(read("1.0"), Value(1.0));
  EXPECT_EQ(read("1e3"), Value(1000.0));
  EXPECT_EQ(read(R"("a\u00e4\n\ud83d\ude00")"), Value("aä\n😀"));
  EXPECT_EQ(read(R"([1,[],{}])"), Value(List{1, List{}, Dict{}}));
}

TEST(ReadJson, KeepsTheOrderOfKeys) {
  const Value read_value = read(R"({"z":1,"a":2})");
  EXPECT_EQ(read_value.as_dict().begin()->first.as_string(), "z");
}

TEST(ReadJson, KeepsZeroBytesInStrings) { EXPECT_EQ(read(R"("a\u0000b")"), Value("a\0b"s)); }

TEST(ReadJson, DistinguishesIntegersAndDoublesUpToTheirLimits) {
  EXPECT_EQ(read("9223372036854775807"), Value(std::numeric_limits<std::int64_t>::max()));
  EXPECT_EQ(read("-9223372036854775808"), Value(std::numeric_limits<std::int64_t>::min()));
  EXPECT_EQ(read("9223372036854775808.0"), Value(9223372036854775808.0));
  EXPECT_EQ(read("1.7976931348623157e308"), Value(std::numeric_limits<double>::max()));
  EXPECT_EQ(read("5e-324"), Value(std::numeric_limits<double>::denorm_min()));
}

TEST(ReadJson, RefusesNumbersOutOfRange) {
  EXPECT_EQ(refusal("9223372036854775808"), "constant");
  EXPECT_EQ(refusal("-9223372036854775809"), "constant");
  EXPECT_EQ(refusal("18446744073709551616"), "constant");
  EXPECT_EQ(refusal("[1, 1e400]"), "constant");
  EXPECT_EQ(refusal("-1e400"), "constant");
}

TEST(ReadJson, ReadsIntegersOutOfRangeAsUnknownIfAskedTo) {
  const auto value =
      parse_json(R"([1, 9223372036854775808, {"a": -9223372036854775809}])", {.keep_out_of_range = true});
  ASSERT_TRUE(value) << value.error().message;
  EXPECT_EQ(*value, Value(List{1, Value::unknown(), Dict{{"a", Value::unknown()}}}));
  EXPECT_EQ(refusal("1e999", {.keep_out_of_range = true}), "constant");
}

TEST(ReadJson, RefusesADuplicateKey) {
  EXPECT_EQ(refusal(R"({"a":1,"b":2,"a":1})"), "json");
  EXPECT_EQ(refusal(R"({"a":1,"\u0061":2})"), "json");
  EXPECT_EQ(refusal(R"([{"x":{"a":1,"a":2}}])"), "json");
  EXPECT_EQ(refusal(R"({"a":{"a":{"a":1}}})"), "read");
}

TEST(ReadJson, ReadsSixtyFourLevelsAndRefusesOneMore) {
  EXPECT_EQ(refusal(nested(64, "[", "]")), "read");
  EXPECT_EQ(refusal(nested(65, "[", "]")), "too_deep");
  EXPECT_EQ(refusal(nested(64, R"({"a":)", "}")), "read");
  EXPECT_EQ(refusal(nested(65, R"({"a":)", "}")), "too_deep");
  EXPECT_EQ(refusal(nested(1'000'000, "[", "]")), "too_deep");
  EXPECT_EQ(refusal(nested(3, "[", "]"), {.depth = 2}), "too_deep");
}

TEST(ReadJson, RefusesTextThatIsTooLong) {
  EXPECT_EQ(refusal("[1,2]", {.bytes = 5}), "read");
  EXPECT_EQ(refusal("[1,2]", {.bytes = 4}), "too_large");
}

TEST(ReadJson, RefusesWhatIsNotJson) {
  for (const char* text :
       {"",    "  ",       "nul", "[1,]",  "{\"a\"}", "{a:1}",   "01",        "+1",  ".5", "1.",
        "NaN", "Infinity", "'a'", "[1] 2", "{} {}",   "// c\n1", "\"\\x41\"", "\"a", "[",  "\"tab\tin it\""}) {
    EXPECT_EQ(refusal(text), "json") << text;
  }
}

TEST(ReadJson, RefusesBadUtf8AndLoneSurrogates) {
  for (const char* text : {"\"\xff\"", "\"\xc0\xaf\"", "\"\xe2\x82\"", "\"\xed\xa0\x80\"", "\"\xf4\x90\x80\x80\"",
                           R"("\ud800")", R"("\udc00")", R"("\ud800x")"}) {
    EXPECT_EQ(refusal(text), "json") << text;
  }
}

TEST(ReadJson, ReportsThePositionOfTheError) {
  const auto value = parse_json("[1, oops]");
  ASSERT_FALSE(value);
  EXPECT_NE(value.error().message.find("byte 5"), std::string::npos) << value.error().message;
}

TEST(WriteJson, WritesOneLineOrIndented) {
  const Value value(Dict{{"a", List{1, true, Value()}}, {"b", Dict{}}, {"c", List{}}});
  EXPECT_EQ(to_json(value), R"({"a":[1,true,null],"b":{},"c":[]})");
  EXPECT_EQ(to_json(value, 2), "{\n  \"a\": [\n    1,\n    true,\n    null\n  ],\n  \"b\": {},\n  \"c\": []\n}");
}

TEST(WriteJson, KeepsDoublesRecognisable) {
  EXPECT_EQ(to_json(Value(1.0)), "1.0");
  EXPECT_EQ(to_json(Value(-0.0)), "-0.0");
  EXPECT_EQ(to_json(Value(0.1)), "0.1");
  EXPECT_EQ(read(to_json(Value(1e22))), Value(1e22));
  EXPECT_EQ(read(to_json(Value(1e300))), Value(1e300));
}

TEST(WriteJson, EscapesWhatMustBeEscapedAndNothingElse) {
  EXPECT_EQ(to_json(Value("q\" b\\ n\n t\t r\r"s)), R"("q\" b\\ n\n t\t r\r")");
  EXPECT_EQ(to_json(Value("\0\x1f\x7f"s)), "\"\\u0000\\u001f\x7f\"");
  EXPECT_EQ(to_json(Value("ä/😀")), "\"ä/😀\"");
}

TEST(WriteJson, EscapesAtTheBeginningInTheMiddleAndAtTheEnd) {
  for (int c = 0; c < 0x80; ++c) {
    const std::string text(1, static_cast<char>(c));
    std::string alone, between;
    append_json_string(text, alone);
    append_json_string(text + "a" + text + text + "b" + text, between);
    const std::string written = alone.substr(1, alone.size() - 2);
    EXPECT_EQ(between, "\"" + written + "a" + written + written + "b" + written + "\"");
    EXPECT_EQ(written == text, c >= 0x20 && c != '"' && c != '\\') << "character " << c;
    EXPECT_EQ(read(alone), Value(text)) << "character " << c;
  }
}

TEST(WriteJson, EscapesAtEachOffsetOfTextsOfEachLength) {
  for (int c = 0; c < 0x100; ++c) {
    std::string alone;
    append_json_string(std::string(1, static_cast<char>(c)), alone);
    for (std::size_t size = 1; size <= 18; ++size) {
      for (std::size_t at = 0; at < size; ++at) {
        std::string out, before(at, '!'), behind(size - at - 1, '\x80');
        append_json_string(before + static_cast<char>(c) + behind, out);
        ASSERT_EQ(out, '"' + before + alone.substr(1, alone.size() - 2) + behind + '"') << "character " << c;
      }
    }
  }
}

TEST(WriteJson, AddsToTheEndOfAText) {
  for (const Value& value : {Value(), Value(true), Value(-7), Value(0.5), Value("a\"b"), Value(List{1, List{}, "x"}),
                             Value(Dict{{"k\n", Dict{{"e", Dict{}}}}, {"l", 2}})}) {
    std::string out = "[1, ";
    append_json(value, out);
    EXPECT_EQ(out, "[1, " + to_json(value));
    append_json(value, out);
    EXPECT_EQ(out, "[1, " + to_json(value) + to_json(value));
  }
  std::string out = "x";
  append_json_string("", out);
  append_json_string("y", out);
  EXPECT_EQ(out, R"(x"""y")");
}

}  // namespace
}  // namespace race
