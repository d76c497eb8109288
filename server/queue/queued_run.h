// A run that waits its turn, runs, or is over; as clients see it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/accounts/role.h"

namespace race::server {

enum class QueuedStatus : std::uint8_t { waiting, running, ended, refused, cancelled };

/// What somebody wants to be run.
struct QueuedTask {
  std::string document;
  std::int64_t revision = 1;
  Dict arguments = {};        // of the root's parameters
  std::string name = {};      // for people; may be empty
  bool goes_on = false;       // the queue does not pause if the run faults
  Identity by = {};           // who wants it
  std::uint64_t control = 0;  // their number, if they have the controls (Control)
  // How many backups had been restored before the document was read (RunQueue::restores): the revision is of that
  // store.
  std::uint64_t restores = 0;
};

struct QueuedRun {
  std::int64_t id = 0;
  QueuedTask task = {};
  QueuedStatus status = QueuedStatus::waiting;
  std::string core = {};           // which is the number of the run; empty: there is none
  std::string end = {};            // "ended", "faulted" or "aborted"
  std::string outcome = {};        // port through which the root was left
  std::vector<Error> errors = {};  // why it was refused
};

/// schemas/queued_run.json
Value queued_run_json(const QueuedRun& run);

}  // namespace race::server
