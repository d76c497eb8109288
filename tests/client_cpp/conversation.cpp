#include "tests/client_cpp/conversation.h"

#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

#include "core/value/json.h"
#include "tests/client_cpp/asks.h"
#include "tests/client_cpp/calls_by_name.h"
#include "tests/client_cpp/patterns.h"

namespace race::client {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPatience = 20s;  // no conversation needs them

std::chrono::milliseconds milliseconds_of(const Value& seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(1000 * seconds.to_double()));
}

// What a pattern may say of an error.
Value fields_of(const ApiError& error) {
  Dict fields{{"status", error.status},
              {"code", error.code},
              {"path", error.path},
              {"errors", error.errors},
              {"may_be_done", error.may_be_done}};
  if (error.service.empty()) return fields;
  fields.set("service", error.service);
  fields.set("operation", error.operation);
  fields.set("error", error.error);
  return fields;
}

// What a pattern may say of an update.
Value fields_of(const Update& update) {
  return Dict{{"kind", update.kind == Update::Kind::delta ? "delta" : "snapshot"},
              {"state", update.state},
              {"delta", update.delta},
              {"merged", static_cast<std::int64_t>(update.merged)}};
}

// The fields of several dicts.
Dict joined(const Value& one, const Value& other) {
  Dict all = one.as_dict();
  for (const auto& [key, value] : other.as_dict()) all.set(key, value);
  return all;
}

}  // namespace

Conversation::Conversation(TestServer server) : server_(std::move(server)) {}

void Conversation::hold(const List& steps) {
  int number = 0;
  for (const Value& step : steps) {
    ++number;
    if (const auto why = hold_step(step))
      throw std::runtime_error("step " + std::to_string(number) + ", " + to_json(step).substr(0, 300) + ": " + *why);
  }
}

// Why a step does not come to what it says.
std::optional<std::string> Conversation::hold_step(const Value& step) {
  const Value* const until = step.find("until");
  const Value* const wanted = until ? until : step.find("answer");
  for (const auto end = Clock::now() + kPatience;; std::this_thread::sleep_for(20ms)) {
    const auto answer = outcome(step);
    if (!answer) return refusal_of(step, answer.error());
    if (step.find("refused")) return "it is answered: " + to_json(*answer).substr(0, 300);
    auto why = wanted ? mismatch(*wanted, *answer, saved_) : std::nullopt;
    if (!why) save(step, *answer);
    if (!why || !until || Clock::now() > end) return why;
  }
}

std::optional<std::string> Conversation::refusal_of(const Value& step, const ApiError& error) {
  const Value* const refused = step.find("refused");
  return refused ? mismatch(*refused, fields_of(error), saved_) : "it is refused: " + to_string(error);
}

void Conversation::save(const Value& step, const Value& answer) {
  if (const Value* const names = step.find("save"))
    for (const auto& [name, pointer] : names->as_dict())
      saved_.set(name.as_string(), part_at(answer, pointer.as_string()));
}

// What a step is answered.
Answered<Value> Conversation::outcome(const Value& step) {
  if (const Value* const let = step.find("let")) {
    const Value values = value_of(*let, saved_);
    for (const auto& [name, value] : values.as_dict()) saved_.set(name.as_string(), value);
    return Value();
  }
  if (step.find("next")) return next(step);
  if (step.find("rest")) return rest();
  Client& client = client_of(step.find("by"));
  return step.find("follow") ? follow(step, client) : talk(step, client);
}

// A part of a step, with what its names mean.
Value Conversation::given(const Value& step, std::string_view field, Value otherwise) {
  const Value* const found = step.find(field);
  return found ? value_of(*found, saved_) : otherwise;
}

Answered<Value> Conversation::talk(const Value& step, Client& client) {
  if (const Value* const operation = step.find("call")) {
    const Value query = joined(given(step, "query", Dict()), given(step, "headers", Dict()));
    const Value body = given(step, "body", Value());
    const Given of_call(List(), joined(given(step, "path", Dict()), query),
                        body.is_null() ? std::nullopt : std::optional(body));
    const Call call = call_by_name(operation->as_string(), of_call);
    of_call.close();
    return client.send(call);
  }
  const Given of_method(given(step, "arguments", List()).as_list(), given(step, "options", Dict()).as_dict());
  auto answer = ask(step.find("ask")->as_string(), client, of_method);
  of_method.close();
  return answer;
}

Answered<Value> Conversation::follow(const Value& step, Client& client) {
  const Value options = given(step, "options", Dict());
  const Value* const quiet = options.find("quiet");
  quiet_ = quiet ? milliseconds_of(*quiet) : kPatience;
  updates_.reset();
  auto updates = client.follow(value_of(*step.find("follow"), saved_).as_string());
  if (!updates) return tl::unexpected(std::move(updates.error()));
  updates_.emplace(std::move(*updates));
  return Value();
}

Answered<Value> Conversation::next(const Value& step) {
  const Value* const within = step.find("within");
  auto update = updates_.value().next(within ? milliseconds_of(*within) : quiet_);
  if (!update) return tl::unexpected(std::move(update.error()));
  return *update ? fields_of(**update) : Value();
}

Answered<Value> Conversation::rest() {
  List all;
  for (;;) {
    auto update = updates_.value().next(quiet_);
    if (!update) return tl::unexpected(std::move(update.error()));
    if (!*update) return Value(std::move(all));
    all.push_back(fields_of(**update));
  }
}

Client& Conversation::client_of(const Value* account) {
  const std::string name = account ? account->as_string() : "";
  const auto known = clients_.find(name);
  if (known != clients_.end()) return known->second;
  ClientOptions options;
  if (account) options.token = server_.tokens.at(name);
  auto client = Client::create(server_.url, options);
  if (!client) throw std::runtime_error(to_string(client.error()));
  return clients_.emplace(name, std::move(*client)).first->second;
}

}  // namespace race::client
