#include "services/remote/remotes.h"

#include <algorithm>
#include <atomic>

#include "core/rsm/document.h"
#include "core/value/fields.h"

namespace race::remote {
namespace {

tl::unexpected<Error> taken(std::string what) {
  return unexpected(ErrorCode::conflict, "has a process already", std::move(what));
}

bool is_of_world(Kind kind) {
  return kind == Kind::pose || kind == Kind::ready || kind == Kind::done || kind == Kind::failed;
}

}  // namespace

// What the group's thread has of a link, which may be gone by then. All but `pong_received` is the group's once it is
// greeted.
struct ProcessLink::Process {
  std::atomic<bool> pong_received{false};                          // a pong came since the last beat
  std::shared_ptr<SendQueue> out = std::make_shared<SendQueue>();  // with the components too
  std::map<std::string, RemoteComponent*> components;
  std::vector<std::string> keys;  // in the order of its hello
  RemoteWorld* world = nullptr;   // that it brought
  std::size_t group = 0;
  std::string fault;  // in what it said; nothing that it says counts any more

  void send(const Message& message) { out->push(encode(message).value()); }

  void refuse(const Error& error) {
    Message message;
    message.kind = Kind::refused;
    message.value = List{error_json(error)};
    send(message);
    out->close();
    fault = "refused: " + cut(to_string(error));
  }

