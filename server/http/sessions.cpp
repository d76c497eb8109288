// The WebSockets: clients of the stream, and processes of components. Coroutines of the listener's thread.
#include "server/http/sessions.h"

#include <chrono>

#include "server/http/request_filter.h"
#include "server/stream/requests.h"
#include "services/remote/process_link.h"

namespace race::server {
namespace {

constexpr std::chrono::seconds kMessageTimeout{10};  // for the other side to take a message

// A WebSocket, and what wakes the coroutine that writes to it.
class Session {
 protected:
  explicit Session(beast::tcp_stream stream)
      : socket_(std::move(stream)), executor_(socket_.get_executor()), waker_(executor_), deadline_(executor_) {}

  // Whether it is open then; a message has at most `limit` bytes, and is one frame.
  awaitable<bool> accept(const Upgrade& request, std::size_t limit) {
    beast::get_lowest_layer(socket_).expires_never();
    socket_.read_message_max(limit);
    socket_.auto_fragment(false);
    const auto [failed] = co_await socket_.async_accept(request, kAsTuple);
    co_return !failed;
  }
  // Until somebody cancels waker_.
  awaitable<void> sleep() {
    waker_.expires_at(std::chrono::steady_clock::time_point::max());
    co_await waker_.async_wait(kAsTuple);
  }
  // Sends one message, while `self` holds this. False: it cannot be sent, or is not taken in time; the connection ends.
  awaitable<bool> send(asio::const_buffer message, std::shared_ptr<void> self) {
    deadline_.expires_after(kMessageTimeout);
    deadline_.async_wait([this, self = std::move(self)](boost::system::error_code cancelled) {
      if (!cancelled) reset();
    });
    const auto [error, bytes] = co_await socket_.async_write(message, kAsTuple);
    deadline_.cancel();
    co_return !error;
  }
  void close() { beast::get_lowest_layer(socket_).close(); }
  // Closes; what has not been taken is dropped.
  void reset() {
    boost::system::error_code ignored;
    beast::get_lowest_layer(socket_).socket().set_option(asio::socket_base::linger(true, 0), ignored);
    close();
  }

  websocket::stream<beast::tcp_stream> socket_;
  asio::any_io_executor executor_;
  asio::steady_timer waker_, deadline_;
  bool over_ = false;
};

// One client of the stream. Held by its two coroutines, and by the hub until it leaves.
class StreamSession final : Session, public Subscriber, public std::enable_shared_from_this<StreamSession> {
 public:
  StreamSession(beast::tcp_stream stream, const StreamTargets& targets)
      : Session(std::move(stream)), targets_(targets), hub_(targets.hub), displays_(targets.displays) {}

  Outbox& outbox() override { return outbox_; }
  void wake() override {
    asio::post(executor_, [self = shared_from_this()] {
      if (self->outbox_.is_cut()) self->reset();
      self->waker_.cancel();
    });
  }

  awaitable<void> run(Upgrade request) {
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    if (!co_await accept(request, RequestFilter::kMessageBytes)) co_return;
    asio::co_spawn(
        executor_, [self = shared_from_this()] { return self->write(); }, asio::detached);
    beast::flat_buffer buffer(RequestFilter::kMessageBytes + 1024);
    for (;;) {
      const auto [error, bytes] = co_await socket_.async_read(buffer, kAsTuple);
      if (error) break;
      if (!socket_.got_text()) break;
      const auto data = buffer.cdata();
      handle_stream_request({static_cast<const char*>(data.data()), data.size()}, shared_from_this(), targets_);
      buffer.consume(buffer.size());
      co_await hub_turn();
    }
    over_ = true;
    displays_.disconnect(*this);
    hub_.disconnect(shared_from_this());
    waker_.cancel();
    close();
  }

 private:
  // Until the hub has done what this client has asked for: what it says meanwhile stays in its socket.
  awaitable<void> hub_turn() {
    auto initiate = [this](auto handler) {
      auto shared = std::make_shared<decltype(handler)>(std::move(handler));
      hub_.after(
          [executor = executor_, shared = std::move(shared)] { asio::post(executor, [shared] { (*shared)(); }); });
    };
    co_await asio::async_initiate<const asio::use_awaitable_t<>, void()>(initiate, asio::use_awaitable);
  }

  awaitable<void> write() {
    while (!over_) {
      while (auto text = outbox_.pop()) {
        const asio::const_buffer message = asio::buffer(**text);
        const bool sent = co_await send(message, shared_from_this());
        if (!sent || over_) co_return close();
      }
      for (const std::string& channel : outbox_.take_stale_channels()) {
        if (channel == Outbox::kPrivateQueue) co_return close();
        hub_.resend_snapshot(shared_from_this(), channel);
      }
      co_await sleep();
    }
  }

