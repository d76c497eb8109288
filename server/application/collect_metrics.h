// What the parts of the application know and GET /metrics shows (server/metrics).
//
// Threads: any. Waits for no core, service or disk.
#pragma once

#include <string>

namespace race::server {

class AuditLog;
class Cell;
class Control;
class Cores;
class EventLog;
class Exposition;
class Hub;
class JournalWriter;

/// All outlive the application's sockets.
struct MetricSources {
  std::string store;  // the file of documents and runs
  Hub& hub;
  Cores& cores;
  Cell& cell;
  Control& control;
  JournalWriter& journals;
  AuditLog& audit;
  EventLog& log;
};

void collect_metrics(const MetricSources& sources, Exposition& to);

}  // namespace race::server