  Expected<void> handle(const EncodedMessage& frame) {
    ASSIGN_OR_RETURN(Message message, decode(frame, Reader::server));
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

ProcessLink::ProcessLink(Remotes& remotes) : remotes_(remotes), process_(std::make_shared<Process>()) {}

ProcessLink::~ProcessLink() {
  process_->out->on_change({});
  disconnect("its connection has ended");
}

SendQueue& ProcessLink::out() { return *process_->out; }

void ProcessLink::received(EncodedMessage frame) {
  if (disconnected_) return;
  if (!accepted_) {
    if (auto good = accept_hello(frame); !good) {
      process_->refuse(good.error());
      disconnected_ = true;
    }
    return;
  }
  remotes_.post(process_->group, [process = process_, frame = std::move(frame)] {
    if (!process->fault.empty()) return;
    if (auto good = process->handle(frame); !good) process->refuse(good.error());
  });
}

Expected<void> ProcessLink::accept_hello(const EncodedMessage& frame) {
  constexpr std::size_t kHelloBytes = 4 * 1024 * 1024;
  if (frame.bytes.size() > kHelloBytes) return unexpected(ErrorCode::too_large, "is too long", "hello");
  ASSIGN_OR_RETURN(Message hello, decode(frame, Reader::server));
  if (hello.kind != Kind::hello) return unexpected(ErrorCode::type, "the first message is `hello`", "type");
  if (hello.number != kProtocol)
    return unexpected(ErrorCode::version, "this server speaks protocol " + std::to_string(kProtocol), "protocol");
  ASSIGN_OR_RETURN(const Remotes::Claim taken, remotes_.claim(hello.value, hello.world));
  process_->group = taken.places.front()->group;
  process_->world = taken.end;
  for (const Remotes::Place* place : taken.places) {
    process_->keys.push_back(place->service.key);
    process_->components.emplace(place->service.key, place->component);
  }
  accepted_ = true;
  process_->pong_received = true;
  remotes_.post(process_->group, [process = process_, &remotes = remotes_, world = taken.world] {
    Message welcome;
    welcome.kind = Kind::welcome;
    welcome.time = remotes.clock_.now();
    process->send(welcome);
    if (process->world) process->world->connect(process->out, world);
    for (const auto& [key, component] : process->components) component->connect(process->out);
    for (const std::string& key : process->keys) remotes.host_.reconnect(key);
  });
  return {};
}

void ProcessLink::check_heartbeat() {
  if (disconnected_) return;
  unanswered_ = process_->pong_received.exchange(false) ? 0 : unanswered_ + 1;
  if (unanswered_ > kPingsPerHeartbeat) return disconnect(accepted_ ? "it answers no more" : "it says no hello");
  if (!accepted_) return;
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
  process_->out->close();
  if (!accepted_) return;
  // Who comes now is greeted after this one has gone.
  remotes_.post(process_->group, [process = process_, &remotes = remotes_, why] {
    if (process->fault.empty()) process->fault = why;
    if (process->world) process->world->connect(nullptr, {});
    for (const std::string& key : process->keys) {
      remotes.host_.disconnect(key, process->fault);
      process->components.at(key)->connect(nullptr);
    }
  });
  remotes_.release(process_->keys, process_->world);
}

Remotes::Remotes(services::Host& host, const services::Clock& clock, std::chrono::milliseconds heartbeat)
    : host_(host), clock_(clock), heartbeat_(heartbeat) {}

Remotes::~Remotes() { stop(); }

void Remotes::add(const std::vector<RemoteService>& services, RemoteWorld* world) {
  const std::lock_guard lock(mutex_);
  worlds_.push_back({world});
  groups_.push_back(std::make_unique<services::WorkThread>());
  for (const RemoteService& service : services) {
    services::ServiceHost& host = host_.declare(service.key, service.type, *groups_.back());
    auto component = std::make_unique<RemoteComponent>(service.key, *service.model, host, service.host_functions);
    places_.emplace(service.key, Place{service, groups_.size() - 1, component.get()});
    host_.attach(service.key, std::move(component), services::Host::Connection::disconnected);
  }
}

void Remotes::step() {
  for (auto& [key, place] : places_) {
    if (!place.service.host_functions.version) continue;
    const std::uint64_t version = place.service.host_functions.version();
    if (std::exchange(place.seen, version) != version)
      post(place.group, [component = place.component] { component->notify_changes(); });
  }
}

void Remotes::stop() {
  std::vector<std::unique_ptr<services::WorkThread>> ending;
  {
    const std::lock_guard lock(mutex_);
    ending.swap(groups_);
  }
}

// The places of what a process brings, whoever has them.
Expected<std::vector<Remotes::Place*>> Remotes::find(const Value& components) {
  if (components.as_list().empty()) return unexpected(ErrorCode::missing, "there is no component", "components");
  std::vector<Place*> places;
  for (const Value& json : components.as_list()) {
    std::vector<Error> errors;
    Fields fields(json, "components", "a component", errors, Fields::Paths::field);
    const auto key = fields.text("key", Fields::Need::required), type = fields.text("type", Fields::Need::required);
    const Value* model = fields.find("rsm", Fields::Need::required);
    fields.close();
    if (!errors.empty()) return tl::unexpected(errors.front());
    const auto found = places_.find(*key);
    if (found == places_.end())
      return unexpected(ErrorCode::not_found, "no service of this key waits for a process", *key);
    Place& place = found->second;
    if (*type != place.service.type)
      return unexpected(ErrorCode::type, "is of type `" + place.service.type + "` here, not `" + *type + "`", *key);
    auto service = rsm::read_service(*model, *key);
    if (!service) return tl::unexpected(service.error().front());
    if (rsm::write_service(*service) != rsm::write_service(*place.service.model))
      return unexpected(ErrorCode::conflict, "has another RSM here: another version of the program?", *key);
    if (std::ranges::find(places, &place) != places.end()) return taken(*key);
    if (!places.empty() && place.group != places.front()->group)
      return unexpected(ErrorCode::conflict, "belongs into another process", *key);
    places.push_back(&place);
  }
  return places;
}

// The places, which are the process' own from now on. What it says is read before the lock is taken: whoever posts to a
// group does not wait for that.
Expected<Remotes::Claim> Remotes::claim(const Value& components, const Value& world) {
  Claim all;
  ASSIGN_OR_RETURN(all.places, find(components));
  WorldPlace& place = worlds_[all.places.front()->group];
  if (!world.is_null()) {
    if (!place.world) return unexpected(ErrorCode::not_found, "these services have no world here", "world");
    all.end = place.world;
    ASSIGN_OR_RETURN(all.world, place.world->check(world));
  }
  const std::lock_guard lock(mutex_);
  for (const Place* each : all.places)
    if (each->taken) return taken(each->service.key);
  if (all.end && place.taken) return taken("world");
  place.taken = place.taken || all.end;
  for (Place* each : all.places) each->taken = true;
  return all;
}

void Remotes::release(const std::vector<std::string>& keys, const RemoteWorld* world) {
  const std::lock_guard lock(mutex_);
  for (WorldPlace& place : worlds_)
    if (world && place.world == world) place.taken = false;
  for (const std::string& key : keys) places_.at(key).taken = false;
}

void Remotes::post(std::size_t group, services::WorkQueue::Work work) {
  const std::lock_guard lock(mutex_);
  if (group < groups_.size()) groups_[group]->post(std::move(work));
}

}  // namespace race::remote
