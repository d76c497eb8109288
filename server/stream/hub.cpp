#include "server/stream/hub.h"

#include "core/value/json.h"
#include "server/http/errors.h"

namespace race::server {

namespace {

// What waits for a client under no channel's name: whatever clients ask for, there is one queue of refusals.
constexpr const char* kRefusals = "";

}  // namespace

Hub::Hub(Pool& pool, std::int64_t first, std::function<std::optional<Source>(const std::string&)> find)
    : strand_(pool), first_(first), find_(std::move(find)) {}

Text Hub::serialise(const std::string& channel, std::int64_t sequence, const char* kind, const Value& data) {
  return std::make_shared<const std::string>(
      to_json(Dict{{"channel", channel}, {"sequence", sequence}, {"kind", kind}, {"data", data}}));
}

void Hub::send(Listener& listener, const std::string& channel, Text text, bool sampled) {
  listener.outbox().push(channel, std::move(text), sampled);
  listener.wake();
}

Hub::Channel* Hub::find(const std::string& name) {
  if (const auto known = channels_.find(name); known != channels_.end()) return &known->second;
  auto source = find_(name);
  if (!source) return nullptr;
  Channel& channel = channels_[name];
  channel.source = std::move(*source);
  channel.sequence = first_;
  return &channel;
}

// A snapshot has the number of the last delta that it contains. A channel that nobody has asked for yet keeps nothing.
void Hub::publish_snapshot(std::string name, Value data) {
  strand_.post([this, name = std::move(name), data = std::move(data)] {
    const auto known = channels_.find(name);
    if (known == channels_.end()) return;
    Channel& channel = known->second;
    channel.snapshot = Message{channel.sequence, serialise(name, channel.sequence, "snapshot", data)};
    for (const auto& listener : channel.waiting) {
      send(*listener, name, channel.snapshot->text, channel.source.sampled);
      channel.listeners.insert(listener);
    }
    channel.waiting.clear();
  });
}

void Hub::publish_delta(std::string name, Value data) {
  strand_.post([this, name = std::move(name), data = std::move(data)] {
    const auto known = channels_.find(name);
    if (known == channels_.end()) return;
    Channel& channel = known->second;
    const Message message{++channel.sequence, serialise(name, channel.sequence, "delta", data)};
    for (const auto& listener : channel.listeners) send(*listener, name, message.text, channel.source.sampled);
    channel.bytes += message.text->size();
    channel.deltas.push_back(message);
    while (channel.deltas.size() > (channel.source.sampled ? 1 : kKept) || channel.bytes > kKeptBytes) {
      channel.bytes -= channel.deltas.front().text->size();
      channel.deltas.pop_front();
    }
    if (!channel.source.sampled || channel.waiting.empty()) return;
    // Every message of a sampled channel is the whole.
    channel.snapshot = Message{channel.sequence, serialise(name, channel.sequence, "snapshot", data)};
    for (const auto& listener : channel.waiting) {
      send(*listener, name, channel.snapshot->text, true);
      channel.listeners.insert(listener);
    }
    channel.waiting.clear();
  });
}

void Hub::subscribe(std::shared_ptr<Listener> listener, std::string name, std::optional<std::int64_t> since) {
  strand_.post([this, listener = std::move(listener), name = std::move(name), since] {
    if (!released_) join(listener, name, since);
  });
}

void Hub::repay(std::shared_ptr<Listener> listener, std::string name) {
  strand_.post([this, listener = std::move(listener), name = std::move(name)] {
    if (name == kRefusals) return listener->outbox().drop(name);  // those that were dropped are not repeated
    const auto known = channels_.find(name);
    if (known != channels_.end() && known->second.listeners.contains(listener)) join(listener, name, std::nullopt);
  });
}

void Hub::join(const std::shared_ptr<Listener>& listener, const std::string& name, std::optional<std::int64_t> since) {
  listener->outbox().drop(name);
  Channel* channel = find(name);
  if (!channel) {
    const Value data = errors_json({{ErrorCode::not_found, "there is no channel of this name", name}});
    return send(*listener, kRefusals, serialise(name, first_, "error", data), false);
  }
  const bool first = channel->listeners.empty() && channel->waiting.empty();
  channel->listeners.erase(listener);
  if (since && catch_up(name, *channel, *listener, *since)) {
    channel->listeners.insert(listener);
  } else if (channel->snapshot && !channel->source.sampled && channel->snapshot->sequence == channel->sequence) {
    send(*listener, name, channel->snapshot->text, false);
    channel->listeners.insert(listener);
  } else {
    channel->waiting.insert(listener);
  }
  if (first && channel->source.watched) channel->source.watched(true);
  if (channel->waiting.contains(listener) && channel->source.refresh) channel->source.refresh();
}

// What a listener that has everything up to `since` lacks; false if that is not kept any more. One that starts from the
// snapshot gets it first.
bool Hub::catch_up(const std::string& name, Channel& channel, Listener& listener, std::int64_t since) {
  if (since < first_ || since > channel.sequence) return false;
  const std::int64_t oldest = channel.deltas.empty() ? channel.sequence + 1 : channel.deltas.front().sequence;
  if (since + 1 < oldest) return false;
  if (channel.snapshot && channel.snapshot->sequence == since)
    send(listener, name, channel.snapshot->text, channel.source.sampled);
  for (const Message& message : channel.deltas)
    if (message.sequence > since) send(listener, name, message.text, channel.source.sampled);
  return true;
}

void Hub::forget(Channel& channel, const std::shared_ptr<Listener>& listener) {
  const std::size_t removed = channel.listeners.erase(listener) + channel.waiting.erase(listener);
  const bool last = channel.listeners.empty() && channel.waiting.empty();
  if (removed == 0 || !last || !channel.source.watched) return;
  channel.source.watched(false);
  // What is published only while somebody listens has a gap from here on.
  channel.snapshot.reset();
  channel.deltas.clear();
  channel.bytes = 0;
}

void Hub::unsubscribe(std::shared_ptr<Listener> listener, std::string name) {
  strand_.post([this, listener = std::move(listener), name = std::move(name)] {
    const auto known = channels_.find(name);
    if (known != channels_.end()) forget(known->second, listener);
    listener->outbox().drop(name);
  });
}

void Hub::leave(std::shared_ptr<Listener> listener) {
  strand_.post([this, listener = std::move(listener)] {
    for (auto& [name, channel] : channels_) forget(channel, listener);
  });
}

void Hub::release() {
  strand_.ask([this] {
    released_ = true;
    for (auto& [name, channel] : channels_) {
      channel.listeners.clear();
      channel.waiting.clear();
    }
    return true;
  });
}

void Hub::close(std::string name) {
  strand_.post([this, name = std::move(name)] {
    const auto known = channels_.find(name);
    if (known == channels_.end()) return;
    const Value data = errors_json({{ErrorCode::not_found, "the channel has ended", name}});
    const Text text = serialise(name, known->second.sequence + 1, "error", data);
    for (const Listeners* all : {&known->second.listeners, &known->second.waiting})
      for (const auto& listener : *all) send(*listener, kRefusals, text, false);
    channels_.erase(known);
  });
}

void Hub::refuse(std::shared_ptr<Listener> listener, std::string name, std::vector<Error> errors) {
  strand_.post([this, listener = std::move(listener), name = std::move(name), errors = std::move(errors)] {
    send(*listener, kRefusals, serialise(name, first_, "error", errors_json(errors)), false);
  });
}

}  // namespace race::server
