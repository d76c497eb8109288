// Every rule of the table can be seen at work, and core/SEMANTICS.md speaks of the same rules and equations.
#include "core/semantics/rules.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "core/execution/derive.h"

namespace race::semantics {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

void collect(const Value& node, std::set<std::string>& names) {
  names.insert(node.find("rule")->as_string());
  for (const Value& premise : node.find("premises")->as_list()) collect(premise, names);
}

TEST(Rules, EachIsAppliedInSomeConformanceCase) {
  std::set<std::string> applied;
  for (const auto& folder : fs::directory_iterator(fs::path(RACE_SOURCE_DIR) / "tests" / "conformance")) {
    if (!fs::exists(folder.path() / "script.json")) continue;
    const auto document =
        execution::derive_texts(read(folder.path() / "model.json"), read(folder.path() / "script.json"));
    if (!document) continue;
    for (const Value& step : document->find("steps")->as_list())
      for (const Value& tree : step.find("micro")->as_list()) collect(tree, applied);
  }
  for (const RuleInfo& rule : kRules) EXPECT_TRUE(applied.contains(std::string(rule.name))) << rule.name;
}

// "PTrigger 3.27", "Action1 3.16/4.17", "Cond 3.14/4.12": a name, then its equations, the later one refining the
// earlier.
TEST(Rules, HaveTheNamesAndEquationsOfTheNormativeText) {
  const std::string text = read(fs::path(RACE_SOURCE_DIR) / "core" / "SEMANTICS.md");
  for (const RuleInfo& rule : kRules) {
    const std::string name(rule.name), equation(rule.equation);
    const std::regex stated("\\b" + name + " (\\d\\.\\d+/)?" + std::regex_replace(equation, std::regex("\\."), "\\.") +
                            "\\b");
    EXPECT_TRUE(std::regex_search(text, stated)) << "core/SEMANTICS.md does not state " << name << " " << equation;
    EXPECT_TRUE(text.find(name) != std::string::npos) << name;
  }
}

}  // namespace
}  // namespace race::semantics
