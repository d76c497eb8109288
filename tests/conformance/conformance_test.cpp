// Every folder of tests/conformance: `race derive MODEL SCRIPT` gives what expected.json says, compared as README.md
// there says; expected.txt is the transcript of expected.json. RACE_WRITE_TRANSCRIPTS=1 writes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/execution/derive.h"
#include "core/semantics/derivation_text.h"
#include "core/value/json.h"
#include "tests/conformance/line_diff.h"

namespace race {
namespace {

namespace fs = std::filesystem;
const fs::path kCases = fs::path(RACE_SOURCE_DIR) / "tests" / "conformance";

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

Value json(const fs::path& path) {
  auto value = parse_json(read(path));
  EXPECT_TRUE(value) << path << " " << (value ? "" : to_string(value.error()));
  return value.value_or(Value());
}

// Rules that only detail how code was evaluated are left out of a comparison.
bool is_left_out(const Value& node) {
  static const std::set<std::string> kRules = {"FuncST", "FuncSD", "CondBE", "CondBD"};
  const Value* rule = node.find("rule");
  return rule && kRules.contains(rule->as_string());
}

bool is_left_out(const std::string& field) {
  static const std::set<std::string> kFields = {"equation", "requires", "refinement", "message"};
  return kFields.contains(field);
}

// The first place where `actual` differs from `expected`; empty if they agree.
std::string difference(const Value& expected, const Value& actual, const std::string& at) {
  if (expected.is_numeric() && actual.is_numeric()) {
    const double e = expected.to_double(), a = actual.to_double();
    if (std::abs(e - a) <= 1e-12 * std::max(std::abs(e), std::abs(a))) return "";
  } else if (expected.kind() == actual.kind() && expected.is_list()) {
    List e, a;
    const auto kept = [](const Value& item) { return !is_left_out(item); };
    std::ranges::copy_if(expected.as_list(), std::back_inserter(e), kept);
    std::ranges::copy_if(actual.as_list(), std::back_inserter(a), kept);
    for (std::size_t i = 0; i < std::min(e.size(), a.size()); ++i)
      if (auto d = difference(e[i], a[i], at + "/" + std::to_string(i)); !d.empty()) return d;
    if (e.size() == a.size()) return "";
    const bool missing = e.size() > a.size();
    return at + ": expected " + std::to_string(e.size()) + " items, got " + std::to_string(a.size()) + "; " +
           (missing ? "missing " + to_json(e[a.size()]) : "extra " + to_json(a[e.size()])).substr(0, 300);
  } else if (expected.kind() == actual.kind() && expected.is_dict()) {
    for (const auto& [key, value] : expected.as_dict()) {
      if (is_left_out(key.as_string())) continue;
      if (key.as_string() == "micro_count") {
        const Value* micro = actual.find("micro");
        if (!micro || static_cast<std::int64_t>(micro->as_list().size()) != value.as_integer())
          return at + ": expected " + to_json(value) + " micro steps";
        continue;
      }
      const Value* found = actual.find(key.as_string());
      if (!found) return at + "/" + key.as_string() + ": missing";
      if (auto d = difference(value, *found, at + "/" + key.as_string()); !d.empty()) return d;
    }
    for (const auto& [key, value] : actual.as_dict())
      if (!is_left_out(key.as_string()) && !expected.find(key.as_string()) &&
          !(key.as_string() == "micro" && expected.find("micro_count")))
        return at + "/" + key.as_string() + ": not expected";
    return "";
  } else if (expected == actual) {
    return "";
  }
  return at + ": expected " + to_json(expected).substr(0, 200) + ", got " + to_json(actual).substr(0, 200);
}

// A derivation document without what a comparison leaves out.
Value compared(const Value& value) {
  if (value.is_list()) {
    List kept;
    for (const Value& item : value.as_list())
      if (!is_left_out(item)) kept.push_back(compared(item));
    return Value(std::move(kept));
  }
  if (!value.is_dict()) return value;
  Dict kept;
  for (const auto& [key, field] : value.as_dict())
    if (!is_left_out(key.as_string())) kept.set(key, compared(field));
  return Value(std::move(kept));
}

// What a failure shows: the transcripts' lines that differ, else (a field that a transcript does not have) `where`.
std::string explained(const std::string& where, const Value& expected, const Value& actual) {
  const std::string lines =
      line_diff(semantics::derivation_text(compared(expected)), semantics::derivation_text(compared(actual)));
  return lines.empty() ? where
                       : "expected (-) and derived (+), first at " + where.substr(0, where.find(": ")) + ":\n" + lines;
}

// The pairs of path and code of a rejected document, as a set.
std::set<std::pair<std::string, std::string>> pairs(const Value& errors) {
  std::set<std::pair<std::string, std::string>> out;
  for (const Value& error : errors.as_list())
    out.emplace(error.find("path")->as_string(), error.find("code")->as_string());
  return out;
}

class Conformance : public testing::TestWithParam<std::string> {};

TEST_P(Conformance, DerivesWhatIsExpected) {
  const fs::path folder = kCases / GetParam();
  const Value expected = json(folder / "expected.json");
  const auto actual = execution::derive_texts(read(folder / "model.json"), read(folder / "script.json"));
  if (const Value* errors = expected.find("errors")) {
    ASSERT_FALSE(actual) << "the document is accepted";
    EXPECT_EQ(pairs(*errors), pairs(*execution::errors_json(actual.error()).find("errors")));
    return;
  }
  ASSERT_TRUE(actual) << to_json(execution::errors_json(actual.error()), 1);
  const std::string where = difference(expected, *actual, "");
  EXPECT_TRUE(where.empty()) << explained(where, expected, *actual);
}

TEST_P(Conformance, HasTheTranscriptOfWhatIsExpected) {
  const fs::path folder = kCases / GetParam();
  const Value expected = json(folder / "expected.json");
  if (expected.find("errors")) return;
  const std::string transcript = semantics::derivation_text(expected);
  if (std::getenv("RACE_WRITE_TRANSCRIPTS")) std::ofstream(folder / "expected.txt", std::ios::binary) << transcript;
  const std::string text = read(folder / "expected.txt");
  EXPECT_TRUE(text == transcript) << "expected.txt (-) is not the transcript of expected.json (+):\n"
                                  << line_diff(text, transcript);
}

std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kCases))
    if (fs::exists(entry.path() / "expected.json")) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Cases, Conformance, testing::ValuesIn(cases()), [](const auto& case_info) {
  std::string name = case_info.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(ConformanceCases, AreAllThere) { EXPECT_EQ(cases().size(), 134u); }

}  // namespace
}  // namespace race
