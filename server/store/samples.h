// Samples: where everything in the cell was while a run was running, to look at it again. At most kMost of a run: when
// there are more, every second one is dropped, and from then on only every second one is kept.
//
// Threads: any; one at a time inside.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/store/runs.h"
#include "services/mutex.h"

namespace race::server {

struct Sample {
  std::uint64_t step = 0;  // macro steps that had begun
  Value pose;              // schemas/cell_pose.json, with the world's time; frozen
};

class Samples {
 public:
  static constexpr std::size_t kMost = 2000;  // of a run

  /// Opens the store (DataFolder::store). Error of all: `storage`, `io`; `corrupt`, naming the run and the sample.
  static Expected<std::unique_ptr<Samples>> open(const std::string& path);
  ~Samples();

  /// The next samples of a run. Keeps those whose turn it is. Of a run that is not there, none are kept.
  Expected<void> append(RunId run, const std::vector<Sample>& samples) EXCLUDES(mutex_);
  /// Those that were kept, in order.
  Expected<std::vector<Sample>> read(RunId run) EXCLUDES(mutex_);

 private:
  explicit Samples(std::unique_ptr<SQLite::Database> file);
  services::Mutex mutex_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
};

}  // namespace race::server
