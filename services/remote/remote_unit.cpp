#include "services/remote/remote_unit.h"

#include <algorithm>
#include <chrono>

#include "core/rsm/document.h"

namespace race::remote {
namespace {

Message message_of(Kind kind, const std::string& key, std::string_view name = {}) {
  Message message;
  message.kind = kind;
  message.key = key;
  message.name = std::string(name);
  return message;
}

}  // namespace

// The ServiceHost of one component.
struct RemoteUnit::Slot final : services::ServiceHost {
  Slot(RemoteUnit& its_unit, std::size_t its_number, std::string its_key, std::string its_type)
      : unit(its_unit), number(its_number), key(std::move(its_key)), type(std::move(its_type)) {}

  services::Time now() const override { return unit.clock_.now(); }

  void transition(std::string_view id, services::CallId call) override {
    Message message = message_of(Kind::transition, key, id);
    message.call = call;
    unit.send(message);
  }
  void result(services::CallId call, Value value) override { respond(Kind::result, call, std::move(value)); }
  void error(services::CallId call, Value value) override { respond(Kind::error, call, std::move(value)); }
  void respond(Kind kind, services::CallId call, Value value) {
    Message message = message_of(kind, key);
    message.call = call;
    message.value = std::move(value);
    unit.send(message);
  }
  void reject(services::CallId call) override {
    Message message = message_of(Kind::reject, key);
    message.call = call;
    unit.send(message);
  }
  void event(std::string_view name, Value data) override {
    Message message = message_of(Kind::event, key, name);
    message.value = std::move(data);
    unit.send(message);
  }
  void publish(std::string_view flow, services::PacketPtr packet) override {
    Message message = message_of(Kind::publish, key, flow);
    message.time = packet->time;
    message.value = packet->header;
    message.bytes = packet->bytes;
    unit.send(message, key + " " + message.name);
  }
  void subscribe(std::string_view service, std::string_view flow, bool on) override {
    Message message = message_of(Kind::subscribe, key, flow);
    message.service = std::string(service);
    message.on = on;
    unit.send(message);
  }
  services::ReservationId reserve(services::Time at) override { return unit.reservations_.reserve(number, at); }
  void fulfil(services::ReservationId reservation, std::function<void()> answer) override {
    unit.reservations_.fulfil(reservation, std::move(answer));
  }
  void log(std::string text) override { unit.send(message_of(Kind::log, key, cut(std::move(text)))); }

