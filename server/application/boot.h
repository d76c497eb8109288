// What the server starts by itself when it begins.
//
// Threads: the one that makes the application.
#pragma once

#include "services/clock.h"

namespace race::server {

class BootList;
class Cores;
class Documents;
class EventLog;
class Runs;

/// What boot() uses.
struct BootResources {
  BootList& list;
  Documents& documents;
  Runs& runs;
  Cores& cores;
  EventLog& log;
  const services::Clock& clock;  // of the log
};

/// Creates and starts a core for each entry of the boot list, in order, unless its document has a run that is not over:
/// one that was interrupted waits for a person, also if it could not be rebuilt. So nothing moves by itself after a
/// crash. Logs each; what cannot be started is logged with its errors, and the others are started all the same.
/// Requires that Cores has recovered its runs.
void boot(const BootResources& resources);

}  // namespace race::server
