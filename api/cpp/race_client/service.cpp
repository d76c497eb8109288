#include "api/cpp/race_client/service.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "api/cpp/race_client/declaration.h"
#include "api/cpp/race_client/hosted.h"
#include "api/cpp/race_client/program.h"
#include "api/cpp/race_client/values.h"
#include "core/value/expected.h"

namespace race::client {
namespace {

const Value& argument(const Dict& arguments, std::string_view parameter, bool (Value::*is)() const noexcept,
                      const char* kind) {
  const Value* value = arguments.find(parameter);
  if (!value) throw std::invalid_argument("there is no argument " + quote(parameter));
  if (!(value->*is)()) throw std::invalid_argument("the argument " + quote(parameter) + " is no " + kind);
  return *value;
}

}  // namespace

// ---- Failure

Failure::Failure(std::string_view code, std::string message, const Dict& more) : message_(std::move(message)) {
  Dict error{{"code", code}};
  if (!message_.empty()) error.set("message", message_);
  for (const auto& [field, value] : more)
    if (!error.find(field)) error.set(field, value);
  if (message_.empty()) message_ = code;
  error_ = std::move(error);
}

// ---- Call

double Call::number(std::string_view parameter) const {
  return argument(arguments_, parameter, &Value::is_numeric, "number").to_double();
}
std::int64_t Call::integer(std::string_view parameter) const {
  return argument(arguments_, parameter, &Value::is_integer, "int").as_integer();
}
bool Call::flag(std::string_view parameter) const {
  return argument(arguments_, parameter, &Value::is_bool, "bool").as_bool();
}
const std::string& Call::text(std::string_view parameter) const {
  return argument(arguments_, parameter, &Value::is_string, "string").as_string();
}

void Call::pause(double seconds) const {
  if (call_.workers.wait_for_end(call_, seconds)) throw Stopped();
}
bool Call::stopped() const { return call_.over; }

// ---- Operation

Operation& Operation::moves() {
  declared_.model.moves = true;
  return *this;
}
Operation& Operation::safe() {
  declared_.model.safe = true;
  return *this;
}
Operation& Operation::reads() {
  declared_.model.reads = true;
  return *this;
}
Operation& Operation::busy(std::string state) {
  declared_.busy = std::move(state);
  return *this;
}
Operation& Operation::stops(std::string state) {
  declared_.stops = std::move(state);
  return *this;
}
Operation& Operation::parameter(std::string name, Value type, Parameter more) {
  if (more.value) more.value->freeze();
  declared_.model.parameters.push_back({std::move(name), frozen(std::move(type)), std::move(more.unit),
                                        std::move(more.doc), more.min, more.max, std::move(more.value)});
  return *this;
}
Operation& Operation::result(Value type) {
  declared_.model.result = frozen(std::move(type));
  return *this;
}
Operation& Operation::doc(std::string text) {
  declared_.model.doc = std::move(text);
  return *this;
}
void Operation::set_handler(Handler handler) { declared_.handler = std::move(handler); }

// ---- Service

struct Service::State {
  Declaration declaration;
  Hosted hosted{declaration};
};

Service::Service(std::string key, Place place) : state_(std::make_unique<State>()) {
  state_->declaration.type = key;
  state_->declaration.key = std::move(key);
  state_->declaration.place = place;
}
Service::~Service() = default;

void Service::type(std::string name) { state_->declaration.type = std::move(name); }
void Service::version(std::string text) { state_->declaration.version = std::move(text); }

void Service::event(std::string name, Value type, Event more, Place place) {
  rsm::Event model{std::move(name), frozen(std::move(type)), more.sampled, more.rate_hz, std::move(more.doc)};
  state_->declaration.events.push_back({std::move(model), place});
}

Operation Service::operation(std::string name, Place place) {
  DeclaredOperation& declared = state_->declaration.operations.emplace_back();
  declared.model.name = std::move(name);
  declared.model.error = "any";
  declared.place = place;
  return Operation(declared);
}

void Service::rsm(std::string json) { state_->declaration.rsm_text = std::move(json); }
void Service::rsm_file(std::string path) { read_rsm_file(state_->declaration, std::move(path)); }
void Service::on_halt(std::function<void()> function) { state_->declaration.on_halt = std::move(function); }

void Service::emit(std::string_view event, Value data) { state_->hosted.emit(event, std::move(data)); }
void Service::take(std::string_view transition) { state_->hosted.take(transition); }
void Service::log(std::string_view text) { state_->hosted.log(text); }
std::string Service::state() const { return state_->hosted.state(); }
std::optional<double> Service::speed_limit() const { return state_->hosted.speed_limit(); }

int Service::run(int argc, char** argv) { return client::run(argc, argv, {this}); }

int run(int argc, char** argv, std::initializer_list<Service*> services) {
  std::vector<Hosted*> hosted;
  for (Service* each : services) hosted.push_back(&each->state_->hosted);
  return run_program(argc, argv, hosted);
}

}  // namespace race::client
