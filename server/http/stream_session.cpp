#include <atomic>
#include <chrono>

#include "server/http/request_filter.h"
#include "server/http/sessions.h"
#include "services/failures.h"

namespace race::server {
namespace {

constexpr std::chrono::milliseconds kGathering{20};  // between two messages to a client that gathers
constexpr std::size_t kTogether = 256 * 1024;        // bytes of what comes together

// One client of the stream. Held by its two coroutines, and by the hub until it leaves.
class StreamSession final : public Session, public Subscriber {
 public:
  StreamSession(NetStream stream, Identity identity, const StreamTargets& targets)
      : Session(std::move(stream)),
        identity_(std::move(identity)),
        targets_(targets),
        hub_(targets.hub),
        wake_up_(executor_) {}

  Outbox& outbox() override { return outbox_; }
  const Identity& identity() const override { return identity_; }
  void wake() override {
    if (is_sending_ && !outbox_.is_cut()) return;  // it looks again before it sleeps
    wake_up_.post([self = self()] {
      if (self->outbox_.is_cut()) self->reset();
      self->waker_.cancel();
    });
  }

  void gather() override { gathers_ = true; }

  awaitable<void> run(Upgrade request, Connections::Place& place) {
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    if (!co_await accept(request, RequestFilter::kMessageBytes, place)) co_return;
    try {
      spawn([self = self()] { return self->write(); });
      spawn([self = self()] { return self->check_identity(self->identity_, self->targets_.records); });
      co_await read();
    } catch (...) {
      services::report_failure("a client of the stream");
    }
    leave();
  }

 private:
  std::shared_ptr<StreamSession> self() { return std::static_pointer_cast<StreamSession>(shared_from_this()); }

  awaitable<void> read() {
    beast::flat_buffer buffer(RequestFilter::kMessageBytes + 1024);
    for (;;) {
      const auto [error, bytes] = co_await socket_.async_read(buffer, kAsTuple);
      if (error) co_return;
      if (!socket_.got_text()) co_return;
      const auto data = buffer.cdata();
      handle_stream_request({static_cast<const char*>(data.data()), data.size()}, self(), targets_);
      buffer.consume(buffer.size());
      co_await hub_turn();
    }
  }

  // However the client leaves, but when the sockets themselves end: the hub then drops its subscribers.
  void leave() {
    over_ = true;
    services::run_reporting("a display that leaves", [this] { targets_.displays.disconnect(*this); });
    services::run_reporting("a person that leaves", [this] { targets_.presence.disconnected(*this); });
    services::run_reporting("a client that leaves", [this] { hub_.disconnect(self()); });
    waker_.cancel();
    identity_timer_.cancel();
    close();
  }

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
      is_sending_ = true;
      for (;;) {
        const std::vector<Text> texts = co_await next();
        if (texts.empty()) break;
        const bool sent = co_await send(pieces_of(texts));
        if (!sent || over_) co_return close();
      }
      for (const std::string& channel : outbox_.take_stale_channels()) {
        if (channel == Outbox::kPrivateQueue) co_return close();
        hub_.resend_snapshot(self(), channel);
      }
      is_sending_ = false;
      if (outbox_.is_empty()) co_await sleep();
    }
  }

  // The next messages: one, or what has come within kGathering since the last ones; none: nothing waits.
  awaitable<std::vector<Text>> next() {
    if (!gathers_ || outbox_.size() == 0) co_return outbox_.pop_together(0);
    waker_.expires_at(sent_ + kGathering);
    co_await waker_.async_wait(kAsTuple);
    sent_ = std::chrono::steady_clock::now();
    co_return outbox_.pop_together(kTogether);
  }

  std::vector<asio::const_buffer> pieces_of(const std::vector<Text>& texts) const {
    if (!gathers_) return {asio::buffer(texts.front()->json)};
    std::vector<asio::const_buffer> pieces;
    for (const Text& text : texts) {
      pieces.push_back(asio::buffer(pieces.empty() ? "[" : ",", 1));
      pieces.push_back(asio::buffer(text->json));
    }
    pieces.push_back(asio::buffer("]", 1));
    return pieces;
  }

  const Identity identity_;
  const StreamTargets targets_;
  Hub& hub_;
  const WakeUp wake_up_;
  Outbox outbox_;
  bool gathers_ = false;
  std::chrono::steady_clock::time_point sent_;  // the last messages, together
  std::atomic<bool> is_sending_{false};  // what others push meanwhile needs no wake(): a slow client takes it later
};

}  // namespace

awaitable<void> serve_stream(NetStream stream, Upgrade request, Identity identity, StreamTargets targets,
                             Connections::Place& place) {
  auto session = std::make_shared<StreamSession>(std::move(stream), std::move(identity), targets);
  co_await session->run(std::move(request), place);
}

}  // namespace race::server
