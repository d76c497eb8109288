// How questions and commands reach a core's strand: for the files of Core.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <utility>

#include "server/execution/core.h"

namespace race::server {

// Posts `function` and waits for its value until all that caused it is durable, or never will be. When the core does
// not answer in time, the function is not executed any more: who asked is told that nothing has happened, and it is
// so.
template <typename T, typename F>
Expected<T> Core::on_strand(F function) {
  constexpr std::chrono::seconds kTimeout{5};
  enum class Progress : std::uint8_t { posted, taken, abandoned };
  struct Question {
    std::promise<Expected<T>> promise;
    std::atomic<Progress> progress{Progress::posted};
    bool move_to(Progress next) {
      Progress posted = Progress::posted;
      return progress.compare_exchange_strong(posted, next);
    }
  };
  auto question = std::make_shared<Question>();
  auto answer = question->promise.get_future();
  strand_.post([self = shared_from_this(), function = std::move(function), question] {
    if (!question->move_to(Progress::taken)) return;
    try {
      auto answer = Expected<T>(function());
      self->tell_untold();
      self->held_.add([question, value = std::move(answer)](const Error* failure) {
        question->promise.set_value(failure ? Expected<T>(tl::unexpect, *failure) : value);
      });
    } catch (const std::exception& failure) {
      question->promise.set_exception(std::current_exception());
      self->interrupt_after(failure);
    }
  });
  if (answer.wait_for(kTimeout) != std::future_status::ready) {
    if (question->move_to(Progress::abandoned)) return unexpected(ErrorCode::unavailable, "core " + id_ + " is busy");
    // It happens, and is answered as soon as the disk or its watch has answered.
    if (answer.wait_for(2 * DiskWatch::kTimeout) != std::future_status::ready)
      return unexpected(ErrorCode::unavailable, "core " + id_ + " has begun this, and is busy");
  }
  try {
    return answer.get();
  } catch (const std::future_error&) {  // the pool has ended
    return unexpected(ErrorCode::unavailable, "the server ends");
  }
}

}  // namespace race::server
