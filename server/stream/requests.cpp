#include "server/stream/requests.h"

#include <algorithm>
#include <array>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/accounts/rights.h"

namespace race::server {
namespace {

struct Client {
  const std::shared_ptr<Subscriber>& subscriber;
  const Value& message;
  const StreamTargets& to;
};

using Errors = std::vector<Error>;

/// A sequence number or an id; nothing if it is absent or something else.
std::optional<std::int64_t> read_number(Fields& fields, const char* name, Fields::Need need) {
  const Value* value = fields.find(name, need);
  if (!value) return std::nullopt;
  if (value->is_integer()) return value->as_integer();
  fields.violation(ErrorCode::type, "`" + std::string(name) + "` must be a whole number", name);
  return std::nullopt;
}

void report(const Expected<void>& done, Errors& errors) {
  if (!done) errors.push_back(done.error());
}

// One function for each type: reads the rest of the message and, if nothing is wrong with it, does it.

void subscribe(Fields& fields, const Client& client, Errors& errors) {
  const std::string channel = fields.text("channel", Fields::Need::required).value_or("");
  const auto since = read_number(fields, "since", Fields::Need::optional);
  fields.close();
  if (auto may = check_channel(client.subscriber->identity(), channel); !may && errors.empty())
    return client.to.hub.refuse(client.subscriber, channel, {std::move(may).error()});
  if (errors.empty()) client.to.hub.subscribe(client.subscriber, channel, since);
}

void unsubscribe(Fields& fields, const Client& client, Errors& errors) {
  const std::string channel = fields.text("channel", Fields::Need::required).value_or("");
  fields.close();
  if (!errors.empty()) return;
  if (auto may = check_channel(client.subscriber->identity(), channel); !may)
    return client.to.hub.refuse(client.subscriber, channel, {std::move(may).error()});
  client.to.presence.unsubscribed(*client.subscriber, channel);
  client.to.hub.unsubscribe(client.subscriber, channel);
}

void announce(Fields& fields, const Client& client, Errors& errors) {
  const std::string name = fields.text("name", Fields::Need::required).value_or("");
  const bool sound = fields.boolean("sound").value_or(false);
  const auto place = fields.text("place");
  if (place && place->empty()) fields.violation(ErrorCode::name, "`place` is empty", "place");
  fields.close();
  if (errors.empty()) report(client.to.displays.announce(client.subscriber, name, sound, place.value_or("")), errors);
}

void answer(Fields& fields, const Client& client, Errors& errors) {
  const auto question = read_number(fields, "question", Fields::Need::required);
  const Value* answer = fields.find("answer", Fields::Need::required);
  fields.close();
  if (!errors.empty()) return;
  report(client.to.displays.answer(*client.subscriber, static_cast<std::uint64_t>(*question), *answer), errors);
}

void press(Fields& fields, const Client& client, Errors& errors) {
  const std::string button = fields.text("button", Fields::Need::required).value_or("");
  fields.close();
  if (errors.empty()) report(client.to.displays.press(*client.subscriber, button), errors);
}

void played(Fields& fields, const Client& client, Errors& errors) {
  const auto sound = read_number(fields, "sound", Fields::Need::required);
  fields.close();
  if (errors.empty()) report(client.to.displays.played(*client.subscriber, static_cast<std::uint64_t>(*sound)), errors);
}

void gather(Fields& fields, const Client& client, Errors& errors) {
  fields.close();
  if (errors.empty()) client.subscriber->gather();
}

// Read by who executes them.

void edit(Fields&, const Client& client, Errors&) { client.to.edits.request_edit(client.subscriber, client.message); }

void presence(Fields&, const Client& client, Errors&) {
  client.to.presence.request_presence(client.subscriber, client.message);
}

struct Type {
  std::string_view name;
  void (*handle)(Fields& fields, const Client& client, Errors& errors);
  bool is_recorded = false;  // in the audit log; edits are, when they are made
};

constexpr std::array<Type, 9> kTypes = {{
    {"subscribe", subscribe},
    {"unsubscribe", unsubscribe},
    {"display", announce},
    {"answer", answer, true},
    {"press", press, true},
    {"played", played},
    {"gather", gather},
    {"edit", edit},
    {"presence", presence},
}};

void handle(const Client& client, Errors& errors) {
  Fields fields(client.message, "", "the message", errors, Fields::Paths::field);
  const std::string name = fields.text("type", Fields::Need::required).value_or("");
  const auto type = std::ranges::find(kTypes, name, &Type::name);
  if (type == kTypes.end()) {
    std::string known;
    for (const Type& each : kTypes) known += (known.empty() ? "" : ", ") + quote(each.name);
    if (errors.empty()) fields.violation(ErrorCode::type, "`type` must be one of " + known, "type");
    return;
  }
  const Identity& identity = client.subscriber->identity();
  if (auto may = check_message(identity, name); !may) return errors.push_back(std::move(may).error());
  type->handle(fields, client, errors);
  if (!type->is_recorded) return;
  client.to.records.record(identity, name, errors.empty() ? "accepted" : std::string(race::name(errors.front().code)));
}

}  // namespace

void handle_stream_request(std::string_view message, const std::shared_ptr<Subscriber>& subscriber,
                           const StreamTargets& targets) {
  const auto json = parse_json(message);
  if (!json) return targets.hub.refuse(subscriber, "", {json.error()});
  Errors errors;
  handle({subscriber, *json, targets}, errors);
  if (!errors.empty()) targets.hub.refuse(subscriber, "", std::move(errors));
}

}  // namespace race::server
