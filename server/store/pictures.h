// Pictures: what cameras saw while a run was running, to look at it again. At most kMost of a run, thinned out as
// samples are (thinning.h).
//
// Threads: any; one at a time inside.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/store/runs.h"
#include "services/mutex.h"

namespace race::server {

/// schemas/run_picture.json.
struct Picture {
  std::string service;     // the key of the camera
  std::uint64_t step = 0;  // macro steps that had begun
  double time = 0;         // [s] of the camera
  std::string jpeg;        // base64; empty in a list
};

/// A picture by its number, from 0, in order of time.
struct NumberedPicture {
  std::int64_t number = 0;
  Picture picture;
};

class Pictures {
 public:
  static constexpr std::size_t kMost = 400;            // of a run
  static constexpr std::size_t kLongest = 64U << 10U;  // characters of base64
  static constexpr std::size_t kLongestService = 100;  // characters of a key

  /// Opens the store (DataFolder::store). Error of all: `storage`, `io`; `corrupt`, naming the run and the picture.
  static Expected<std::unique_ptr<Pictures>> open(const std::string& path);
  ~Pictures();

  /// The next pictures of a run. Keeps those whose turn it is. Of a run that is not there, none are kept.
  Expected<void> append(RunId run, const std::vector<Picture>& pictures) EXCLUDES(mutex_);
  /// Those that were kept, in order, without what is on them; their digests are not checked.
  Expected<std::vector<NumberedPicture>> list(RunId run) EXCLUDES(mutex_);
  /// One of them. Error also: `not_found`.
  Expected<Picture> read(RunId run, std::int64_t number) EXCLUDES(mutex_);
  /// All, whole.
  Expected<std::vector<Picture>> read_all(RunId run) EXCLUDES(mutex_);

 private:
  explicit Pictures(std::unique_ptr<SQLite::Database> file);
  services::Mutex mutex_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
};

}  // namespace race::server
