#include "server/commands/watch_tests.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <thread>
#include <utility>

#include "server/commands/command.h"
#include "server/commands/input.h"
#include "server/commands/prepare_tests.h"
#include "server/commands/watching.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

// Of each file that a test file depends on and that is there: when it was written, and its size [bytes].
using Stamps = std::map<fs::path, std::pair<fs::file_time_type, std::uintmax_t>>;

void add_stamp(const fs::path& file, Stamps& stamps) {
  std::error_code no_time, no_size;
  const auto time = fs::last_write_time(file, no_time);
  const auto size = fs::file_size(file, no_size);
  if (!no_time && !no_size) stamps[file] = {time, size};
}

bool is_of_cell(const std::string& file) {
  return (file.ends_with(".json") || file.ends_with(".urdf")) && !file.ends_with(kTestEnding) &&
         !file.ends_with(kModelEnding);
}

Stamps stamps_of(const std::string& test_file) {
  Stamps stamps;
  add_stamp(test_file, stamps);
  const auto text = read_input(test_file);
  if (!text) return stamps;
  const auto file = read_test_text(*text);
  if (!file) return stamps;
  const auto model = model_file_of(test_file, *file);
  if (!model) return stamps;
  add_stamp(*model, stamps);
  const fs::path folder = fs::path(test_file).parent_path();
  for (const ModelTest& test : file->tests)
    for (const auto& [key, script] : test.services)
      if (script.rsm) add_stamp(folder / *script.rsm, stamps);
  std::error_code error;
  const fs::path cell = fs::path(*model).parent_path();
  for (fs::directory_iterator entry(cell.empty() ? "." : cell, error), end; !error && entry != end;
       entry.increment(error))
    if (is_of_cell(entry->path().string())) add_stamp(entry->path(), stamps);
  return stamps;
}

std::map<std::string, Stamps> look_at(const std::vector<std::string>& paths) {
  std::map<std::string, Stamps> all;
  for (const std::string& path : paths)
    for (const std::string& file : test_files(path)) all.emplace(file, stamps_of(file));
  return all;
}

// What is known of the files and of their last run.
class WatchedTests {
 public:
  WatchedTests(const std::vector<std::string>& paths, const RunTestFiles& run, const ConcludeTests& conclude)
      : paths_(paths), run_(run), conclude_(conclude) {}

  /// Runs what has changed since; the exit code, if anything has. They are looked at before they are run: what changes
  /// meanwhile is seen.
  std::optional<int> round() {
    std::map<std::string, Stamps> now = look_at(paths_);
    bool is_same = now.size() == known_.size();
    std::vector<std::string> concerned;
    for (const auto& [file, stamps] : now) {
      const auto before = known_.find(file);
      const bool is_changed = before == known_.end() || before->second != stamps;
      is_same = is_same && !is_changed;
      if (is_changed || refused_.contains(file)) concerned.push_back(file);
    }
    known_ = std::move(now);
    if (is_same) return {};
    std::erase_if(outcomes_, [&](const auto& entry) { return !known_.contains(entry.first); });
    run(concerned);
    return refused_.empty() ? conclude_(all_outcomes()) : kExitBadInput;
  }

 private:
  void run(const std::vector<std::string>& files) {
    refused_.clear();
    if (files.empty()) return;
    auto outcomes = run_(files);
    if (!outcomes) return refused_.insert(files.begin(), files.end());
    for (const std::string& file : files) outcomes_[file].clear();
    for (TestOutcome& each : *outcomes) outcomes_[each.file].push_back(std::move(each));
  }

  std::vector<TestOutcome> all_outcomes() const {
    std::vector<TestOutcome> all;
    for (const auto& [file, outcomes] : outcomes_) all.insert(all.end(), outcomes.begin(), outcomes.end());
    return all;
  }

  const std::vector<std::string>& paths_;
  const RunTestFiles& run_;
  const ConcludeTests& conclude_;
  std::map<std::string, Stamps> known_;
  std::set<std::string> refused_;                             // with one that is wrong, in the last round
  std::map<std::string, std::vector<TestOutcome>> outcomes_;  // the last ones of each file
};

}  // namespace

void watch_tests(const std::vector<std::string>& paths, const RunTestFiles& run, const ConcludeTests& conclude) {
  end_on_signal(kExitOk);
  WatchedTests tests(paths, run, conclude);
  for (;; std::this_thread::sleep_for(kPollPause)) {
    const std::optional<int> code = tests.round();
    if (!code) continue;
    end_on_signal(*code);
    std::fprintf(stderr, "waiting for changes; Ctrl-C ends it, with exit code %d\n", *code);
  }
}

}  // namespace race::server
