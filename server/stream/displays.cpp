#include "server/stream/displays.h"

#include <utility>

#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"

namespace race::server {
namespace {

std::string channel_of(const std::string& display) { return fill(kDisplayChannel, {display}); }

Value number(std::uint64_t n) { return static_cast<std::int64_t>(n); }

List texts(const std::vector<std::string>& from) { return {from.begin(), from.end()}; }

Value message_json(const display::Message& message) {
  Dict json{{"text", message.text}, {"buttons", texts(message.buttons)}};
  if (!message.image.empty()) json.set("image", message.image);
  if (message.progress) json.set("progress", *message.progress);
  return json;
}

Value question_json(const display::Question& question) {
  Dict json{{"id", number(question.id)}, {"text", question.text}};
  if (!question.number) {
    json.set("buttons", texts(question.buttons));
    return json;
  }
  Dict entry{{"unit", question.number->unit}, {"min", question.number->min}, {"max", question.number->max}};
  if (question.number->value) entry.set("value", *question.number->value);
  json.set("number", std::move(entry));
  return json;
}

Value sound_json(const display::Sound& sound) {
  return Dict{{"id", number(sound.id)}, {"name", sound.name}, {"volume", sound.volume}, {"repeat", sound.repeat}};
}

}  // namespace

Value display_json(const display::Content& content) {
  Dict json{{"display", content.display}};
  if (content.message) json.set("message", message_json(*content.message));
  if (content.question) json.set("question", question_json(*content.question));
  if (content.sound) json.set("sound", sound_json(*content.sound));
  return json;
}

Displays::Displays(display::Screens& screens, Hub& hub) : screens_(screens), hub_(hub) { screens_.watch(this); }
Displays::~Displays() { screens_.watch(nullptr); }

std::optional<Source> Displays::source(const std::string& display) {
  if (!screens_.content(display)) return std::nullopt;
  return Source{true, [this, display] { screens_.repeat(display); }, {}};
}

// Connected anew before the old one goes: a display that only learns to make sounds is never gone.
Expected<void> Displays::announce(const std::shared_ptr<Subscriber>& subscriber, const std::string& name, bool sound,
                                  const std::string& place) {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const auto id, screens_.connect(name, sound, place));
  const Connection before = std::exchange(connections_[subscriber.get()], {id, name});
  if (before.id != 0) screens_.disconnect(before.id);
  if (before.id != 0 && before.name != name) hub_.unsubscribe(subscriber, channel_of(before.name));
  hub_.subscribe(subscriber, channel_of(name), std::nullopt);
  return {};
}

Expected<void> Displays::answer(const Subscriber& subscriber, std::uint64_t question, Value answer) {
  ASSIGN_OR_RETURN(const Connection connection, find(subscriber));
  return screens_.answer(connection.name, std::move(answer), question);
}

Expected<void> Displays::press(const Subscriber& subscriber, const std::string& button) {
  ASSIGN_OR_RETURN(const Connection connection, find(subscriber));
  return screens_.press(connection.name, button);
}

Expected<void> Displays::played(const Subscriber& subscriber, std::uint64_t sound) {
  ASSIGN_OR_RETURN(const Connection connection, find(subscriber));
  return screens_.played(connection.id, sound);
}

void Displays::disconnect(const Subscriber& subscriber) {
  const services::MutexLock lock(mutex_);
  const auto known = connections_.find(&subscriber);
  if (known == connections_.end()) return;
  screens_.disconnect(known->second.id);
  connections_.erase(known);
}

Expected<Displays::Connection> Displays::find(const Subscriber& subscriber) const {
  const services::MutexLock lock(mutex_);
  const auto known = connections_.find(&subscriber);
  if (known == connections_.end())
    return unexpected(ErrorCode::conflict, "this connection is no display; it announces itself first", "type");
  return known->second;
}

void Displays::changed(const display::Content& content) {
  Value json = display_json(content);
  hub_.publish_delta(channel_of(content.display), std::move(json.freeze()));
}

void Displays::forgotten(const std::string& display) {
  hub_.close(channel_of(display), {{ErrorCode::not_found, "there is no such display any more", display}});
}

}  // namespace race::server
