#include "server/commands/arguments.h"

#include <gtest/gtest.h>

#include <array>

namespace race::server {
namespace {

struct ArgumentsTest : testing::Test {
  ArgumentsTest() {
    arguments.positional("FILE", file);
    arguments.positionals("MORE", more, false);
    arguments.text("--data", "DIR", data, "a folder");
    arguments.text("--log", "FILE", log, "a file");
    arguments.number("--port", "N", port, {0, 100}, "a number");
    arguments.flag("--fast", fast, "a flag");
  }
  ErrorCode code(const std::vector<std::string>& words) { return arguments.parse(words).error().code; }

  std::string file, data = "data";
  std::vector<std::string> more;
  std::optional<std::string> log;
  double port = 7;
  bool fast = false;
  Arguments arguments{"test"};
};

TEST_F(ArgumentsTest, StandInAnyOrder) {
  EXPECT_EQ(arguments.parse({"a", "--port", "80", "--fast", "b", "--data=x=y", "-"}), Arguments::Outcome::parsed);
  EXPECT_EQ(file, "a");
  EXPECT_EQ(more, (std::vector<std::string>{"b", "-"}));
  EXPECT_EQ(data, "x=y");
  EXPECT_EQ(port, 80);
  EXPECT_TRUE(fast);
}

TEST_F(ArgumentsTest, KeepTheirDefaults) {
  EXPECT_EQ(arguments.parse({"a"}), Arguments::Outcome::parsed);
  EXPECT_EQ(data, "data");
  EXPECT_EQ(port, 7);
  EXPECT_FALSE(log || fast);
}

TEST_F(ArgumentsTest, TakeJsonAndEmptyTexts) {
  for (const char* text : {"{}", "[]", "[1, 2]", R"({"a": "b c"})", "", "--fast", "-1"}) {
    EXPECT_EQ(arguments.parse({"a", "--data", text}), Arguments::Outcome::parsed) << text;
    EXPECT_EQ(data, text);
  }
  EXPECT_EQ(arguments.parse({"a", "--data=", "--fast"}), Arguments::Outcome::parsed);
  EXPECT_EQ(data, "");
  EXPECT_TRUE(fast);
}

TEST_F(ArgumentsTest, AreRefusedByName) {
  EXPECT_EQ(code({"a", "--slow"}), ErrorCode::unknown_field);
  EXPECT_EQ(code({"a", "-x"}), ErrorCode::unknown_field);
  EXPECT_EQ(code({"--slow"}), ErrorCode::unknown_field);
  EXPECT_EQ(code({"a", "--fast=1"}), ErrorCode::type);
  EXPECT_EQ(code({"a", "--port"}), ErrorCode::missing);
  EXPECT_EQ(code({"a", "--port", "1", "--port", "2"}), ErrorCode::duplicate);
  EXPECT_EQ(code({"a", "--fast", "--fast"}), ErrorCode::duplicate);
  EXPECT_EQ(arguments.parse({"a", "--slow"}).error().path, "--slow");
  EXPECT_EQ(arguments.parse({"a", "--slow=1"}).error(),
            (Error{ErrorCode::unknown_field, "there is no such option", "--slow"}));
  EXPECT_EQ(arguments.parse({"a", "--prot", "1"}).error(),
            (Error{ErrorCode::unknown_field, "there is no such option; did you mean `--port`?", "--prot"}));
  EXPECT_EQ(arguments.parse({"a", "--port"}).error().path, "--port");
}

TEST_F(ArgumentsTest, NumbersHaveLimits) {
  for (const char* text : {"x", "", "-1", "101", "1x", "nan", "0x10", "+8", " 8"}) {
    EXPECT_EQ(code({"a", "--port", text}), ErrorCode::out_of_range) << text;
    EXPECT_EQ(arguments.parse({"a", "--port", text}).error().path, "--port");
  }
  for (const char* text : {"0", "100"}) {
    EXPECT_EQ(arguments.parse({"a", "--port", text}), Arguments::Outcome::parsed);
    EXPECT_EQ(port, std::stod(text));
  }
}

TEST_F(ArgumentsTest, HelpIsTold) {
  EXPECT_EQ(arguments.parse({"a", "--help"}), Arguments::Outcome::help_requested);
  EXPECT_EQ(arguments.parse({"-h"}), Arguments::Outcome::help_requested);
  EXPECT_EQ(arguments.usage(), "race test FILE [MORE...] [--data DIR] [--log FILE] [--port N] [--fast]");
  EXPECT_EQ(arguments.help(),
            "  --data DIR   a folder (data)\n"
            "  --log FILE   a file\n"
            "  --port N     a number (7)\n"
            "  --fast       a flag\n");
}

TEST_F(ArgumentsTest, KnowWhatAWordMayBecome) {
  const auto place = [this](const std::vector<std::string>& words) {
    const auto place = arguments.place_of_last(words);
    return place.placeholder + ':' + place.typed;
  };
  EXPECT_EQ(place({""}), "FILE:");
  EXPECT_EQ(place({"a", "--fast", "b"}), "MORE:b");
  EXPECT_EQ(place({"a", "b", "c"}), "MORE:c");
  EXPECT_EQ(place({"--port", "1", "b"}), "FILE:b") << "1 is a value";
  EXPECT_EQ(place({"--port=1", "b"}), "FILE:b");
  EXPECT_EQ(place({"--slow", "b"}), "FILE:b");
  EXPECT_EQ(place({"a", "--data", "d"}), "DIR:d");
  EXPECT_EQ(place({"a", "--data=d"}), "DIR:d");
  EXPECT_EQ(place({"a", "--fast=d"}), ":");
  EXPECT_EQ(place({"a", "--f"}), ":--f");
  EXPECT_EQ(arguments.place_of_last({"--"}).words,
            (std::vector<std::string>{"--help", "--data", "--log", "--port", "--fast"}));
}

TEST(Arguments, OfferTheWordsThatTheyKnow) {
  constexpr std::array<std::string_view, 2> kRoles = {"admin", "observer"};
  std::string action, role;
  std::optional<std::string> name;
  Arguments arguments("test");
  arguments.positional("ACTION", action);
  arguments.positional("NAME", name);
  arguments.suggest("ACTION", {"add", "list"});
  arguments.choice("--role", "ROLE", role, kRoles, "of add");
  EXPECT_EQ(arguments.place_of_last({""}).words, (std::vector<std::string>{"add", "list"}));
  EXPECT_EQ(arguments.place_of_last({"--role", "a"}).words, (std::vector<std::string>{"admin", "observer"}));
  EXPECT_TRUE(arguments.place_of_last({"add", ""}).words.empty());
  EXPECT_EQ(arguments.place_of_last({"add", "ada", ""}).placeholder, "") << "it would be a word too many";
}

TEST(Arguments, OneMayBeAbsent) {
  std::string action;
  std::optional<std::string> name;
  Arguments arguments("test");
  arguments.positional("ACTION", action);
  arguments.positional("NAME", name);
  EXPECT_EQ(arguments.usage(), "race test ACTION [NAME]");
  EXPECT_TRUE(arguments.parse({"add"}));
  EXPECT_FALSE(name);
  EXPECT_TRUE(arguments.parse({"add", "[a, b]"}));
  EXPECT_EQ(name, "[a, b]");
  EXPECT_EQ(arguments.parse({"add", "a", "b"}).error().path, "b");
}

TEST(Arguments, AWordTooManyOrTooFewIsNamed) {
  std::string file, server;
  Arguments arguments("test");
  arguments.positional("FILE", file);
  arguments.required_text("--server", "URL", server, "a server");
  EXPECT_EQ(arguments.parse({"--server=x", "a", "b"}).error(), (Error{ErrorCode::syntax, "is a word too many", "b"}));
  EXPECT_EQ(arguments.parse({"--server=x"}).error(), (Error{ErrorCode::missing, "the command needs it", "FILE"}));
  EXPECT_EQ(arguments.parse({"a"}).error(), (Error{ErrorCode::missing, "the command needs it", "--server"}));
  EXPECT_EQ(arguments.parse({"a", "--sever", "x"}).error().path, "--sever") << "what is misspelled comes first";
}

TEST(Arguments, TheStandardInputStandsOnceAmongFiles) {
  const auto parse = [](const std::vector<std::string>& words) {
    std::string first, text;
    std::vector<std::string> more;
    std::optional<std::string> script;
    Arguments arguments("test");
    arguments.file("FIRST", first);
    arguments.files("MORE", more);
    arguments.file("--script", "FILE", script, "a file");
    arguments.text("--text", "TEXT", text, "no file");
    const auto outcome = arguments.parse(words);
    return outcome ? "" : outcome.error().path;
  };
  EXPECT_EQ(parse({"-", "a"}), "");
  EXPECT_EQ(parse({"a", "b", "-", "--text", "-"}), "");
  EXPECT_EQ(parse({"-", "-"}), "MORE");
  EXPECT_EQ(parse({"a", "-", "-"}), "MORE");
  EXPECT_EQ(parse({"a", "-", "--script", "-"}), "--script");
}

TEST(ReadObject, TakesAnObjectAndNamesTheOptionOtherwise) {
  EXPECT_EQ(read_object("--arguments", R"({"a": 1})"), (Dict{{"a", 1}}));
  for (const auto& [text, code] : {std::pair("[1]", ErrorCode::type), {"{", ErrorCode::json}, {"", ErrorCode::json}}) {
    const auto read = read_object("--arguments", text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().code, code);
    EXPECT_EQ(read.error().path, "--arguments");
  }
}

}  // namespace
}  // namespace race::server
