#include "server/threads/worker.h"

#include <algorithm>
#include <utility>

#include "services/failures.h"

namespace race::server {

void Worker::post(std::shared_ptr<Piece> piece) {
  if (!add(piece)) return piece->refuse({ErrorCode::unavailable, "there is no room for more replays now; ask again"});
  deadlines_.after(kTurn, [weak = std::weak_ptr(piece)] {
    const auto late = weak.lock();
    if (!late || !late->decide()) return;
    late->refuse({ErrorCode::unavailable, "other replays take long; ask again"});
    *late->stop = true;
  });
}

// False: there is no room for it.
bool Worker::add(const std::shared_ptr<Piece>& piece) {
  const services::MutexLock lock(mutex_);
  if (stopped_ || pieces_.size() >= kMost) return false;
  pieces_.reserve(kMost);
  pool_.post([this, piece] {
    if (piece->decide()) services::run_reporting("a replay", [&] { execute(piece); });
    services::run_reporting("a replay", [&] {
      piece->refuse({ErrorCode::unavailable, "the replay was stopped"});  // or is answered
    });
    const services::MutexLock done(mutex_);
    std::erase(pieces_, piece);
  });
  pieces_.push_back(piece);  // under the lock: before its work is over
  return true;
}

void Worker::execute(const std::shared_ptr<Piece>& piece) {
  deadlines_.after(piece->limit.time, [weak = std::weak_ptr(piece)] {
    const auto late = weak.lock();
    if (!late) return;
    late->refuse(late->limit.late);
    *late->stop = true;
  });
  if (!*piece->stop && !services::run_reporting("a replay", piece->work))
    piece->refuse({ErrorCode::unavailable, "the replay failed; see the server's log"});
}

void Worker::stop() {
  const services::MutexLock lock(mutex_);
  stopped_ = true;
  for (const auto& piece : pieces_) *piece->stop = true;
}

void Worker::end() {
  stop();
  pool_.end();
}

}  // namespace race::server
