// Done: where what somebody asked for goes, once it is there, so that no thread waits for it.
//
// Threads: called on any; what it does must be quick.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <type_traits>
#include <utility>

#include "core/value/expected.h"
#include "services/failures.h"

namespace race::server {

/// Gets the value, or why there is none, once. Who drops it says nothing: the server ends, or has no memory.
template <typename T, typename E = Error>
using Done = std::function<void(tl::expected<T, E>)>;

/// One error, also for who gets a list of them.
template <typename E = Error>
tl::unexpected<E> refused(Error error) {
  if constexpr (std::is_same_v<E, Error>)
    return tl::unexpected<E>(std::move(error));
  else
    return tl::unexpected<E>(E{std::move(error)});
}

/// A Done of which the first call alone counts. What the call throws is reported.
template <typename T, typename E = Error>
class Once {
 public:
  explicit Once(Done<T, E> done) : done_(std::move(done)) {}
  void operator()(tl::expected<T, E> value) {
    if (called_.exchange(true)) return;
    services::run_reporting("an answer", [&] { std::exchange(done_, nullptr)(std::move(value)); });
  }
  bool was_called() const { return called_; }

 private:
  std::atomic<bool> called_{false};
  Done<T, E> done_;  // of the first that calls
};

/// Calls `ask` with a Done and waits for what comes there. Error `unavailable`: it is dropped.
template <typename T, typename E = Error, typename F>
tl::expected<T, E> wait_for(F ask) {
  std::future<tl::expected<T, E>> value;
  {
    auto promise = std::make_shared<std::promise<tl::expected<T, E>>>();
    value = promise->get_future();
    ask(Done<T, E>([promise](tl::expected<T, E> given) { promise->set_value(std::move(given)); }));
  }
  try {
    return value.get();
  } catch (const std::future_error&) {
    return refused<E>({ErrorCode::unavailable, "the server ends"});
  }
}

}  // namespace race::server
