// How questions and commands reach a core's strand: for the files of Core.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <utility>

#include "server/execution/core.h"

namespace race::server {

// Posts `function` and waits for its value until all that caused it is durable.
template <typename T, typename F>
Expected<T> Core::on_strand(F function) {
  constexpr std::chrono::seconds kPatience{5};
  auto promise = std::make_shared<std::promise<Expected<T>>>();
  auto abandoned = std::make_shared<std::atomic<bool>>(false);
  auto answer = promise->get_future();
  strand_.post([self = shared_from_this(), function = std::move(function), promise, abandoned] {
    if (*abandoned) return;  // who asked was told that it has not happened
    try {
      self->held_.add([promise, value = Expected<T>(function())](const Error* failure) {
        promise->set_value(failure ? Expected<T>(tl::unexpect, *failure) : value);
      });
    } catch (...) {
      promise->set_exception(std::current_exception());
    }
  });
  if (answer.wait_for(kPatience) != std::future_status::ready) {
    *abandoned = true;
    return unexpected(ErrorCode::unavailable, "core " + id_ + " is busy");
  }
  try {
    return answer.get();
  } catch (const std::future_error&) {  // the pool has ended
    return unexpected(ErrorCode::unavailable, "the server ends");
  }
}

}  // namespace race::server
