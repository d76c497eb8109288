#include "server/editing/presence_channels.h"

#include <algorithm>
#include <utility>

#include "server/editing/presence_request.h"
#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"

namespace race::server {
namespace {

using Clock = std::chrono::steady_clock;

Value joined_json(const std::string& document, std::int64_t id) {
  Value out(Dict{{"document", document}, {"id", id}});
  return std::move(out.freeze());
}

}  // namespace

void PresenceChannels::request_presence(const std::shared_ptr<Subscriber>& sender, const Value& message) {
  std::vector<Error> errors;
  auto [document, person] = read_presence_request(message, errors);
  if (!errors.empty()) return hub_.refuse(sender, "", std::move(errors));
  const std::string channel = fill(kPresenceChannel, {document});
  const services::MutexLock lock(mutex_);
  const auto shown = presence_.show(sender.get(), document, std::move(person), Clock::now());
  if (!shown)
    hub_.refuse(sender, channel, {shown.error()});
  else if (shown->is_new)
    hub_.send(sender, channel, "joined", joined_json(document, shown->id));
  tell();
}

void PresenceChannels::unsubscribed(const Subscriber& subscriber, const std::string& channel) {
  const auto of = match(kPresenceChannel, channel);
  if (!of) return;
  const services::MutexLock lock(mutex_);
  presence_.leave(&subscriber, of->at("name"));
  tell();
}

void PresenceChannels::disconnected(const Subscriber& subscriber) {
  const services::MutexLock lock(mutex_);
  presence_.leave(&subscriber);
  tell();
}

void PresenceChannels::publish_snapshot(const std::string& document) {
  const services::MutexLock lock(mutex_);
  hub_.publish_snapshot(fill(kPresenceChannel, {document}), presence_.snapshot(document));
}

void PresenceChannels::tell() {
  for (auto& [document, data] : presence_.take_due(Clock::now()))
    hub_.publish_delta(fill(kPresenceChannel, {document}), std::move(data));
  tell_later();
  look_for_silent();
}

void PresenceChannels::tell_later() {
  const auto due = presence_.next_due();
  if (!due || (telling_ && *telling_ <= *due)) return;
  telling_ = due;
  const auto wait = std::chrono::ceil<std::chrono::milliseconds>(*due - Clock::now());
  deadlines_.after(std::max(wait, std::chrono::milliseconds(0)), [this] {
    const services::MutexLock lock(mutex_);
    telling_.reset();
    tell();
  });
}

void PresenceChannels::look_for_silent() {
  if (is_looking_ || presence_.empty()) return;
  is_looking_ = true;
  deadlines_.after(limits_.look, [this] {
    const services::MutexLock lock(mutex_);
    is_looking_ = false;
    presence_.drop_silent(Clock::now() - limits_.silence);
    tell();
  });
}

}  // namespace race::server
