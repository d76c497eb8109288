// What it takes until a macro step is durable, in milliseconds of wall-clock time, beside a bare commit of SQLite on
// the same disk in the same run: one insert of as many bytes, with the same settings. Then many runs at once: how many
// entries share a commit. Usage: journal_bench [FOLDER [seconds]]; a folder of the disk that is to be measured.
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/execution/execution.h"
#include "core/rcm/document.h"
#include "core/rcm/native.h"
#include "core/rcm/translate.h"
#include "core/rsm/document.h"
#include "core/value/json.h"
#include "server/store/data_folder.h"
#include "server/store/journal_writer.h"
#include "server/store/runs.h"
#include "services/sqlite/digest.h"
#include "services/sqlite/file.h"

namespace race::bench {
namespace {

using Clock = std::chrono::steady_clock;
using server::JournalWriter;
using server::Runs;

double milliseconds(Clock::duration d) { return std::chrono::duration<double, std::milli>(d).count(); }

double quantile(std::vector<double> sorted, double q) {
  std::ranges::sort(sorted);
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(q * static_cast<double>(sorted.size())))];
}

void print_row(const char* what, const std::vector<double>& ms) {
  std::printf("%-36s %9zu %9.3f %9.3f %9.3f\n", what, ms.size(), quantile(ms, 0.5), quantile(ms, 0.99),
              quantile(ms, 1));
}

// Two states that each event of `t` takes in turn.
execution::JournalHeader tiny_header() {
  static constexpr const char* kDocument = R"json({"rcm": 1, "name": "tiny", "services": {"t": "timer"}, "root": {
    "state": "Root", "first": "Ping", "children": [
      {"state": "Ping", "ports": [{"name": "on", "when": "svc.t.tick", "to": "Pong"}]},
      {"state": "Pong", "ports": [{"name": "on", "when": "svc.t.tick", "to": "Ping"}]}]}})json";
  static constexpr const char* kTimer = R"({"operations": [], "events": [{"name": "tick"}]})";
  const rcm::Document document = rcm::read_document_text(kDocument).value();
  const rcm::NativeModel native = rcm::translate(document).value();
  auto program = semantics::Program::build(native, {{"t", rsm::read_service_text(kTimer, "timer").value()}}).value();
  Value json = rcm::write_native(document, native);
  return {json.freeze(), std::move(program), {}, {}};
}

/// A hosted run without its core: it makes macro steps, and hears when they are durable.
class Load final : public server::RunSink {
 public:
  static std::shared_ptr<Load> create(Runs& runs, JournalWriter& writer, const execution::JournalHeader& header) {
    auto load = std::shared_ptr<Load>(new Load(writer, header));
    const auto record = runs.create({"tiny", 1, header, {}}, 0).value();
    load->journal_ = std::make_shared<server::RunJournal>(record, load);
    load->append(load->execution_.start({}).entry.value());
    load->wait_until_durable();
    const std::lock_guard lock(load->mutex_);
    load->waited_.clear();
    return load;
  }

  /// One macro step; its entry is on its way to the disk.
  void step() {
    begun_ = Clock::now();
    execution_.post_event("t", "tick", Dict{{"n", static_cast<std::int64_t>(ticket_)}});
    append(execution_.step({}).entry.value());
  }
  void wait_until_durable() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return durable_ == ticket_; });
  }
  /// From the beginning of each macro step until it was durable; without the start.
  std::vector<double> waited() {
    const std::lock_guard lock(mutex_);
    return waited_;
  }

  void durable(std::uint64_t ticket) override {
    const std::lock_guard lock(mutex_);
    for (; durable_ < ticket; ++durable_) waited_.push_back(milliseconds(Clock::now() - appended_[durable_]));
    changed_.notify_one();
  }
  void stalled(const Error& error) override { failed(error); }
  void failed(const Error& error) override {
    std::fprintf(stderr, "%s\n", to_string(error).c_str());
    std::exit(1);
  }

 private:
  Load(JournalWriter& writer, const execution::JournalHeader& header)
      : writer_(writer), execution_(execution::Execution::create(header.program, {}, header.budgets).value()) {}

  void append(execution::JournalEntry entry) {
    {
      const std::lock_guard lock(mutex_);
      appended_.push_back(begun_);
    }
    writer_.append(journal_, {.ticket = ++ticket_, .entry = std::move(entry)});
  }

  JournalWriter& writer_;
  execution::Execution execution_;
  std::shared_ptr<server::RunJournal> journal_;
  std::uint64_t ticket_ = 0;
  Clock::time_point begun_ = Clock::now();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t durable_ = 0;
  std::vector<Clock::time_point> appended_;  // by ticket, from 1: when its macro step began
  std::vector<double> waited_;
};

