// Publications: what is published on channels and waits for the hub's strand, one of each channel in turn: a channel on
// which much is published delays no other. Beyond a bound a channel overflows: what is published on it is dropped until
// the hub begins it anew, with a snapshot in the place of all that was dropped. So who publishes never waits, and a hub
// that is slower than they are does not grow.
//
// Threads: any.
#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/value/value.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

/// A value (frozen), or its JSON: what is large is serialised by who publishes it, and holds up nothing on the strand.
struct Publication {
  static constexpr std::size_t kLargeUnits = 4096;
  static Publication of(Value data);
  Value data;
  std::shared_ptr<const std::string> json;  // then there is no `data`
  bool empty() const { return !json && data.is_null(); }
};

class Publications {
 public:
  /// Publications of a channel that wait, and units of their values (Value::size_units()). With so many, the next one
  /// has no place; the last one may be as large as it is.
  static constexpr std::size_t kMost = 256;
  static constexpr std::size_t kMostUnits = 4 * 1024 * 1024;
  static constexpr std::size_t kAllUnits = 32 * 1024 * 1024;  // of all channels

  enum class Kind { delta, snapshot, replacement };
  struct Overflow {
    Publication newest;  // what was dropped last, or was to be published when it failed
    bool asks;           // for a snapshot; else one follows
  };
  /// Called on the strand: subscribers of the channel lack what was published.
  using BeginAnew = std::function<void(const std::string& channel, const Overflow& overflow)>;

  /// The strand outlives this and finishes before it ends.
  Publications(Strand& strand, BeginAnew begin_anew) : strand_(strand), begin_anew_(std::move(begin_anew)) {}

  /// Whether post() would do so now.
  bool has_room(const std::string& channel, Kind kind) const EXCLUDES(mutex_);
  /// Posts `work`, which publishes `what`, of so many units; or drops it, as it does without work, and posts that the
  /// channel begins anew. One snapshot
  /// waits all the same, so that subscribers see something however fast deltas come; if deltas are dropped after it,
  /// the channel begins anew after it, too. A further snapshot is dropped: what waits leads to it. A channel also
  /// begins anew if `work` throws and is no snapshot: asking for that again might go on for ever.
  void post(const std::string& channel, Kind kind, Publication what, std::size_t units, Work work) EXCLUDES(mutex_);
  /// On the strand: what waits on the channel is not told.
  void forget(const std::string& channel) EXCLUDES(mutex_);
  /// Units of all that waits.
  std::size_t units() const EXCLUDES(mutex_);

 private:
  /// What is done on the strand for a channel; without work: it begins anew.
  struct Piece {
    Work work;
    Kind kind = Kind::delta;
    Publication what;
    std::size_t units = 0;
    bool fitted = false;
  };
  struct Waiting {
    std::deque<Piece> pieces;
    std::size_t units = 0;      // of those with work
    bool has_snapshot = false;  // one that waits though it did not fit
    std::size_t overflows = 0;  // how often the channel will begin anew; until then nothing fits
    Publication newest;         // that was dropped
    bool ends_anew() const { return !pieces.empty() && !pieces.back().work; }
  };
  using Channels = std::map<std::string, Waiting>;

  bool add(const std::string& channel, Kind kind, Publication what, std::size_t units, Work work) EXCLUDES(mutex_);
  bool fits(const Waiting& waiting) const REQUIRES(mutex_);
  bool takes(const Waiting& waiting, Kind kind) const REQUIRES(mutex_);
  void add(Channels::iterator channel, Piece piece) REQUIRES(mutex_);
  /// A piece of the channel whose turn it is.
  void do_next() EXCLUDES(mutex_);
  void begin(Waiting& waiting, const Piece& piece) REQUIRES(mutex_);
  Overflow take_overflow(Waiting& waiting) REQUIRES(mutex_);

  Strand& strand_;
  const BeginAnew begin_anew_;
  mutable services::Mutex mutex_;
  Channels channels_ GUARDED_BY(mutex_);                     // that have pieces
  std::deque<Channels::iterator> turns_ GUARDED_BY(mutex_);  // of those, each once
  std::size_t units_ GUARDED_BY(mutex_) = 0;
  std::atomic<std::size_t> missing_turns_{0};  // of the strand, for which there was no memory
};

}  // namespace race::server
