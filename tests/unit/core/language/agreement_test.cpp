// Agreement with CPython: generated programs and chosen expressions give the same value or the same kind of fault in
// both. All of them go through one run of /usr/bin/python3 (agreement.py).
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

#include "core/language/values/printing.h"
#include "tests/unit/core/language/environment.h"
#include "tests/unit/core/language/program_generator.h"
#include "tests/unit/setting.h"

namespace race::language::test {
namespace {

constexpr std::uint32_t kSeed = 20140929;
constexpr std::size_t kPrograms = 2500;
const std::string kBudget = "fault budget";
const std::string kFolder = RACE_SOURCE_DIR "/tests/unit/core/language";

std::string read_all(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// What CPython makes of each program.
std::vector<std::string> in_python(const std::vector<std::string>& programs) {
  char folder[] = "/tmp/race-agreement-XXXXXX";
  if (mkdtemp(folder) == nullptr) return {};
  const std::string in = std::string(folder) + "/in.json";
  const std::string out = std::string(folder) + "/out.json";
  std::ofstream(in) << to_json(Value(List(programs.begin(), programs.end())));
  const std::string command = "/usr/bin/python3 -W ignore " + kFolder + "/agreement.py < " + in + " > " + out;
  const int status = std::system(command.c_str());
  const auto answers = parse_json(read_all(out));
  std::remove(in.c_str());
  std::remove(out.c_str());
  rmdir(folder);
  std::vector<std::string> results;
  if (status != 0 || !answers) return results;
  for (const Value& answer : answers->as_list()) {
    const Value* fault = answer.find("fault");
    results.push_back((fault ? "fault " + fault->as_string() + " after " : "") + answer.find("value")->as_string());
  }
  return results;
}

// What this interpreter makes of it: what res.out holds at the end, and the fault that ended it.
std::string here(const std::string& program) {
  Runner runner;
  const std::string stopped = runner.function(program);
  return (stopped.empty() ? "" : stopped + " after ") + repr(runner.state.at(State::res_out));
}

std::vector<std::string> chosen() {
  std::vector<std::string> programs;
  std::istringstream lines(read_all(kFolder + "/expressions.txt"));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != '#') programs.push_back("res.out = " + line);
  return programs;
}

void compare(const std::vector<std::string>& programs) {
  const std::vector<std::string> expected = in_python(programs);
  ASSERT_EQ(expected.size(), programs.size()) << "python3 did not answer";
  std::size_t faults = 0;
  std::size_t different = 0;
  std::size_t too_large = 0;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    faults += expected[i].rfind("fault", 0) == 0 ? 1 : 0;
    const std::string got = here(programs[i]);
    if (got == expected[i]) continue;
    if (got.rfind(kBudget, 0) == 0 || expected[i].rfind(kBudget, 0) == 0) {  // bounds that Python does not have
      ++too_large;
      continue;
    }
    if (++different <= 20) ADD_FAILURE() << programs[i] << "\n  CPython: " << expected[i] << "\n  here:    " << got;
  }
  EXPECT_EQ(different, 0U);
  EXPECT_LE(too_large, programs.size() / 50);
  std::cout << programs.size() << " programs, " << faults << " of them with a fault, " << too_large << " too large\n";
}

TEST(Agreement, ChosenExpressionsAreAsInPython) {
  const std::vector<std::string> programs = chosen();
  ASSERT_GE(programs.size(), 300U);
  compare(programs);
}

TEST(Agreement, GeneratedProgramsAreAsInPython) {
  const auto seed = static_cast<std::uint32_t>(setting("RACE_SEED", kSeed));
  std::cout << "seed " << seed << " (set RACE_SEED for another)\n";
  std::vector<std::string> programs;
  for (std::uint32_t i = 0; i < sample(kPrograms); ++i) programs.push_back(ProgramGenerator(seed + i).program());
  compare(programs);
}

}  // namespace
}  // namespace race::language::test
