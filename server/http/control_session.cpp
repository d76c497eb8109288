#include <deque>

#include "core/value/json.h"
#include "server/http/request_filter.h"
#include "server/http/sessions.h"
#include "services/failures.h"
#include "services/mutex.h"

namespace race::server {
namespace {

// One person at the controls, or who wants them. Held by its coroutines.
class ControlSession final : public Session, public ControlClient {
 public:
  ControlSession(NetStream stream, Identity identity, const ControlTargets& targets)
      : Session(std::move(stream)), identity_(std::move(identity)), targets_(targets), wake_up_(executor_) {}

  const Identity& identity() const override { return identity_; }
  void tell(Value message) override {
    bool is_full = false;
    {
      const services::MutexLock lock(mutex_);
      is_full = waiting_.size() >= kMostWaiting;
      if (!is_full) waiting_.push_back(std::move(message));
    }
    wake_up_.post([self = self(), is_full] {
      if (is_full) self->reset();
      self->waker_.cancel();
    });
  }

  awaitable<void> run(Upgrade request, Connections::Place& place) {
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    if (!co_await accept(request, RequestFilter::kControlBytes, place)) co_return;
    try {
      spawn([self = self()] { return self->write(); });
      spawn([self = self()] { return self->check_identity(self->identity_, self->targets_.records); });
      co_await read();
    } catch (...) {
      services::report_failure("a person at the controls");
    }
    leave();
  }

 private:
  static constexpr std::size_t kMostWaiting = 64;

  std::shared_ptr<ControlSession> self() { return std::static_pointer_cast<ControlSession>(shared_from_this()); }

  // One message at a time, in turn with all other sockets.
  awaitable<void> read() {
    beast::flat_buffer buffer(RequestFilter::kControlBytes + 1024);
    for (;;) {
      const auto [error, bytes] = co_await socket_.async_read(buffer, kAsTuple);
      if (error || !socket_.got_text()) co_return;
      const auto data = buffer.cdata();
      targets_.control.request(self(), {static_cast<const char*>(data.data()), data.size()});
      buffer.consume(buffer.size());
    }
  }

  void leave() {
    over_ = true;
    services::run_reporting("a person that leaves the controls", [this] { targets_.control.disconnected(*this); });
    waker_.cancel();
    identity_timer_.cancel();
    close();
  }

  awaitable<void> write() {
    while (!over_) {
      for (std::optional<Value> message = next(); message; message = next()) {
        const std::string text = to_json(*message);
        std::vector<asio::const_buffer> pieces = {asio::buffer(text)};
        const bool sent = co_await send(std::move(pieces));
        if (!sent || over_) co_return close();
      }
      co_await sleep();
    }
  }

  std::optional<Value> next() {
    const services::MutexLock lock(mutex_);
    if (waiting_.empty()) return std::nullopt;
    Value message = std::move(waiting_.front());
    waiting_.pop_front();
    return message;
  }

  const Identity identity_;
  const ControlTargets targets_;
  const WakeUp wake_up_;
  services::Mutex mutex_;
  std::deque<Value> waiting_ GUARDED_BY(mutex_);
};

}  // namespace

awaitable<void> serve_control(NetStream stream, Upgrade request, Identity identity, ControlTargets targets,
                              Connections::Place& place) {
  auto session = std::make_shared<ControlSession>(std::move(stream), std::move(identity), targets);
  co_await session->run(std::move(request), place);
}

}  // namespace race::server
