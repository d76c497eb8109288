#include "server/commands/write_test.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "server/commands/input.h"
#include "server/commands/prepare_tests.h"
#include "server/commands/run_number.h"
#include "server/model_tests/recorded_run.h"
#include "server/runs/run_file.h"
#include "server/store/files.h"

namespace race::server {
namespace {

constexpr unsigned kReadableByAll = 0644;

Checked<RecordedRun> of_file(const std::string& path) {
  const auto text = read_input(path);
  if (!text) return tl::unexpected(std::vector<Error>{text.error()});
  auto file = read_run_file_text(*text);
  if (!file) return tl::unexpected(std::move(file).error());
  return recorded_run(std::move(*file));
}

Expected<RecordedRun> of_store(const std::string& data, const std::string& number) {
  ASSIGN_OR_RETURN(const RunId id, read_run_number(number, "--from"));
  ASSIGN_OR_RETURN(const auto runs, Runs::open_to_read(data + "/race.sqlite"));
  return recorded_run(id, *runs);
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
  const auto text = test_of_run("as run " + std::filesystem::path(run).filename().string(), *recorded);
  if (!text) return fail(source, text.error());
  if (const auto written = write_file(path, *text, kReadableByAll); !written) return fail("", {written.error()});
  return {};
}

}  // namespace race::server
