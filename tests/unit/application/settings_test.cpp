#include "server/commands/settings.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "core/value/json.h"
#include "server/cell/component_groups.h"
#include "server/commands/arguments.h"

namespace race::server {
namespace {

using testing::ElementsAre;

struct SettingsTest : testing::Test {
  SettingsTest() { declare_settings(arguments, values); }
  std::vector<Error> read(const std::string& json) {
    return read_settings(parse_json(json).value(), arguments, values);
  }
  // "path: code" of each error.
  std::vector<std::string> wrong(const std::string& json) {
    std::vector<std::string> lines;
    for (const Error& error : read(json)) lines.push_back(error.path + ": " + std::string(name(error.code)));
    return lines;
  }

  Settings values;
  Arguments arguments{"serve"};
};

TEST_F(SettingsTest, AreReadFromAFile) {
  EXPECT_THAT(
      read(R"({"port": 81, "data": "d", "demo": "e", "web": "w", "headless": true, "operator": "o", "heartbeat": 2.5,
                       "remote": ["database", "cell"], "keep_runs": 5, "keep_mb": 0.5, "log_level": "debug"})"),
      ElementsAre());
  EXPECT_EQ(values.port, 81);
  EXPECT_EQ(values.data + values.demo + values.web + *values.operator_script, "dewo");
  EXPECT_TRUE(values.headless);
  EXPECT_THAT(values.remote, ElementsAre("database", "cell"));
  EXPECT_EQ(values.heartbeat_s, 2.5);
  EXPECT_EQ(values.keep_runs, 5);
  EXPECT_EQ(values.keep_mb, 0.5);
  EXPECT_EQ(values.log_level, "debug");
}

TEST_F(SettingsTest, KeepTheirDefaultsWithoutAKey) {
  EXPECT_THAT(read("{}"), ElementsAre());
  EXPECT_EQ(values.port, 8080);
  EXPECT_EQ(values.log_level, "info");
  EXPECT_FALSE(values.operator_script);
}

TEST_F(SettingsTest, OptionsComeBeforeTheFile) {
  ASSERT_TRUE(arguments.parse({"--port", "9", "--keep-runs=8080", "--remote", "display,audio", "--headless"}));
  EXPECT_THAT(read(R"({"port": 81, "keep_runs": 1, "remote": ["cell"], "headless": false, "data": "d"})"),
              ElementsAre());
  EXPECT_EQ(values.port, 9);
  EXPECT_EQ(values.keep_runs, 8080);
  EXPECT_THAT(values.remote, ElementsAre("display", "audio"));
  EXPECT_TRUE(values.headless);
  EXPECT_EQ(values.data, "d");
}

TEST_F(SettingsTest, AllErrorsAreListedAtOnceWithTheirKeys) {
  EXPECT_THAT(
      wrong(R"({"port": 65536, "data": 1, "headless": "yes", "remote": ["oven", "cell", "cell"], "keep_runs": 1.5,
                        "keep-mb": 3, "log_level": "loud", "heartbeat": "x", "operator": "-"})"),
      ElementsAre("port: out_of_range", "data: type", "headless: type", "operator: not_accepted", "heartbeat: type",
                  "keep_runs: out_of_range", "log_level: out_of_range", "keep-mb: unknown_field", "remote/0: not_found",
                  "remote/2: duplicate"));
  EXPECT_THAT(wrong("[]"), ElementsAre(": type"));
  EXPECT_THAT(wrong(R"({"remote": "cell"})"), ElementsAre("remote: type"));
  EXPECT_THAT(wrong(R"({"remote": [1]})"), ElementsAre("remote: type"));
}

TEST_F(SettingsTest, AWrongValueIsRefusedAlsoBelowAnOption) {
  ASSERT_TRUE(arguments.parse({"--port", "9"}));
  EXPECT_THAT(wrong(R"({"port": -1})"), ElementsAre("port: out_of_range"));
}

TEST_F(SettingsTest, NumbersReachTheirBounds) {
  for (const Setting& setting : settings()) {
    const auto* number = std::get_if<Setting::Number>(&setting.kind);
    if (!number) continue;
    const auto with = [&](double value) { return wrong(to_json(Dict{{setting.key, value}})); };
    EXPECT_THAT(with(number->range.low), ElementsAre());
    EXPECT_THAT(with(number->range.high), ElementsAre());
    EXPECT_THAT(with(number->range.low - 0.01), ElementsAre(setting.key + ": out_of_range"));
    EXPECT_THAT(with(number->range.high + 0.5), ElementsAre(setting.key + ": out_of_range"));
  }
}

TEST_F(SettingsTest, AreThoseOfTheSchema) {
  std::ostringstream text;
  text << std::ifstream(RACE_SOURCE_DIR "/api/schemas/server_config.json").rdbuf();
  const Value schema = parse_json(text.str()).value();
  const Dict& properties = schema.find("properties")->as_dict();
  ASSERT_EQ(properties.size(), settings().size());
  auto property = properties.begin();
  for (const Setting& setting : settings()) {
    EXPECT_EQ(property->first.as_string(), setting.key);
    const Value& of = (property++)->second;
    const Value* type = of.find("type");
    if (const auto* number = std::get_if<Setting::Number>(&setting.kind)) {
      EXPECT_EQ(type->as_string(), number->range.whole ? "integer" : "number");
      EXPECT_EQ(of.find("minimum")->to_double(), number->range.low);
      EXPECT_EQ(of.find("maximum")->to_double(), number->range.high);
      EXPECT_EQ(of.find("default")->to_double(), values.*number->value);
    } else if (const auto* choice = std::get_if<Setting::Choice>(&setting.kind)) {
      List words;
      for (const std::string_view word : choice->words) words.emplace_back(word);
      EXPECT_EQ(*of.find("enum"), Value(words));
      EXPECT_EQ(of.find("default")->as_string(), values.*choice->value);
    } else if (const auto* string = std::get_if<Setting::Text>(&setting.kind)) {
      EXPECT_EQ(type->as_string(), "string");
      EXPECT_EQ(of.find("default")->as_string(), values.*string->value);
    } else if (std::holds_alternative<Setting::Flag>(setting.kind)) {
      EXPECT_EQ(type->as_string(), "boolean");
    } else if (std::holds_alternative<Setting::Groups>(setting.kind)) {
      Settings all;
      for (const Value& group : of.find("items")->find("enum")->as_list()) all.remote.push_back(group.as_string());
      EXPECT_THAT(check_settings(all), ElementsAre());
      EXPECT_EQ(all.remote.size(), component_groups().size());
    } else {
      EXPECT_EQ(type->as_string(), "string");
    }
  }
}

}  // namespace
}  // namespace race::server
