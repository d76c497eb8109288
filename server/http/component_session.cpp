#include <atomic>
#include <chrono>
#include <optional>

#include "server/http/on_pool.h"
#include "server/http/sessions.h"
#include "services/failures.h"
#include "services/remote/process_link.h"

namespace race::server {
namespace {

constexpr std::chrono::seconds kHelloTimeout{5};  // for a process to say who it is

// One process of components. Held by its coroutines.
class ComponentSession final : public Session {
 public:
  ComponentSession(NetStream stream, Identity identity, const ComponentTargets& targets, ByteBudget::Share unknown)
      : Session(std::move(stream)),
        identity_(std::move(identity)),
        records_(targets.records),
        hub_(targets.hub),
        handlers_(targets.handlers),
        unknown_(std::move(unknown)),
        change_(executor_),
        progress_(executor_),
        handled_(executor_),
        hello_timer_(executor_),
        heartbeat_timer_(executor_),
        heartbeat_check_(targets.remotes.heartbeat() / remote::ProcessLink::kPingsPerHeartbeat),
        link_(targets.remotes, identity_.groups, identity_.account) {}

  awaitable<void> run(Upgrade request, Connections::Place& place) {
    if (!co_await accept(request, remote::ProcessLink::kHelloBytes, place)) co_return;
    try {
      link_.out().on_change([this, weak = weak_from_this(), change = change_] {
        change.post([this, weak] {
          if (const auto self = weak.lock()) waker_.cancel();
        });
      });
      link_.on_handled([wake = wake_handled()] { wake(); });
      spawn([self = self()] { return self->write(); });
      await_hello();
      co_await read();
    } catch (...) {
      services::report_failure("a process of components");
    }
    leave();
  }

 private:
  std::shared_ptr<ComponentSession> self() { return std::static_pointer_cast<ComponentSession>(shared_from_this()); }

  void await_hello() {
    hello_timer_.expires_after(kHelloTimeout);
    hello_timer_.async_wait([self = self()](error_code cancelled) {
      if (!cancelled) self->reset();
    });
  }

  awaitable<void> read() {
    beast::flat_buffer buffer(remote::kMessageBytes + 1024);
    for (bool is_first = true;; is_first = false) {
      const auto [error, bytes] = co_await socket_.async_read(buffer, kAsTuple);
      if (error) co_return;
      remote::EncodedMessage message{beast::buffers_to_string(buffer.cdata()), socket_.got_binary()};
      buffer.consume(buffer.size());
      if (is_first) {
        buffer.shrink_to_fit();
        co_await greet(std::move(message));
      } else {
        link_.received(std::move(message));
      }
      co_await turn();
    }
  }

  // The hello takes a while to check: a scene, URDF texts. The link is used there alone meanwhile. (A process that is
  // refused is told so by write(), which then closes.)
  awaitable<void> greet(remote::EncodedMessage hello) {
    hello_timer_.cancel();
    std::function<bool()> check = [this, hello = std::move(hello)] {
      link_.received(hello);
      return link_.accepted();
    };
    const bool accepted = co_await on_pool(handlers_, std::move(check));
    if (link_.refusal()) records_.refused(identity_, *link_.refusal());
    if (!accepted) co_return;
    unknown_ = {};
    socket_.read_message_max(remote::kMessageBytes);
    spawn([self = self()] { return self->check_heartbeats(); });
  }

  void leave() {
    over_ = true;
    link_.out().on_change({});
    link_.on_handled({});
    services::run_reporting("a process that leaves", [this] { link_.disconnect("its connection has ended"); });
    waker_.cancel();
    hello_timer_.cancel();
    heartbeat_timer_.cancel();
    close();
  }

  // Until what the process has said is handled, and the hub has told most of it: meanwhile the rest stays in its
  // socket.
  awaitable<void> turn() {
    while (link_.is_behind() && !link_.disconnected()) co_await wait();
    count_in_hub();
    while (*in_hub_ > kMostInHub && !link_.disconnected()) co_await wait();
  }
  awaitable<void> wait() {
    handled_.expires_at(std::chrono::steady_clock::time_point::max());
    co_await handled_.async_wait(kAsTuple);
  }
  void count_in_hub() {
    ++*in_hub_;
    hub_.after([in_hub = in_hub_, wake = wake_handled()] {
      if ((*in_hub)-- == kMostInHub + 1) wake();
    });
  }
  // Wakes wait(), from any thread.
  std::function<void()> wake_handled() {
    return [this, weak = weak_from_this(), progress = progress_] {
      progress.post([this, weak] {
        if (const auto self = weak.lock()) handled_.cancel();
      });
    };
  }

  awaitable<void> write() {
    while (!over_) {
      while (auto encoded = link_.out().pop()) {
        socket_.binary(encoded->binary);
        std::vector<asio::const_buffer> message = {asio::buffer(encoded->bytes)};
        const bool sent = co_await send(std::move(message));
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
      if (!records_.is_current(identity_)) link_.disconnect("its account may do that no more");
      if (!link_.disconnected()) continue;
      handled_.cancel();
      co_return close();
    }
  }

  static constexpr int kMostInHub = 256;

  const Identity identity_;
  ClientRecords& records_;
  Hub& hub_;
  Pool& handlers_;
  ByteBudget::Share unknown_;
  const WakeUp change_, progress_;
  // Messages that the hub may not have told yet.
  const std::shared_ptr<std::atomic<int>> in_hub_ = std::make_shared<std::atomic<int>>(0);
  asio::steady_timer handled_;  // wakes who waits until something is
  asio::steady_timer hello_timer_, heartbeat_timer_;
  std::chrono::milliseconds heartbeat_check_;
  remote::ProcessLink link_;
};

}  // namespace

awaitable<void> serve_components(NetStream stream, Upgrade request, Identity identity, ComponentTargets targets,
                                 Connections::Place& place, ByteBudget::Share unknown) {
  auto session =
      std::make_shared<ComponentSession>(std::move(stream), std::move(identity), targets, std::move(unknown));
  co_await session->run(std::move(request), place);
}

}  // namespace race::server
