#include "services/remote/process_host.h"

#include <algorithm>
#include <chrono>

#include "core/rsm/document.h"
#include "services/host/call_ledger.h"

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
struct ProcessHost::ComponentEntry final : services::ServiceHost {
  ComponentEntry(ProcessHost& its_process, std::size_t its_number, std::string its_key, std::string its_type)
      : process(its_process), number(its_number), key(std::move(its_key)), type(std::move(its_type)) {}

  services::Time now() const override { return process.clock_.now(); }

  void transition(std::string_view id, services::CallId call) override {
    Message message = message_of(Kind::transition, key, id);
    message.call = call;
    process.send(message);
  }
  void result(services::CallId call, Value value) override { respond(Kind::result, call, std::move(value)); }
  void error(services::CallId call, Value value) override { respond(Kind::error, call, std::move(value)); }
  void respond(Kind kind, services::CallId call, Value value) {
    Message message = message_of(kind, key);
    message.call = call;
    message.value = std::move(value);
    process.send(message);
  }
  void reject(services::CallId call) override {
    Message message = message_of(Kind::reject, key);
    message.call = call;
    process.send(message);
  }
  void event(std::string_view name, Value data) override {
    Message message = message_of(Kind::event, key, name);
    message.value = std::move(data);
    process.send(message);
  }
  void publish(std::string_view flow, services::PacketPtr packet) override {
    Message message = message_of(Kind::publish, key, flow);
    message.time = packet->time;
    message.value = packet->header;
    message.bytes = packet->bytes;
    process.send(message, key + " " + message.name);
  }
  void subscribe(std::string_view service, std::string_view flow, bool on) override {
    Message message = message_of(Kind::subscribe, key, flow);
    message.service = std::string(service);
    message.on = on;
    process.send(message);
  }
  services::ReservationId reserve(services::Time at) override { return process.reservations_.reserve(number, at); }
  void fulfil(services::ReservationId reservation, std::function<void()> answer) override {
    process.reservations_.fulfil(reservation, std::move(answer));
  }
  void log(std::string text) override { process.send(message_of(Kind::log, key, cut(std::move(text)))); }

  ProcessHost& process;
  std::size_t number;
  std::string key, type;
  std::function<void()> on_host_change;
  std::unique_ptr<services::Component> component;
};

ProcessHost::ProcessHost() = default;

ProcessHost::~ProcessHost() {
  server_ = nullptr;
  reservations_.close();
  for (const auto& entry : entries_)
    if (entry->component) entry->component->stop();
}

services::ServiceHost& ProcessHost::declare(std::string key, std::string type) {
  entries_.push_back(std::make_unique<ComponentEntry>(*this, entries_.size(), std::move(key), std::move(type)));
  return *entries_.back();
}

void ProcessHost::attach(const std::string& key, std::unique_ptr<services::Component> component) {
  find(key)->component = std::move(component);
}

void ProcessHost::on_host_change(const std::string& key, std::function<void()> work) {
  find(key)->on_host_change = std::move(work);
}

Expected<Value> ProcessHost::request(const std::string& key, std::string_view function, Dict arguments) {
  constexpr auto kLook = std::chrono::milliseconds(10);  // whether the connection is still there
  SendQueue* server = server_;
  if (!server || !accepted_) return unexpected(ErrorCode::unavailable, "the server is not there");
  Message message = message_of(Kind::request, key, function);
  message.number = ++requests_;
  message.kwargs = std::move(arguments);
  ASSIGN_OR_RETURN(EncodedMessage encoded, encode(message));
  if (!server->push(std::move(encoded))) return unexpected(ErrorCode::unavailable, "the server takes nothing more");
  const services::MutexLock lock(mutex_);
  const auto answered = [&]() REQUIRES(mutex_) { return reply_ && reply_->number == message.number; };
  while (!reply_arrived_.wait_for(mutex_, kLook, answered))
    if (ended_ && ended_()) return unexpected(ErrorCode::unavailable, "the connection has ended");
  return std::move(reply_->value);
}

void ProcessHost::handle_reply(Message reply) {
  {
    const services::MutexLock lock(mutex_);
    reply_ = std::move(reply);
  }
  reply_arrived_.notify_one();
}

ProcessHost::ComponentEntry* ProcessHost::find(const std::string& key) const {
  for (const auto& entry : entries_)
    if (entry->key == key) return entry.get();
  return nullptr;
}

Message ProcessHost::hello() const {
  List components;
  for (const auto& entry : entries_)
    components.push_back(
        Dict{{"key", entry->key}, {"type", entry->type}, {"rsm", rsm::write_service(entry->component->model())}});
  Message message;
  message.kind = Kind::hello;
  message.number = kProtocol;
  message.value = std::move(components);
  message.world = world_.json;
  message.on = asks_for_violations_;
  return message;
}

void ProcessHost::connect(SendQueue& server, std::function<bool()> ended) {
  ended_ = std::move(ended);
  server_ = &server;
}
void ProcessHost::disconnect() { server_ = nullptr; }