/// A table of its own in a file of its own: what one commit of one row costs here.
class BareCommit {
 public:
  BareCommit(const std::string& path, std::size_t bytes) : file_(sqlite::open(path)), text_(bytes, 'x') {
    file_->exec(
        "CREATE TABLE entry (run INTEGER, position INTEGER, text TEXT, PRIMARY KEY (run, position)) WITHOUT ROWID");
    insert_ = std::make_unique<SQLite::Statement>(*file_, "INSERT INTO entry VALUES (1, ?, ?)");
  }
  double commit() {
    const auto begin = Clock::now();
    insert_->bind(1, ++position_);
    insert_->bind(2, text_);
    insert_->exec();  // in a transaction of its own
    insert_->reset();
    return milliseconds(Clock::now() - begin);
  }

 private:
  std::unique_ptr<SQLite::Database> file_;
  std::unique_ptr<SQLite::Statement> insert_;
  const std::string text_;
  std::int64_t position_ = 0;
};

// In turn, so that both see the same disk.
void measure_one_run(Load& load, BareCommit& bare, int rounds) {
  std::vector<double> commits;
  for (int i = 0; i < rounds; ++i) {
    load.step();
    load.wait_until_durable();
    commits.push_back(bare.commit());
  }
  std::printf("%-36s %9s %9s %9s %9s\n", "ms until durable, one run", "n", "p50", "p99", "max");
  print_row("macro step with its entry", load.waited());
  print_row("bare SQLite commit", commits);
  const std::vector<double> waited = load.waited();
  std::printf("%-36s %9s %9.2f %9.2f\n\n", "quotient", "", quantile(waited, 0.5) / quantile(commits, 0.5),
              quantile(waited, 0.99) / quantile(commits, 0.99));
}

// Each run makes a step every 100 ms; `spread`: the runs one after the other in these 100 ms, else all at once.
void measure_many_runs(Runs& runs, JournalWriter& writer, const execution::JournalHeader& header, int seconds,
                       bool spread) {
  constexpr int kRuns = 100;
  constexpr auto kPeriod = std::chrono::milliseconds(100);
  std::vector<std::shared_ptr<Load>> loads;
  for (int i = 0; i < kRuns; ++i) loads.push_back(Load::create(runs, writer, header));
  const auto before = writer.commits();
  const auto begin = Clock::now();
  for (int period = 0; period < 10 * seconds; ++period)
    for (int i = 0; i < kRuns; ++i) {
      std::this_thread::sleep_until(begin + period * kPeriod + (spread ? i * kPeriod / kRuns : Clock::duration()));
      loads[static_cast<std::size_t>(i)]->step();
    }
  std::vector<double> waited;
  for (const auto& load : loads) {
    load->wait_until_durable();
    for (const double ms : load->waited()) waited.push_back(ms);
  }
  const double took = milliseconds(Clock::now() - begin) / 1000;
  const auto after = writer.commits();
  const auto entries = static_cast<double>(after.entries - before.entries),
             commits = static_cast<double>(after.commits - before.commits);
  std::printf("%-36s %9.0f %9.0f %9.1f %9.3f %9.3f\n", spread ? "one after the other" : "all at once", entries / took,
              commits / took, entries / commits, quantile(waited, 0.5), quantile(waited, 0.99));
}

void measure(const std::filesystem::path& path, int seconds) {
  const auto folder = server::DataFolder::open(path).value();
  const auto runs = Runs::open(folder.store()).value();
  const auto writer = JournalWriter::open(folder.store()).value();
  const execution::JournalHeader header = tiny_header();
  const std::string input = to_json(execution::input_json(execution::EventEntry{"t", "tick", Dict{{"n", 1000}}}));
  BareCommit bare(path / "bare.sqlite", input.size() + sizeof(sqlite::Digest));
  const auto one = Load::create(*runs, *writer, header);
  std::printf("%s, entries of %zu bytes\n", path.c_str(), input.size());
  measure_one_run(*one, bare, 200 * seconds);
  std::printf("%-36s %9s %9s %9s %9s %9s\n", "100 runs at 10 steps/s", "entries/s", "commits/s", "per comm.", "p50 ms",
              "p99 ms");
  measure_many_runs(*runs, *writer, header, seconds, true);
  measure_many_runs(*runs, *writer, header, seconds, false);
}

}  // namespace
}  // namespace race::bench

int main(int argc, char** argv) {
  const std::filesystem::path place = argc > 1 ? argv[1] : ".";
  const auto folder = place / ("journal_bench_" + std::to_string(::getpid()));
  race::bench::measure(folder, argc > 2 ? std::max(1, std::atoi(argv[2])) : 5);
  std::filesystem::remove_all(folder);
}
