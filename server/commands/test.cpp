// race test FILE...: tests of models as files beside them. One line for each test, below it why it fails. Exit 1 if one
// fails, 2 if anything in a file is wrong: no test runs then. --watch runs those again that a changed file concerns;
// --from makes a test of a run.
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "core/value/json.h"
#include "server/commands/command.h"
#include "server/commands/input.h"
#include "server/commands/prepare_tests.h"
#include "server/commands/run_test.h"
#include "server/commands/watch_tests.h"
#include "server/commands/write_test.h"
#include "server/store/files.h"

namespace race::server {
namespace {

constexpr unsigned kReadableByAll = 0644;

struct Options {
  std::vector<std::string> paths;
  double seed = 1;
  bool seeded = false;  // it goes before those of the tests
  std::optional<std::string> junit, from, data;
  bool coverage = false, json = false, watch = false;
};

std::size_t count_failed(const std::vector<TestOutcome>& outcomes) {
  const auto failed = std::ranges::count_if(outcomes, [](const TestOutcome& each) { return !each.findings.empty(); });
  return static_cast<std::size_t>(failed);
}

void print(const TestOutcome& outcome) {
  std::printf("%s  %s: %s  (%.3f s of world time, seed %" PRIu64 ")\n", outcome.findings.empty() ? "ok  " : "FAIL",
              outcome.file.c_str(), outcome.name.c_str(), outcome.time, outcome.seed);
  for (const Finding& each : outcome.findings) std::printf("      %s: %s\n", each.path.c_str(), each.message.c_str());
}

std::string share(const char* what, const Coverage::Count& count) {
  const std::size_t percent = count.all == 0 ? 100 : 100 * count.covered / count.all;
  return std::string(what) + " " + std::to_string(count.covered) + " of " + std::to_string(count.all) + " (" +
         std::to_string(percent) + " %)";
}

// "Root/A.done never true", "Root/A action 1 never false".
std::string condition_text(const Value& missing) {
  const Value* action = missing.find("action");
  return missing.find("at")->as_string() + (action ? " action " + std::to_string(action->as_integer()) : "") +
         (missing.find("value")->as_bool() ? " never true" : " never false");
}

void print(const std::string& file, const Coverage& coverage) {
  std::printf("coverage of %s: %s, %s, %s\n", file.c_str(), share("states", coverage.states()).c_str(),
              share("ports", coverage.ports()).c_str(), share("values of conditions", coverage.conditions()).c_str());
  const Value json = coverage.json();
  for (const auto& [what, words] :
       {std::pair("states", "state never active: "), std::pair("ports", "port never fired: ")})
    for (const Value& missing : json.find(what)->find("missing")->as_list())
      std::printf("  %s%s\n", words, missing.as_string().c_str());
  for (const Value& missing : json.find("conditions")->find("missing")->as_list())
    std::printf("  condition %s\n", condition_text(missing).c_str());
}

Value json_of(const TestOutcome& outcome) {
  List findings;
  for (const Finding& each : outcome.findings)
    findings.emplace_back(Dict{{"path", each.path}, {"message", each.message}});
  return Dict{{"file", outcome.file},
              {"name", outcome.name},
              {"seed", static_cast<std::int64_t>(outcome.seed)},
              {"time", outcome.time},
              {"passed", outcome.findings.empty()},
              {"findings", std::move(findings)}};
}

void print_json(const std::vector<TestOutcome>& outcomes, const PreparedTests& prepared, bool with_coverage) {
  List tests;
  for (const TestOutcome& each : outcomes) tests.push_back(json_of(each));
  Dict out{{"tests", std::move(tests)}};
  if (with_coverage) {
    Dict coverage;
    for (const auto& [file, of_file] : prepared.coverage) coverage.set(file, of_file.json());
    out.set("coverage", std::move(coverage));
  }
  std::printf("%s\n", to_json(Value(std::move(out)), 1).c_str());
}

// What became of the tests of these files, which is printed; nothing: what is wrong was said, and no test counts.
std::optional<std::vector<TestOutcome>> run_files(const std::vector<std::string>& paths, const Options& options) {
  auto prepared = prepare_tests(paths);
  if (!prepared) return refuse(prepared.error(), options.json), std::nullopt;
  std::vector<TestOutcome> outcomes;
  for (const PreparedTest& each : prepared->tests) {
    const auto given = static_cast<std::uint64_t>(options.seed);
    const std::uint64_t seed = options.seeded ? given : each.test.seed.value_or(given);
    auto outcome = run_test(each, seed, prepared->coverage[each.model_file]);
    if (!outcome) return refuse(outcome.error(), options.json), std::nullopt;
    outcomes.push_back(std::move(*outcome));
    if (!options.json) print(outcomes.back());
  }
  if (options.json) {
    print_json(outcomes, *prepared, options.coverage);
  } else {
    std::printf("%zu tests, %zu failed\n", outcomes.size(), count_failed(outcomes));
    if (options.coverage)
      for (const auto& [file, coverage] : prepared->coverage) print(file, coverage);
  }
  return outcomes;
}

// Of all tests: the exit code, and the file of --junit.
int conclude(const std::vector<TestOutcome>& outcomes, const Options& options) {
  if (options.junit)
    if (auto written = write_file(*options.junit, junit_xml(outcomes), kReadableByAll); !written)
      return refuse(written.error());
  return count_failed(outcomes) == 0 ? kExitOk : kExitFindings;
}

int run_tests(const Options& options) {
  const auto outcomes = run_files(options.paths, options);
  return outcomes ? conclude(*outcomes, options) : kExitBadInput;
}

// A test that its own model and cell cannot have is not kept.
int make_test(const Options& options) {
  if (options.paths.size() != 1)
    return refuse(Error{ErrorCode::syntax, "with --from, it is one: the test file that is made", "FILE"}, options.json);
  const std::string& path = options.paths.front();
  if (auto written = write_test_of_run(path, *options.from, options.data); !written)
    return refuse(written.error(), options.json);
  if (const auto prepared = prepare_tests(options.paths); !prepared) {
    std::remove(path.c_str());
    return refuse(prepared.error(), options.json);
  }
  return run_tests(options);
}

int test(const Options& options) {
  const auto conflict = [&](const char* option, const char* message) {
    return refuse(Error{ErrorCode::conflict, message, option}, options.json);
  };
  if (options.data && !options.from)
    return conflict("--data", "is for --from: the folder of a server that keeps the run");
  if (options.watch && options.from) return conflict("--watch", "a test that is made runs once");
  if (options.watch && std::ranges::find(options.paths, kStandardInput) != options.paths.end())
    return conflict("--watch", "the standard input does not change");
  if (options.from) return make_test(options);
  if (options.watch)
    watch_tests(
        options.paths, [&](const auto& paths) { return run_files(paths, options); },
        [&](const auto& outcomes) { return conclude(outcomes, options); });
  return run_tests(options);
}

std::function<int()> declare(Arguments& arguments) {
  constexpr double kMaxSeed = 9007199254740992.0;  // 2^53: every integer up to it is a double
  const auto options = std::make_shared<Options>();
  arguments.files("FILE", options->paths, "NAME.test.json beside NAME.rcm.json, or a folder with such files");
  arguments.number("--seed", "N", options->seed, {0, kMaxSeed, true},
                   "of mocks and of the cell, for all tests; else each has its own, or this");
  arguments.text("--junit", "FILE", options->junit, "writes what became of each test as JUnit XML");
  arguments.flag("--watch", options->watch, "runs them again when they, their models or the cell change, until Ctrl-C");
  arguments.file("--from", "RUN", options->from,
                 "makes FILE: a test that this run, which was exported, comes to what it came to");
  arguments.text("--data", "DIR", options->data, "the folder of a server that keeps the run; RUN is its number");
  arguments.flag("--coverage", options->coverage, "tells which states, ports and conditions no test has come to");
  arguments.flag("--json", options->json, "prints all as JSON");
  return [options, &arguments] {
    options->seeded = arguments.given("--seed");
    return test(*options);
  };
}

}  // namespace

const Command kTest = {"test", "tests models by the files beside them, with mocks for services or in the cell",
                       declare};

}  // namespace race::server