// A response that cannot be sent becomes an error response, so that nobody waits for it.
void ProcessHost::send(const Message& message, const std::string& flow) {
  SendQueue* server = server_;
  if (!server) return;
  auto encoded = encode(message);
  if (!encoded && message.call != 0 && message.kind == Kind::result) {
    Message error = message_of(Kind::error, message.key);
    error.call = message.call;
    error.value = services::error_value(race::name(encoded.error().code), encoded.error().message);
    encoded = encode(error);
  }
  if (!encoded && message.key.empty()) return;
  if (!encoded) encoded = encode(message_of(Kind::log, message.key, "not sent: " + encoded.error().message));
  if (encoded) server->push(std::move(*encoded), flow);
}

Expected<void> ProcessHost::handle(Message message) {
  silence_ = 0;
  is_halted_ = false;
  if (message.kind == Kind::ping) {
    set_clock(message.time);
    Message pong;
    pong.kind = Kind::pong;
    pong.number = message.number;
    send(pong);
    return {};
  }
  if (message.kind == Kind::welcome) {
    accepted_ = true;
    if (message.number > 0) most_silence_ = static_cast<services::Time>(message.number) / 1000;
    clock_.set(std::max(clock_.now(), message.time));
    return {};
  }
  if (message.kind == Kind::offer || message.kind == Kind::act || message.kind == Kind::watch)
    return handle_world_message(message);
  ComponentEntry* entry = find(message.key);
  if (!entry) return unexpected(ErrorCode::not_found, "this process has no such component", message.key);
  if (message.kind == Kind::packet) {
    const std::string service = message.service, flow = message.name;
    entry->component->packet(service, flow, packet_of(std::move(message)));
    return {};
  }
  if (message.kind == Kind::violation) {  // it has the time of what was announced
    entry->component->violated({message.time, message.name, message.value.as_string(), message.call, message.service});
    return {};
  }
  set_clock(message.time);
  if (message.kind == Kind::news && entry->on_host_change) entry->on_host_change();
  if (message.kind == Kind::wanted) entry->component->demand_changed(message.name, message.on);
  if (message.kind == Kind::limit_speed) entry->component->limit_speed(tool_speed_of(message));
  if (message.kind == Kind::call)
    entry->component->call({message.call, message.name, std::move(message.args), std::move(message.kwargs)});
  return {};
}

// An answer that cannot be sent becomes an error, so that nobody waits for it.
Expected<void> ProcessHost::handle_world_message(const Message& message) {
  if (!world_.execute) return unexpected(ErrorCode::not_found, "this process has no world", name(message.kind).data());
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
  if (Expected<Value> done = world_.execute(message.value)) {
    answer.value = std::move(*done);
    if (auto encoded = encode(answer); !encoded) fail(encoded.error());
  } else {
    fail(done.error());
  }
  send(answer);
  return {};
}

void ProcessHost::send_pose(Value pose) {
  Message message = message_of(Kind::pose, "");
  message.value = std::move(pose);
  send(message, std::string(name(Kind::pose)));
}

void ProcessHost::set_clock(services::Time server) {
  const services::Time now = clock_.now();
  if (server > now + kMaxClockOffset) clock_.set(server);
  clock_ahead_ = now > server + kMaxClockOffset ? now - server : 0;
}

// Of a flow, the newest packet waits.
bool ProcessHost::receive(Message message, std::size_t bytes) {
  std::string flow;
  if (message.kind == Kind::packet) flow = message.key + " " + message.service + " " + message.name;
  return received_.push({std::move(message), bytes}, flow) || !received_.overflowed();
}

// What had come when the step began.
Expected<void> ProcessHost::handle_received() {
  for (std::size_t left = received_.size(); left > 0; --left) {
    auto next = received_.pop();
    if (!next) break;  // a newer packet has replaced one of these
    if (auto handled = handle(std::move(next->message)); !handled) return handled;
  }
  return {};
}

// A server that hangs, or is stopped, calls nobody: what moves must not go on for that reason. Counted in steps.
void ProcessHost::notice_silence() {
  if (!accepted_ || is_halted_) return;
  silence_ += kStep;
  if (silence_ < most_silence_) return;
  is_halted_ = true;
  for (const auto& entry : entries_) {
    entry->component->halt();
    entry->log("halts: the server is silent");
  }
}

Expected<void> ProcessHost::step() {
  if (auto handled = handle_received(); !handled) return handled;
  notice_silence();
  if (before_step_) before_step_();
  if (clock_ahead_ > 0) {
    clock_ahead_ -= kStep;
  } else {
    clock_.set(clock_.now() + kStep);
  }
  for (const services::Reservations::Due& due : reservations_.take(clock_.now(), false)) due.answer();
  for (const auto& entry : entries_) entry->component->step();
  if (after_step_) after_step_();
  return {};
}

}  // namespace race::remote