  const StreamTargets targets_;
  Hub& hub_;
  Displays& displays_;
  Outbox outbox_;
};

// One process of components. Held by its coroutines.
class ComponentSession final : Session, public std::enable_shared_from_this<ComponentSession> {
 public:
  ComponentSession(beast::tcp_stream stream, remote::Remotes& remotes, Hub& hub)
      : Session(std::move(stream)),
        hub_(hub),
        handled_(executor_),
        heartbeat_timer_(executor_),
        heartbeat_check_(remotes.heartbeat() / remote::ProcessLink::kPingsPerHeartbeat),
        link_(remotes) {}

  awaitable<void> run(Upgrade request) {
    if (!co_await accept(request, remote::kMessageBytes)) co_return;
    asio::co_spawn(
        executor_, [self = shared_from_this()] { return self->write(); }, asio::detached);
    asio::co_spawn(
        executor_, [self = shared_from_this()] { return self->check_heartbeats(); }, asio::detached);
    link_.on_handled([this, weak = weak_from_this(), executor = executor_] {
      asio::post(executor, [this, weak] {
        if (const auto self = weak.lock()) handled_.cancel();
      });
    });
    beast::flat_buffer buffer(remote::kMessageBytes + 1024);
    for (;;) {
      const auto [error, bytes] = co_await socket_.async_read(buffer, kAsTuple);
      if (error) break;
      link_.received({beast::buffers_to_string(buffer.cdata()), socket_.got_binary()});
      buffer.consume(buffer.size());
      co_await turn();
    }
    over_ = true;
    link_.out().on_change({});
    link_.on_handled({});
    link_.disconnect("its connection has ended");
    waker_.cancel();
    heartbeat_timer_.cancel();
  }

 private:
  // Until what the process has said is handled, and the hub has told most of it: meanwhile the rest stays in its
  // socket.
  awaitable<void> turn() {
    while (link_.is_behind() && !link_.disconnected()) co_await wait();
    count_in_hub();
    while (in_hub_ > kMostInHub && !link_.disconnected()) co_await wait();
  }
  awaitable<void> wait() {
    handled_.expires_at(std::chrono::steady_clock::time_point::max());
    co_await handled_.async_wait(kAsTuple);
  }
  void count_in_hub() {
    ++in_hub_;
    hub_.after([this, weak = weak_from_this(), executor = executor_] {
      asio::post(executor, [this, weak] {
        const auto self = weak.lock();
        if (self && in_hub_-- == kMostInHub + 1) handled_.cancel();
      });
    });
  }

  awaitable<void> write() {
    link_.out().on_change([this, weak = weak_from_this(), executor = executor_] {
      asio::post(executor, [this, weak] {
        if (const auto self = weak.lock()) waker_.cancel();
      });
    });
    while (!over_) {
      while (auto encoded = link_.out().pop()) {
        socket_.binary(encoded->binary);
        const asio::const_buffer message = asio::buffer(encoded->bytes);
        const bool sent = co_await send(message, shared_from_this());
        if (!sent || over_) co_return close();
      }
      if (link_.out().drained()) co_return close();
      co_await sleep();
    }
  }

  awaitable<void> check_heartbeats() {
    while (!over_) {
      heartbeat_timer_.expires_after(heartbeat_check_);
      co_await heartbeat_timer_.async_wait(kAsTuple);
      if (over_) co_return;
      link_.check_heartbeat();
      if (!link_.disconnected()) continue;
      handled_.cancel();
      co_return close();
    }
  }

  static constexpr int kMostInHub = 256;

  Hub& hub_;
  int in_hub_ = 0;              // messages that the hub may not have told yet
  asio::steady_timer handled_;  // wakes who waits until something is
  asio::steady_timer heartbeat_timer_;
  std::chrono::milliseconds heartbeat_check_;
  remote::ProcessLink link_;
};

}  // namespace

awaitable<void> serve_stream(beast::tcp_stream stream, Upgrade request, StreamTargets targets) {
  auto session = std::make_shared<StreamSession>(std::move(stream), targets);
  co_await session->run(std::move(request));
}

awaitable<void> serve_components(beast::tcp_stream stream, Upgrade request, remote::Remotes& remotes, Hub& hub) {
  auto session = std::make_shared<ComponentSession>(std::move(stream), remotes, hub);
  co_await session->run(std::move(request));
}

}  // namespace race::server
