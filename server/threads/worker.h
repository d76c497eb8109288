// Worker: a thread of its own for work that may take long, such as replays, so that it delays nothing else. Its queue
// is bounded, each piece of work has a bounded time, and work that nobody waits for any more is told to stop. Who asks
// is answered later, and waits on no thread.
//
// Threads: any but its own.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "server/threads/deadlines.h"
#include "server/threads/done.h"
#include "server/threads/stop.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class Worker {
 public:
  /// Pieces of work that wait or are done. Each may hold the file of a run (16 MiB).
  static constexpr std::size_t kMost = 8;
  static constexpr std::chrono::seconds kTurn{5};  // until a piece begins

  /// The deadlines outlive it.
  explicit Worker(Deadlines& deadlines) : deadlines_(deadlines) {}
  ~Worker() { end(); }

  /// How long a piece may take, and the error if it takes longer.
  struct Limit {
    std::chrono::milliseconds time;
    Error late;
  };
  /// Does `function(*stop)` when what was asked before is done, and gives its value to `done`, on the worker's thread.
  /// Whoever sets `stop` says that nobody waits: the function should return soon, and is not called if it has not
  /// begun. If it does not begin within kTurn or takes longer than its limit, `done` gets an error, on the thread of
  /// the deadlines, and `stop` becomes true; the function may go on until then, so it must own what it uses. Errors:
  /// `unavailable`: there are kMost pieces of work, its turn does not come, nobody waits for it, it threw, or the
  /// worker is stopped; `limit.late`.
  template <typename T, typename E = Error>
  void ask(std::type_identity_t<std::function<tl::expected<T, E>(const Stop&)>> function, Limit limit, SharedStop stop,
           std::type_identity_t<Done<T, E>> done);

  /// What is asked is told to stop, and nothing begins any more.
  void stop() EXCLUDES(mutex_);
  /// stop(), and waits for the work that is being done.
  void end();

 private:
  struct Piece {
    SharedStop stop;
    Limit limit;
    Work work;                                 // gives its value to who asked
    std::function<void(const Error&)> refuse;  // who asked, if nothing was given
    std::atomic<bool> decided{false};          // it has begun, or has waited too long
    bool decide() { return !decided.exchange(true); }
  };
  void post(std::shared_ptr<Piece> piece) EXCLUDES(mutex_);
  bool add(const std::shared_ptr<Piece>& piece) EXCLUDES(mutex_);
  void execute(const std::shared_ptr<Piece>& piece) EXCLUDES(mutex_);

  Deadlines& deadlines_;
  services::Mutex mutex_;
  std::vector<std::shared_ptr<Piece>> pieces_ GUARDED_BY(mutex_);  // that wait or are done
  bool stopped_ GUARDED_BY(mutex_) = false;
  Pool pool_{1, 0, "replays"};
};

template <typename T, typename E>
void Worker::ask(std::type_identity_t<std::function<tl::expected<T, E>(const Stop&)>> function, Limit limit,
                 SharedStop stop, std::type_identity_t<Done<T, E>> done) {
  auto once = std::make_shared<Once<T, E>>(std::move(done));
  auto piece = std::make_shared<Piece>();
  piece->limit = std::move(limit);
  piece->refuse = [once](const Error& error) { (*once)(refused<E>(error)); };
  piece->work = [once, stop, function = std::move(function)] {
    auto value = function(*stop);
    if (!*stop) (*once)(std::move(value));
  };
  piece->stop = std::move(stop);
  post(std::move(piece));
}

}  // namespace race::server
