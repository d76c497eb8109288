#include "server/commands/watch_tests.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
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

}  // namespace

// They are looked at before they are run: what changes meanwhile is seen.
void watch_tests(const std::vector<std::string>& paths, const RunTestFiles& run) {
  end_on_signal(kExitOk);
  std::map<std::string, Stamps> known;
  std::map<std::string, int> codes;
  for (;; std::this_thread::sleep_for(kPollPause)) {
    std::map<std::string, Stamps> now = look_at(paths);
    std::vector<std::string> concerned;
    for (const auto& [file, stamps] : now)
      if (const auto before = known.find(file); before == known.end() || before->second != stamps)
        concerned.push_back(file);
    const bool is_same = concerned.empty() && now.size() == known.size();
    known = std::move(now);
    if (is_same) continue;
    if (!concerned.empty()) {
      const int code = run(concerned);
      for (const std::string& file : concerned) codes[file] = code;
    }
    std::erase_if(codes, [&](const auto& entry) { return !known.contains(entry.first); });
    int worst = kExitOk;
    for (const auto& [file, code] : codes) worst = std::max(worst, code);
    end_on_signal(worst);
    std::fprintf(stderr, "waiting for changes; Ctrl-C ends it, with exit code %d\n", worst);
  }
}

}  // namespace race::server
