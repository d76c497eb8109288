#include "server/http/event_session.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "server/http/wake_up.h"
#include "services/failures.h"

namespace race::server {
namespace {

// One client. Held by its coroutines, and by the hub until it leaves.
class EventSession final : public Subscriber, public std::enable_shared_from_this<EventSession> {
 public:
  EventSession(NetStream stream, ChannelEvents events, Identity identity, const EventTargets& targets)
      : stream_(std::move(stream)),
        events_(std::move(events)),
        identity_(std::move(identity)),
        targets_(targets),
        wake_up_(stream_.get_executor()),
        waker_(stream_.get_executor()),
        deadline_(stream_.get_executor()),
        identity_timer_(stream_.get_executor()) {}

  Outbox& outbox() override { return outbox_; }
  const Identity& identity() const override { return identity_; }
  void wake() override {
    wake_up_.post([self = shared_from_this()] {
      if (self->outbox_.is_cut()) self->reset();
      self->waker_.cancel();
    });
  }
  void gather() override {}  // each message is an event of its own

  awaitable<void> run(Response head, Connections::Place& place) {
    place.on_end([weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->end();
    });
    try {
      co_await serve(std::move(head));
    } catch (...) {
      services::report_failure("a client of events");
    }
    leave();
  }

 private:
  using Pieces = std::array<asio::const_buffer, 3>;
  // Without an event for so long, a comment tells the client, and what is between, that the answer goes on.
  static constexpr std::chrono::seconds kKeepAlive{15};
  static constexpr std::chrono::seconds kIdentityPeriod{1};
  static constexpr std::string_view kEnd = "\n\n", kComment = ":\n\n";

  awaitable<void> serve(Response response) {
    stream_.expires_never();
    error_code ignored;
    // Until all has left, closing drops it: the kernel keeps nothing for who does not take it.
    stream_.socket().set_option(asio::socket_base::linger(true, 0), ignored);
    const bool begun = co_await send_header(std::move(response));
    if (!begun) co_return reset();
    spawn(read());
    spawn(check_identity());
    targets_.hub.subscribe(shared_from_this(), events_.channel, events_.since);
    const bool whole = co_await write();
    if (!whole) co_return reset();
    stream_.socket().set_option(asio::socket_base::linger(false, 0), ignored);
    stream_.socket().shutdown(asio::socket_base::shutdown_send, ignored);
  }

  void spawn(awaitable<void> coroutine) {
    auto done = [self = shared_from_this()](std::exception_ptr failure) {
      if (!failure) return;
      services::run_reporting("a client of events", [&] { std::rethrow_exception(failure); });
      self->reset();
    };
    asio::co_spawn(stream_.get_executor(), std::move(coroutine), std::move(done));
  }

  // The client says nothing more: what it sends ends it, as its end does.
  awaitable<void> read() {
    std::array<char, 64> waste;
    co_await stream_.async_read_some(asio::buffer(waste), kAsTuple);
    if (!over_) reset();
  }

  awaitable<void> check_identity() {
    while (!over_) {
      identity_timer_.expires_after(kIdentityPeriod);
      co_await identity_timer_.async_wait(kAsTuple);
      if (!over_ && !targets_.records.is_current(identity_)) end();
    }
  }

  // Until the end of the answer, which is written, too. False: it cannot be, or is not taken in time.
  awaitable<bool> write() {
    while (!over_) {
      const bool sent = co_await send_waiting();
      if (!sent) co_return false;
      for (const std::string& channel : outbox_.take_stale_channels()) {
        if (channel == Outbox::kPrivateQueue) co_return false;
        targets_.hub.resend_snapshot(shared_from_this(), channel);
      }
      if (over_ || !outbox_.is_empty()) continue;
      waker_.expires_after(kKeepAlive);
      const auto [woken] = co_await waker_.async_wait(kAsTuple);
      if (woken || over_) continue;
      const Pieces comment = {asio::buffer(kComment)};
      const bool kept = co_await send(comment);
      if (!kept) co_return false;
    }
    if (!targets_.chunked) co_return true;
    const auto last = http::make_chunk_last();
    begin_sending();
    const auto [error, bytes] = co_await asio::async_write(stream_, last, kAsTuple);
    deadline_.cancel();
    co_return !error;
  }

  awaitable<bool> send_waiting() {
    for (auto text = outbox_.pop(); text && !over_; text = outbox_.pop()) {
      const StreamMessage& message = **text;
      const bool is_error = message.kind == "error";  // is the last: that the channel has ended, or is none
      std::string head = "event: " + std::string(message.kind) + "\ndata: ";
      if (!is_error) head = "id: " + std::to_string(message.sequence) + '\n' + head;
      const Pieces event = {asio::buffer(head), asio::buffer(message.json), asio::buffer(kEnd)};
      const bool sent = co_await send(event);
      if (!sent) co_return false;
      if (is_error) over_ = true;
    }
    co_return true;
  }

  // The pieces stay until they are sent. False: they cannot be, or are not taken in time.
  awaitable<bool> send(Pieces pieces) {
    begin_sending();
    error_code failed;
    if (targets_.chunked) {
      const auto chunk = http::make_chunk(pieces);
      const auto [error, bytes] = co_await asio::async_write(stream_, chunk, kAsTuple);
      failed = error;
    } else {
      const auto [error, bytes] = co_await asio::async_write(stream_, pieces, kAsTuple);
      failed = error;
    }
    deadline_.cancel();
    co_return !failed;
  }

  awaitable<bool> send_header(Response response) {
    http::response<http::empty_body> head(std::move(response.base()));
    head.content_length(boost::none);
    head.chunked(targets_.chunked);
    http::response_serializer<http::empty_body> serializer(head);
    begin_sending();
    const auto [error, bytes] = co_await http::async_write_header(stream_, serializer, kAsTuple);
    deadline_.cancel();
    co_return !error;
  }

  void begin_sending() {
    deadline_.expires_after(targets_.write_timeout);
    deadline_.async_wait([self = shared_from_this()](error_code cancelled) {
      if (!cancelled) self->reset();
    });
  }

  // The answer ends after what is being sent.
  void end() {
    over_ = true;
    waker_.cancel();
  }

  // Closes; what has not been taken is dropped.
  void reset() {
    end();
    stream_.close();
  }

  // However the client leaves, but when the sockets themselves end: the hub then drops its subscribers.
  void leave() {
    end();
    services::run_reporting("a client that leaves", [this] { targets_.hub.disconnect(shared_from_this()); });
    identity_timer_.cancel();
    stream_.close();
  }

  NetStream stream_;
  const ChannelEvents events_;
  const Identity identity_;
  const EventTargets targets_;
  const WakeUp wake_up_;
  asio::steady_timer waker_, deadline_, identity_timer_;
  Outbox outbox_;
  bool over_ = false;
};

}  // namespace

awaitable<void> serve_events(NetStream stream, Response head, ChannelEvents events, Identity identity,
                             EventTargets targets, Connections::Place& place) {
  const auto session =
      std::make_shared<EventSession>(std::move(stream), std::move(events), std::move(identity), targets);
  co_await session->run(std::move(head), place);
}

}  // namespace race::server