  RemoteUnit& unit;
  std::size_t number;
  std::string key, type;
  std::function<void()> news;
  std::unique_ptr<services::Component> component;
};

RemoteUnit::RemoteUnit() = default;

RemoteUnit::~RemoteUnit() {
  server_ = nullptr;
  reservations_.close();
  for (const auto& slot : slots_)
    if (slot->component) slot->component->stop();
}

services::ServiceHost& RemoteUnit::declare(std::string key, std::string type) {
  slots_.push_back(std::make_unique<Slot>(*this, slots_.size(), std::move(key), std::move(type)));
  return *slots_.back();
}

void RemoteUnit::attach(const std::string& key, std::unique_ptr<services::Component> component) {
  find(key)->component = std::move(component);
}

void RemoteUnit::on_news(const std::string& key, std::function<void()> work) { find(key)->news = std::move(work); }

Expected<Value> RemoteUnit::request(const std::string& key, std::string_view function, Dict arguments) {
  constexpr auto kLook = std::chrono::milliseconds(10);  // whether the connection is still there
  FrameQueue* server = server_;
  if (!server || !welcome_) return unexpected(ErrorCode::unavailable, "the server is not there");
  Message message = message_of(Kind::request, key, function);
  message.number = ++requests_;
  message.kwargs = std::move(arguments);
  ASSIGN_OR_RETURN(Frame frame, encode(message));
  if (!server->push(std::move(frame))) return unexpected(ErrorCode::unavailable, "the server takes nothing more");
  std::unique_lock lock(mutex_);
  const auto answered = [&] { return reply_ && reply_->number == message.number; };
  while (!came_.wait_for(lock, kLook, answered))
    if (over_ && over_()) return unexpected(ErrorCode::unavailable, "the connection has ended");
  return std::move(reply_->value);
}

void RemoteUnit::replied(Message reply) {
  {
    const std::lock_guard lock(mutex_);
    reply_ = std::move(reply);
  }
  came_.notify_one();
}

RemoteUnit::Slot* RemoteUnit::find(const std::string& key) const {
  for (const auto& slot : slots_)
    if (slot->key == key) return slot.get();
  return nullptr;
}

Message RemoteUnit::hello() const {
  List components;
  for (const auto& slot : slots_)
    components.push_back(
        Dict{{"key", slot->key}, {"type", slot->type}, {"rsm", rsm::write_service(slot->component->model())}});
  Message message;
  message.kind = Kind::hello;
  message.number = kProtocol;
  message.value = std::move(components);
  message.world = world_.json;
  return message;
}

void RemoteUnit::connect(FrameQueue& server, std::function<bool()> over) {
  over_ = std::move(over);
  server_ = &server;
}
void RemoteUnit::disconnect() { server_ = nullptr; }

// A response that cannot be sent becomes an error response, so that nobody waits for it.
void RemoteUnit::send(const Message& message, const std::string& flow) {
  FrameQueue* server = server_;
  if (!server) return;
  auto frame = encode(message);
  if (!frame && message.call != 0 && message.kind == Kind::result) {
    Message error = message_of(Kind::error, message.key);
    error.call = message.call;
    error.value = services::error_value(race::name(frame.error().code), frame.error().message);
    frame = encode(error);
  }
  if (!frame && message.key.empty()) return;
  if (!frame) frame = encode(message_of(Kind::log, message.key, "not sent: " + frame.error().message));
  if (frame) server->push(std::move(*frame), flow);
}

Expected<void> RemoteUnit::handle(Message message) {
  if (message.kind == Kind::ping) {
    set_clock(message.time);
    Message pong;
    pong.kind = Kind::pong;
    pong.number = message.number;
    send(pong);
    return {};
  }
  if (message.kind == Kind::welcome) {
    welcome_ = true;
    clock_.set(std::max(clock_.now(), message.time));
    return {};
  }
  if (message.kind == Kind::offer || message.kind == Kind::act || message.kind == Kind::watch) return in_world(message);
  Slot* slot = find(message.key);
  if (!slot) return unexpected(ErrorCode::not_found, "this process has no such component", message.key);
  if (message.kind == Kind::packet) {
    const std::string service = message.service, flow = message.name;
    slot->component->packet(service, flow, packet_of(std::move(message)));
    return {};
  }
  set_clock(message.time);
  if (message.kind == Kind::news && slot->news) slot->news();
  if (message.kind == Kind::wanted) slot->component->wanted(message.name, message.on);
  if (message.kind == Kind::call)
    slot->component->call({message.call, message.name, std::move(message.args), std::move(message.kwargs)});
  return {};
}

// What cannot be told is refused, so that nobody waits for it.
Expected<void> RemoteUnit::in_world(const Message& message) {
  if (!world_.act) return unexpected(ErrorCode::not_found, "this process has no world", name(message.kind).data());
  set_clock(message.time);
  if (message.kind == Kind::watch) {
    world_.watch(message.on);
    return {};
  }
  Message answer = message_of(message.kind == Kind::offer ? Kind::ready : Kind::done, "");
  answer.number = message.number;
  if (message.kind == Kind::offer) {
    send(answer);
    return {};
  }
  const auto fail = [&answer](const Error& error) {
    answer.kind = Kind::failed;
    answer.value = error_json(error);
  };
  if (Expected<Value> done = world_.act(message.value)) {
    answer.value = std::move(*done);
    if (auto frame = encode(answer); !frame) fail(frame.error());
  } else {
    fail(done.error());
  }
  send(answer);
  return {};
}

void RemoteUnit::show(Value pose) {
  Message message = message_of(Kind::pose, "");
  message.value = std::move(pose);
  send(message, std::string(name(Kind::pose)));
}

void RemoteUnit::set_clock(services::Time server) {
  const services::Time now = clock_.now();
  if (server > now + kApart) clock_.set(server);
  ahead_ = now > server + kApart ? now - server : 0;
}

void RemoteUnit::step() {
  queue_.run();
  if (before_step_) before_step_();
  if (ahead_ > 0) {
    ahead_ -= kStep;
  } else {
    clock_.set(clock_.now() + kStep);
  }
  for (const services::Reservations::Due& due : reservations_.take(clock_.now(), false)) due.answer();
  for (const auto& slot : slots_) slot->component->step();
  if (after_step_) after_step_();
}

}  // namespace race::remote
