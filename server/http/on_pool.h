// on_pool: work of a coroutine on the threads of a pool.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "server/http/beast.h"
#include "server/threads/strand.h"
#include "services/failures.h"

namespace race::server {

/// Runs `work` on the pool and goes on here with its value; what it throws is thrown here. If the pool drops it, the
/// coroutine ends here. (What a co_await expression uses has a name: g++ 12 destroys temporaries with captures twice.)
template <typename T>
awaitable<T> on_pool(Pool& pool, std::function<T()> work) {
  const asio::any_io_executor executor = co_await asio::this_coro::executor;
  struct Result {
    std::exception_ptr failure;
    std::optional<T> value;
  };
  const auto result = std::make_shared<Result>();
  auto initiate = [&pool, &executor, &work, result](auto handler) {
    // Held by the work until its value is handed over.
    auto shared = std::make_shared<decltype(handler)>(std::move(handler));
    pool.post([shared = std::move(shared), executor, result, work = std::move(work)]() mutable {
      try {
        result->value.emplace(work());
      } catch (...) {
        result->failure = std::current_exception();
      }
      work = nullptr;
      const auto hand_over = [&] { asio::post(executor, [shared] { (*shared)(); }); };
      // Without memory: later. Somebody waits for it.
      while (!services::run_reporting("an answer", hand_over))
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    });
  };
  co_await asio::async_initiate<const asio::use_awaitable_t<>, void()>(initiate, asio::use_awaitable);
  if (result->failure) std::rethrow_exception(result->failure);
  co_return std::move(*result->value);
}

}  // namespace race::server
