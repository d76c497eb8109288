#include "services/remote/process_link.h"

#include <atomic>
#include <map>
#include <utility>
#include <vector>

#include "services/failures.h"

namespace race::remote {
namespace {

constexpr const char* kTooSlow = "it does not read what it is told";

bool is_of_world(Kind kind) {
  return kind == Kind::pose || kind == Kind::ready || kind == Kind::done || kind == Kind::failed;
}

}  // namespace

// What the thread of the group needs of a link, which may be destroyed before it. All but `pong_received`, `out`,
// `unhandled` and `on_handled` belongs to that thread once the hello is accepted.
struct ProcessLink::Process {
  std::atomic<bool> pong_received{false};                          // since the last ping
  std::shared_ptr<SendQueue> out = std::make_shared<SendQueue>();  // held by the components too
  std::map<std::string, RemoteComponent*> components;
  std::vector<std::string> keys;  // of all, in the order of its hello
  RemoteWorld* world = nullptr;   // that it brought
  std::size_t group = 0;
  std::string fault;              // why nothing that it says counts any more; empty: it counts
  std::atomic<int> unhandled{0};  // messages
  services::Mutex mutex;
  std::function<void()> on_handled GUARDED_BY(mutex);

  // A message until it is handled, or dropped.
  class Unhandled {
   public:
    explicit Unhandled(std::shared_ptr<Process> process) : process_(std::move(process)) { ++process_->unhandled; }
    Unhandled(const Unhandled&) = delete;
    Unhandled& operator=(const Unhandled&) = delete;
    ~Unhandled() {
      --process_->unhandled;
      services::run_reporting("what a process has said", [this] {
        const services::MutexLock lock(process_->mutex);
        if (process_->on_handled) process_->on_handled();
      });
    }

   private:
    const std::shared_ptr<Process> process_;
  };

  void send(const Message& message) { out->push(encode(message).value()); }

  void refuse(const Error& error) {
    Message message;
    message.kind = Kind::refused;
    message.value = List{error_json(error)};
    send(message);
    out->close();
    fault = "refused: " + cut(to_string(error));
  }

  Expected<void> handle(const EncodedMessage& encoded) {
    ASSIGN_OR_RETURN(Message message, decode(encoded, Reader::server));
    if (message.kind == Kind::pong) {
      pong_received = true;
      return {};
    }
    if (message.kind == Kind::hello) return unexpected(ErrorCode::conflict, "has been said already", "hello");
    if (is_of_world(message.kind)) {
      if (!world) return unexpected(ErrorCode::not_found, "this process brought no world", "type");
      return world->announce(std::move(message));
    }
    const auto component = components.find(message.key);
    if (component == components.end())
      return unexpected(ErrorCode::not_found, "this process did not bring it", message.key);
    return component->second->announce(std::move(message));
  }
};

ProcessLink::ProcessLink(Remotes& remotes, std::vector<std::string> groups, std::string account)
    : remotes_(remotes), owner_{std::move(groups), std::move(account)}, process_(std::make_shared<Process>()) {}

ProcessLink::~ProcessLink() {
  process_->out->on_change({});
  on_handled({});
  disconnect("its connection has ended");
}

SendQueue& ProcessLink::out() { return *process_->out; }

void ProcessLink::received(EncodedMessage message) {
  if (disconnected_) return;
  if (!accepted_) {
    if (auto good = accept_hello(message); !good) {
      process_->refuse(good.error());
      refusal_ = std::move(good).error();
      disconnected_ = true;
    }
    return;
  }
  auto unhandled = std::make_shared<Process::Unhandled>(process_);
  remotes_.post(process_->group, [process = process_, message = std::move(message), unhandled = std::move(unhandled)] {
    if (!process->fault.empty()) return;
    if (auto good = process->handle(message); !good) process->refuse(good.error());
  });
}

bool ProcessLink::is_behind() const { return process_->unhandled > 0; }

void ProcessLink::on_handled(std::function<void()> handled) {
  const services::MutexLock lock(process_->mutex);
  process_->on_handled = std::move(handled);
}

Expected<void> ProcessLink::accept_hello(const EncodedMessage& message) {
  ASSIGN_OR_RETURN(Message hello, decode(message, Reader::server));
  if (hello.kind != Kind::hello) return unexpected(ErrorCode::type, "the first message is `hello`", "type");
  hello.value.freeze();  // the group's thread keeps parts of it
  if (hello.number != kProtocol)
    return unexpected(ErrorCode::version, "this server speaks protocol " + std::to_string(kProtocol), "protocol");
  ASSIGN_OR_RETURN(const Remotes::Claim claim, remotes_.claim(hello.value, hello.world, owner_));
  process_->group = claim.group;
  process_->world = claim.remote_world;
  process_->keys = claim.keys;
  for (const Remotes::Place* place : claim.places) process_->components.emplace(place->service.key, place->component);
  accepted_ = true;
  process_->pong_received = true;
  remotes_.post(process_->group, [process = process_, &remotes = remotes_, world = claim.world, offers = claim.offers,
                                  hears_violations = hello.on] {
    for (const Offer& offer : offers) process->components.emplace(offer.key, remotes.own_->host(offer));
    Message welcome;
    welcome.kind = Kind::welcome;
    welcome.time = remotes.clock_.now();
    welcome.number = remotes.heartbeat().count();
    process->send(welcome);
    if (process->world) process->world->connect(process->out, world);
    for (const auto& [key, component] : process->components) component->connect(process->out, hears_violations);
    for (const std::string& key : process->keys) remotes.host_.reconnect(key);
  });
  return {};
}

void ProcessLink::check_heartbeat() {
  if (disconnected_ || !accepted_) return;
  if (process_->out->overflowed()) return disconnect(kTooSlow);
  unanswered_ = process_->pong_received.exchange(false) ? 0 : unanswered_ + 1;
  if (unanswered_ > kPingsPerHeartbeat) return disconnect("it answers no more");
  remotes_.post(process_->group, [process = process_, &remotes = remotes_, number = ++pings_] {
    Message ping;
    ping.kind = Kind::ping;
    ping.number = number;
    ping.time = remotes.clock_.now();
    process->send(ping);
  });
}

void ProcessLink::disconnect(const std::string& why) {
  if (std::exchange(disconnected_, true)) return;
  const std::string reason = process_->out->overflowed() ? kTooSlow : why;
  process_->out->close();
  if (!accepted_) return;
  // Posted before the places are released: a process that connects now finds this one disconnected.
  remotes_.post(process_->group, [process = process_, &remotes = remotes_, reason] {
    if (process->fault.empty()) process->fault = reason;
    if (process->world) process->world->connect(nullptr, {});
    for (const std::string& key : process->keys) {
      remotes.host_.disconnect(key, process->fault);
      if (const auto found = process->components.find(key); found != process->components.end())
        found->second->connect(nullptr);
    }
  });
  remotes_.release(process_->keys, process_->world);
}

}  // namespace race::remote
