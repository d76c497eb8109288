#include "server/http/answering.h"

#include <chrono>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "server/http/refusal.h"
#include "server/http/response.h"
#include "server/http/static_files.h"
#include "services/failures.h"

namespace race::server {
namespace {

using asio::ip::tcp;

void find_answer(Request request, const Answer& answer, Context& context) {
  if (is_of_interface(request.path)) return context.backend.handle(std::move(request), answer);
  if (request.method == "GET")
    if (auto file = static_file(context.web, request)) return answer(std::move(*file));
  answer(refusal(404, "not_found", "there is no such page"));
}

// An exception ends its request alone.
void handle(Request request, const Answer& answer, Context& context) {
  const std::string name = request.method + ' ' + request.path;
  try {
    find_answer(std::move(request), answer, context);
  } catch (const std::bad_alloc&) {
    services::report_failure(name.c_str());
    answer(no_memory());
  } catch (...) {
    services::report_failure(name.c_str());
    answer(refusal(500, "internal", "the server failed to answer; see its log"));
  }
}

// A reply that is waited for, on the thread of the sockets. Held by the coroutine that waits: it may end before.
struct AwaitedReply {
  explicit AwaitedReply(const asio::any_io_executor& executor)
      : arrived(executor, std::chrono::steady_clock::time_point::max()) {}
  asio::steady_timer arrived;  // until the reply cancels it
  Answered answered;
};

// Says that a client has gone when it closes its half of the connection. One that sends its next request already is not
// watched any more.
void watch_client(NetStream& stream, const std::shared_ptr<AwaitedReply>& awaited, const SharedStop& gone) {
  stream.socket().async_wait(tcp::socket::wait_read, [&stream, weak = std::weak_ptr(awaited), gone](error_code error) {
    if (error || weak.expired()) return;
    if (stream.is_ended()) *gone = true;
  });
}

void post_to(Pool& handlers, Request request, const std::shared_ptr<AwaitedReply>& awaited, Context& context) {
  const Answer answer([path = context.replies, weak = std::weak_ptr(awaited)](Reply reply) {
    const std::size_t units = reply.text.size() + reply.body.size_units();
    path->post([weak, units, reply = std::move(reply)]() mutable {
      const auto waiting = weak.lock();
      if (!waiting) return;
      waiting->answered = {std::move(reply), units};
      waiting->arrived.cancel();
    });
  });
  handlers.post(
      [request = std::move(request), answer, &context]() mutable { handle(std::move(request), answer, context); });
}

}  // namespace

awaitable<Answered> reply_to(Request request, NetStream& stream, Pool& handlers, Context& context) {
  const asio::any_io_executor executor = co_await asio::this_coro::executor;
  const auto awaited = std::make_shared<AwaitedReply>(executor);
  watch_client(stream, awaited, request.gone);
  post_to(handlers, std::move(request), awaited, context);
  co_await awaited->arrived.async_wait(kAsTuple);
  error_code ignored;
  stream.socket().cancel(ignored);
  co_return std::move(awaited->answered);
}

}  // namespace race::server
