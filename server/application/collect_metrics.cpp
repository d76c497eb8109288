#include "server/application/collect_metrics.h"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "server/accounts/audit_log.h"
#include "server/cell/cell.h"
#include "server/control/control.h"
#include "server/execution/cores.h"
#include "server/log/event_log.h"
#include "server/metrics/exposition.h"
#include "server/store/journal_writer.h"
#include "server/stream/hub.h"
#include "server/wire/calendar.h"
#include "server/wire/version.h"

namespace race::server {
namespace {

const std::int64_t kStarted = now_ms();
constexpr std::array<std::string_view, 7> kStatuses = {"ready",   "running", "interrupted", "ended",
                                                       "faulted", "aborted", "other"};

template <typename Number>
double number(Number value) {
  return static_cast<double>(value);
}

double seconds(const timeval& time) { return number(time.tv_sec) + number(time.tv_usec) * 1e-6; }

// The field of /proc/self/status, whose values are numbers; 0: there is none.
double of_status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(name + ':')) return std::strtod(line.c_str() + name.size() + 1, nullptr);
  return 0;
}

double open_files() {
  std::error_code failed;
  double count = 0;
  auto entry = std::filesystem::directory_iterator("/proc/self/fd", failed);
  for (; !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) ++count;
  return std::max(0.0, count - 1);  // but for the one that reads them
}

void add_process(Exposition& to) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  to.family("race_build_info", "gauge", "1, with the version of the program.");
  to.sample("race_build_info", {{"version", version()}}, 1);
  to.single("race_uptime_seconds", "gauge", "Since the server began.", number(now_ms() - kStarted) * 1e-3);
  to.single("process_start_time_seconds", "gauge", "When it began, since 1970.", number(kStarted) * 1e-3);
  to.single("process_cpu_seconds_total", "counter", "Processor time of the server.",
            seconds(used.ru_utime) + seconds(used.ru_stime));
  to.single("process_resident_memory_bytes", "gauge", "Memory that the server holds.", of_status("VmRSS") * 1024);
  to.single("process_threads", "gauge", "Threads of the server.", of_status("Threads"));
  to.single("process_open_fds", "gauge", "Files and sockets that are open.", open_files());
}

void add_cores(const Cores& cores, Exposition& to) {
  std::map<std::string_view, double> by_status;
  double waiting = 0;
  for (const auto& core : cores.all()) {
    const Value info = core->info();
    const Value* status = info.find("status");
    const Value* inputs = info.find("waiting");
    const auto known = std::ranges::find(kStatuses, status ? std::string_view(status->as_string()) : "");
    ++by_status[known == kStatuses.end() ? kStatuses.back() : *known];
    if (inputs) waiting += inputs->to_double();
  }
  to.family("race_cores", "gauge", "Cores, by the status of their run.");
  for (const std::string_view status : kStatuses) to.sample("race_cores", {{"status", status}}, by_status[status]);
  to.single("race_core_waiting_inputs", "gauge", "Inputs that cores have not taken yet.", waiting);
}

void add_store(const MetricSources& from, Exposition& to) {
  const auto [commits, entries] = from.journals.commits();
  to.single("race_journal_entries_total", "counter", "Macro steps of all runs that are durable, since the start.",
            number(entries));
  to.single("race_journal_commits_total", "counter", "Transactions that have made them durable.", number(commits));
  to.family("race_store_size_bytes", "gauge", "Documents and runs on the disk: the file, and its log.");
  for (const std::string part : {"", "-wal"}) {
    std::error_code absent;
    const auto size = std::filesystem::file_size(from.store + part, absent);
    to.sample("race_store_size_bytes", {{"file", "race.sqlite" + part}}, absent ? 0 : number(size));
  }
  to.single("race_audit_waiting_rows", "gauge", "Rows of the audit log that wait for the disk.",
            number(from.audit.waiting()));
}

void add_services(const services::Host& host, Exposition& to) {
  const auto all = host.services();
  to.family("race_service_available", "gauge", "1: the service is there; 0: it is not.");
  for (const auto& each : all) to.sample("race_service_available", {{"service", each.key}}, each.available ? 1 : 0);
  to.family("race_service_pending_calls", "gauge", "Calls that the service has not answered yet.");
  for (const auto& each : all)
    to.sample("race_service_pending_calls", {{"service", each.key}}, number(each.pending_count));
}

void add_cell(const MetricSources& from, Exposition& to) {
  const Cell::Lateness late = from.cell.lateness();
  to.single("race_cell_steps_total", "counter", "Steps of the cell, of 1 ms.", number(late.steps));
  to.single("race_cell_late_steps_total", "counter", "Steps that began more than 1 ms too late.", number(late.late));
  to.single("race_cell_largest_lateness_seconds", "gauge", "How late a step has begun at most, since the start.",
            number(late.largest.count()) * 1e-6);
  to.single("race_cell_stopped", "gauge", "1: the cell was stopped, and not reset.", from.control.stopped() ? 1 : 0);
}

}  // namespace

void collect_metrics(const MetricSources& sources, Exposition& to) {
  add_process(to);
  to.single("race_stream_message_bytes", "gauge", "Messages that channels keep and clients have not taken.",
            number(sources.hub.message_bytes()));
  to.single("race_stream_waiting_units", "gauge", "Units of values that were published and are not told yet.",
            number(sources.hub.waiting_units()));
  add_cores(sources.cores, to);
  add_store(sources, to);
  add_services(sources.cell.host(), to);
  add_cell(sources, to);
  to.family("race_log_lines_total", "counter", "Lines of the log, by level, whether or not they were written.");
  for (const std::string_view level : log_level_names())
    to.sample("race_log_lines_total", {{"level", level}}, number(sources.log.lines(*log_level_of(level))));
}

}  // namespace race::server
