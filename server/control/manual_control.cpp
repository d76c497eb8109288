#include "server/control/manual_control.h"

#include <algorithm>
#include <array>

#include "core/value/json.h"
#include "server/accounts/secret.h"

namespace race::server {

using services::MutexLock;

namespace {

Dict of_kind(const char* kind) { return Dict{{"kind", kind}}; }

Value refusal(std::string_view kind, std::string_view code, const std::string& message) {
  return Dict{{"kind", std::string(kind)}, {"code", std::string(code)}, {"message", message}};
}

void tell(ControlClient& client, Value message) { client.tell(message.freeze()); }

void tell(const std::weak_ptr<ControlClient>& weak, Value message) {
  if (const auto client = weak.lock()) tell(*client, std::move(message));
}

void tell_lost(const std::weak_ptr<ControlClient>& client) {
  tell(client, refusal("lost", "leased", "you have not the controls of the cell any more"));
}

}  // namespace

void ManualControl::request(const std::shared_ptr<ControlClient>& client, std::string_view text) {
  struct Type {
    std::string_view name;
    void (ManualControl::*handle)(Fields& fields, const Message& message);
  };
  static constexpr std::array<Type, 4> kTypes = {{
      {"take", &ManualControl::take},
      {"beat", &ManualControl::beat},
      {"release", &ManualControl::give_back},
      {"call", &ManualControl::call},
  }};
  std::vector<Error> errors;
  const Message message{client, errors, std::chrono::steady_clock::now()};
  if (const auto json = parse_json(text)) {
    Fields fields(*json, "", "the message", errors, Fields::Paths::field);
    const std::string name = fields.text("type", Fields::Need::required).value_or("");
    const auto* const type = std::ranges::find(kTypes, name, &Type::name);
    if (type != kTypes.end())
      (this->*type->handle)(fields, message);
    else if (errors.empty())
      fields.violation(ErrorCode::type, "`type` must be `take`, `beat`, `release` or `call`", "type");
  } else {
    errors.push_back(json.error());
  }
  if (errors.empty()) return;
  std::string all;
  for (const Error& error : errors) all += (all.empty() ? "" : "; ") + to_string(error);
  tell(*client, refusal("refused", name(errors.front().code), all));
}

void ManualControl::take(Fields& fields, const Message& message) {
  const bool force = fields.boolean("force").value_or(false);
  fields.close();
  if (!message.errors.empty()) return;
  if (number_of(*message.client) != 0)
    return tell(*message.client, refusal("refused", "conflict", "you have the controls of the cell already"));
  const std::string by = name_for_people(message.client->identity());
  if (force && control_.holder() != 0) return ask(message.client, by, message.now);
  give(message.client, by, message.now);
}

void ManualControl::give(const std::shared_ptr<ControlClient>& client, const std::string& by, Steady now) {
  const std::string secret = make_secret("control_");
  Expected<std::uint64_t> number = 0;
  std::optional<Holder> before;  // who has lost them and was not told yet
  {
    const MutexLock lock(mutex_);
    number = control_.take(by, now);
    if (number) before = std::exchange(holder_, std::nullopt);
    if (before) replaced_.emplace(before->number, before->identity);
    if (number)
      holder_ = Holder{
          .client = client, .identity = client->identity(), .number = *number, .secret = digest_of_secret(secret)};
  }
  if (before) tell_lost(before->client);
  if (!number) return tell(*client, refusal("refused", name(number.error().code), number.error().message));
  record_(client->identity(), "control take", "200");
  tell(*client, Dict{{"kind", "taken"},
                     {"number", static_cast<std::int64_t>(*number)},
                     {"secret", secret},
                     {"beat_ms", std::int64_t{Control::kBeat.count()}},
                     {"silence_ms", std::int64_t{Control::kSilence.count()}},
                     {"most_calls", static_cast<std::int64_t>(PersonCalls::kMost)}});
}

// One person at a time asks.
void ManualControl::ask(const std::shared_ptr<ControlClient>& client, const std::string& by, Steady now) {
  std::int64_t id = 0;
  {
    const MutexLock lock(mutex_);
    if (!asking_ || asking_->client.expired()) {
      id = ++requests_;
      asking_ = Asking{client, id, now + kAnswerTime};
      control_.show_request(Control::Request{id, by});
    }
  }
  if (id == 0) return tell(*client, refusal("refused", "leased", "somebody else asks for the controls already"));
  record_(client->identity(), "control ask", "202");
  Dict asked = of_kind("asked");
  asked.set("request", id);
  tell(*client, std::move(asked));
}

void ManualControl::beat(Fields& fields, const Message& message) {
  fields.close();
  if (!message.errors.empty()) return;
  if (!control_.hear(number_of(*message.client), message.now))
    tell(*message.client, refusal("lost", "leased", "you have not the controls of the cell"));
}

void ManualControl::give_back(Fields& fields, const Message& message) {
  fields.close();
  if (!message.errors.empty()) return;
  if (const std::uint64_t number = number_of(*message.client))
    end(control_.release(number), {"gave the controls back", "given_back", false});
  tell(*message.client, of_kind("released"));
}

void ManualControl::disconnected(const ControlClient& client) {
  if (const std::uint64_t number = number_of(client)) end(control_.release(number), {"left the controls", "closed"});
  bool asked = false;
  {
    const MutexLock lock(mutex_);
    asked = asking_ && asking_->client.lock().get() == &client;
  }
  if (asked) drop_request("");
}

void ManualControl::check(Steady now) {
  if (auto ended = control_.release_silent(now)) end(ended, {"was silent at the controls", "silent"});
  bool late = false;
  {
    const MutexLock lock(mutex_);
    late = asking_ && asking_->until < now;
  }
  if (late) drop_request("nobody at the cell has answered");
}

// What moves stops first; then the rest is told.
void ManualControl::end(const std::optional<Control::Ended>& ended, const End& how) {
  if (!ended) return;
  cell_stop_.halt(*ended, ended->by + " " + how.why);
  std::weak_ptr<ControlClient> client;
  Identity identity;
  {
    const MutexLock lock(mutex_);
    if (holder_ && holder_->number == ended->number) {
      client = holder_->client;
      identity = holder_->identity;
      holder_.reset();
    } else if (const auto replaced = replaced_.extract(ended->number)) {
      identity = replaced.mapped();
    }
  }
  record_(identity, "control end", how.outcome);
  if (how.is_told) tell_lost(client);
  drop_request("the controls are free: take them");
}

void ManualControl::drop_request(const std::string& why) {
  std::optional<Asking> dropped;
  {
    const MutexLock lock(mutex_);
    dropped = std::exchange(asking_, std::nullopt);
    if (dropped) control_.show_request(std::nullopt);
  }
  if (dropped && !why.empty()) tell(dropped->client, refusal("refused", "leased", why));
}

Expected<void> ManualControl::answer_request(const Identity& identity, std::int64_t id, bool allow) {
  if (!is_local(identity))
    return unexpected(ErrorCode::rights, "only a display at the cell may hand the controls over");
  std::optional<Asking> asking;
  {
    const MutexLock lock(mutex_);
    if (!asking_ || asking_->id != id)
      return unexpected(ErrorCode::not_found, "nobody asks for the controls with that");
    asking = std::exchange(asking_, std::nullopt);
    control_.show_request(std::nullopt);
  }
  const auto client = asking->client.lock();
  if (!client) return unexpected(ErrorCode::not_found, "who asked for the controls has left");
  if (!allow) {
    tell(*client, refusal("refused", "leased", "a person at the cell has refused it"));
    return {};
  }
  end(control_.release(control_.holder()), {"had to give the controls over", "taken_over"});
  give(client, name_for_people(client->identity()), std::chrono::steady_clock::now());
  return {};
}

Expected<std::uint64_t> ManualControl::number_of(std::string_view secret) const {
  if (secret.empty()) return 0;
  const std::string digest = digest_of_secret(std::string(secret));
  const MutexLock lock(mutex_);
  if (holder_ && holder_->secret == digest) return holder_->number;
  return unexpected(ErrorCode::leased, "you have not the controls of the cell any more");
}

std::uint64_t ManualControl::number_of(const ControlClient& client) const {
  const MutexLock lock(mutex_);
  return holder_ && holder_->client.lock().get() == &client ? holder_->number : 0;
}

}  // namespace race::server
