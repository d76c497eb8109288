#include "server/commands/write_test.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "core/value/json.h"
#include "server/commands/input.h"
#include "server/commands/prepare_tests.h"
#include "server/commands/run_number.h"
#include "server/model_tests/test_of_run.h"
#include "server/runs/run_file.h"
#include "server/store/files.h"

namespace race::server {
namespace {

constexpr unsigned kReadableByAll = 0644;
constexpr double kMicroseconds = 1e6;  // in a second

// Of each macro step; none if one is not known.
std::vector<double> times_of(const std::vector<TimingBlock>& blocks, std::size_t steps) {
  std::vector<double> times;
  for (const TimingBlock& block : blocks) {
    if (!block.steps.empty() && block.first != times.size() + 1) return {};
    for (const StepTime& step : block.steps) times.push_back(static_cast<double>(step.time) / kMicroseconds);
  }
  if (times.size() < steps) return {};
  return times;
}

Checked<RecordedRun> of_file(const std::string& path) {
  const auto text = read_input(path);
  if (!text) return tl::unexpected(std::vector<Error>{text.error()});
  auto file = read_run_file_text(*text);
  if (!file) return tl::unexpected(std::move(file).error());
  auto times = times_of(file->timing, file->journal.entries.size());
  return RecordedRun{std::move(file->journal), std::move(times), std::move(file->services)};
}

Expected<RecordedRun> of_store(const std::string& data, const std::string& number) {
  ASSIGN_OR_RETURN(const RunId id, read_run_number(number, "--from"));
  ASSIGN_OR_RETURN(const auto runs, Runs::open_to_read(data + "/race.sqlite"));
  ASSIGN_OR_RETURN(const RunRecord record, runs->get(id));
  RecordedRun run;
  ASSIGN_OR_RETURN(run.journal, journal_of(record, *runs));
  ASSIGN_OR_RETURN(run.services, services_of(id, *runs));
  ASSIGN_OR_RETURN(const auto timing, timing_of(id, *runs));
  run.times = times_of(timing, run.journal.entries.size());
  return run;
}

Checked<RecordedRun> read_run(const std::string& run, const std::optional<std::string>& data) {
  if (!data) return of_file(run);
  auto stored = of_store(*data, run);
  if (!stored) return tl::unexpected(std::vector<Error>{std::move(stored).error()});
  return std::move(*stored);
}

}  // namespace

tl::expected<void, FileErrors> write_test_of_run(const std::string& path, const std::string& run,
                                                 const std::optional<std::string>& data) {
  const auto fail = [](const std::string& file, std::vector<Error> errors) {
    return tl::unexpected(FileErrors{file, std::move(errors)});
  };
  if (!path.ends_with(kTestEnding)) return fail(path, {{ErrorCode::name, "is to be called NAME.test.json"}});
  if (std::error_code error; std::filesystem::exists(path, error))
    return fail(path, {{ErrorCode::conflict, "is there already: a test of a run has a file of its own"}});
  const std::string source = data ? "" : run;
  const auto recorded = read_run(run, data);
  if (!recorded) return fail(source, recorded.error());
  const auto test = test_of_run("as run " + std::filesystem::path(run).filename().string(), *recorded);
  if (!test) return fail(source, {test.error()});
  const std::string text = to_json(*test, 2) + '\n';
  if (const auto file = read_test_text(text); !file) return fail(path, file.error());
  if (const auto written = write_file(path, text, kReadableByAll); !written) return fail("", {written.error()});
  return {};
}

}  // namespace race::server
