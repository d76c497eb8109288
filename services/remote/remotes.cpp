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

// What the unit's thread has of a link, which may be gone by then. All but `heard` is the unit's once it is greeted.
struct ProcessLink::Process {
  std::atomic<bool> heard{false};                                    // a pong came since the last beat
  std::shared_ptr<FrameQueue> out = std::make_shared<FrameQueue>();  // with the components too
  std::map<std::string, RemoteComponent*> components;
  std::vector<std::string> keys;  // in the order of its hello
  RemoteWorld* world = nullptr;   // that it brought
  std::size_t unit = 0;
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

  Expected<void> handle(const Frame& frame) {
    ASSIGN_OR_RETURN(Message message, decode(frame, Reader::server));
    if (message.kind == Kind::pong) {
      heard = true;
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
  lose("its connection has ended");
}

FrameQueue& ProcessLink::out() { return *process_->out; }

void ProcessLink::received(Frame frame) {
  if (lost_) return;
  if (!greeted_) {
    if (auto good = greet(frame); !good) {
      process_->refuse(good.error());
      lost_ = true;
    }
    return;
  }
  remotes_.post(process_->unit, [process = process_, frame = std::move(frame)] {
    if (!process->fault.empty()) return;
    if (auto good = process->handle(frame); !good) process->refuse(good.error());
  });
}

Expected<void> ProcessLink::greet(const Frame& frame) {
  constexpr std::size_t kHelloBytes = 4 * 1024 * 1024;
  if (frame.bytes.size() > kHelloBytes) return unexpected(ErrorCode::too_large, "is too long", "hello");
  ASSIGN_OR_RETURN(Message hello, decode(frame, Reader::server));
  if (hello.kind != Kind::hello) return unexpected(ErrorCode::type, "the first message is `hello`", "type");
  if (hello.number != kProtocol)
    return unexpected(ErrorCode::version, "this server speaks protocol " + std::to_string(kProtocol), "protocol");
  ASSIGN_OR_RETURN(const Remotes::Taken taken, remotes_.take(hello.value, hello.world));
  process_->unit = taken.places.front()->unit;
  process_->world = taken.end;
  for (const Remotes::Place* place : taken.places) {
    process_->keys.push_back(place->service.key);
    process_->components.emplace(place->service.key, place->component);
  }
  greeted_ = true;
  process_->heard = true;
  remotes_.post(process_->unit, [process = process_, &remotes = remotes_, world = taken.world] {
    Message welcome;
    welcome.kind = Kind::welcome;
    welcome.time = remotes.clock_.now();
    process->send(welcome);
    if (process->world) process->world->connect(process->out, world);
    for (const auto& [key, component] : process->components) component->connect(process->out);
    for (const std::string& key : process->keys) remotes.host_.regain(key);
  });
  return {};
}

void ProcessLink::beat() {
  if (lost_) return;
  silent_ = process_->heard.exchange(false) ? 0 : silent_ + 1;
  if (silent_ > kBeats) return lose(greeted_ ? "it answers no more" : "it says no hello");
  if (!greeted_) return;
  remotes_.post(process_->unit, [process = process_, &remotes = remotes_, number = ++pings_] {
    Message ping;
    ping.kind = Kind::ping;
    ping.number = number;
    ping.time = remotes.clock_.now();
    process->send(ping);
  });
}

void ProcessLink::lose(const std::string& why) {
  if (std::exchange(lost_, true)) return;
  process_->out->close();
  if (!greeted_) return;
  // Who comes now is greeted after this one has gone.
  remotes_.post(process_->unit, [process = process_, &remotes = remotes_, why] {
    if (process->fault.empty()) process->fault = why;
    if (process->world) process->world->connect(nullptr, {});
    for (const std::string& key : process->keys) {
      remotes.host_.lose(key, process->fault);
      process->components.at(key)->connect(nullptr);
    }
  });
  remotes_.give_back(process_->keys, process_->world);
}

Remotes::Remotes(services::Host& host, const services::Clock& clock, std::chrono::milliseconds heartbeat)
    : host_(host), clock_(clock), heartbeat_(heartbeat) {}

Remotes::~Remotes() { stop(); }

void Remotes::add(const std::vector<RemoteService>& services, RemoteWorld* world) {
  const std::lock_guard lock(mutex_);
  worlds_.push_back({world});
  units_.push_back(std::make_unique<services::WorkThread>());
  for (const RemoteService& service : services) {
    services::ServiceHost& host = host_.declare(service.key, service.type, *units_.back());
    auto component = std::make_unique<RemoteComponent>(service.key, *service.model, host, service.desk);
    places_.emplace(service.key, Place{service, units_.size() - 1, component.get()});
    host_.attach(service.key, std::move(component), services::Host::Presence::awaited);
  }
}

void Remotes::step() {
  for (auto& [key, place] : places_) {
    if (!place.service.desk.version) continue;
    const std::uint64_t version = place.service.desk.version();
    if (std::exchange(place.seen, version) != version)
      post(place.unit, [component = place.component] { component->look(); });
  }
}

void Remotes::stop() {
  std::vector<std::unique_ptr<services::WorkThread>> ending;
  {
    const std::lock_guard lock(mutex_);
    ending.swap(units_);
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
    if (!places.empty() && place.unit != places.front()->unit)
      return unexpected(ErrorCode::conflict, "belongs into another process", *key);
    places.push_back(&place);
  }
  return places;
}

// The places, which are the process' own from now on. What it says is read before the lock is taken: whoever posts to a
// unit does not wait for that.
Expected<Remotes::Taken> Remotes::take(const Value& components, const Value& world) {
  Taken all;
  ASSIGN_OR_RETURN(all.places, find(components));
  WorldPlace& place = worlds_[all.places.front()->unit];
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

void Remotes::give_back(const std::vector<std::string>& keys, const RemoteWorld* world) {
  const std::lock_guard lock(mutex_);
  for (WorldPlace& place : worlds_)
    if (world && place.world == world) place.taken = false;
  for (const std::string& key : keys) places_.at(key).taken = false;
}

void Remotes::post(std::size_t unit, services::WorkQueue::Work work) {
  const std::lock_guard lock(mutex_);
  if (unit < units_.size()) units_[unit]->post(std::move(work));
}

}  // namespace race::remote
