#include "server/stream/hub.h"

#include <algorithm>
#include <utility>

#include "core/value/json.h"
#include "server/wire/errors.h"

namespace race::server {

Hub::Hub(Pool& pool, std::int64_t first, std::function<std::optional<Source>(const std::string&)> find)
    : strand_(pool), first_(first), next_first_(first), find_(std::move(find)) {}

Text Hub::serialise(const std::string& channel, std::int64_t sequence, const char* kind, const Value& data) {
  return std::make_shared<const std::string>(
      to_json(Dict{{"channel", channel}, {"sequence", sequence}, {"kind", kind}, {"data", data}}));
}

void Hub::send(Subscriber& subscriber, const std::string& channel, Text text, bool sampled) {
  subscriber.outbox().push(channel, std::move(text), sampled);
  subscriber.wake();
}

Hub::Channel* Hub::find(const std::string& name) {
  if (const auto known = channels_.find(name); known != channels_.end()) return &known->second;
  auto source = find_(name);
  if (!source) return nullptr;
  Channel& channel = channels_[name];
  channel.source = std::move(*source);
  channel.first = channel.sequence = next_first_;
  return &channel;
}

// A snapshot has the number of the last delta that it contains. A channel that nobody has asked for yet keeps nothing.
void Hub::publish_snapshot(std::string name, Value data) {
  strand_.post([this, name = std::move(name), data = std::move(data)] {
    const auto known = channels_.find(name);
    if (known == channels_.end()) return;
    Channel& channel = known->second;
    if (channel.is_idle()) return;
    channel.snapshot = Message{channel.sequence, serialise(name, channel.sequence, "snapshot", data)};
    for (const auto& subscriber : channel.waiting) {
      send(*subscriber, name, channel.snapshot->text, channel.source.sampled);
      channel.subscribers.insert(subscriber);
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
    for (const auto& subscriber : channel.subscribers) send(*subscriber, name, message.text, channel.source.sampled);
    channel.bytes += message.text->size();
    channel.deltas.push_back(message);
    const std::size_t most = channel.source.sampled ? 1 : kMaxDeltas;
    const std::size_t most_bytes = channel.is_idle() ? kMaxIdleDeltaBytes : kMaxDeltaBytes;
    while (channel.deltas.size() > most || channel.bytes > most_bytes) {
      channel.bytes -= channel.deltas.front().text->size();
      channel.deltas.pop_front();
    }
    if (!channel.source.sampled || channel.waiting.empty()) return;
    // Every message of a sampled channel is the whole.
    channel.snapshot = Message{channel.sequence, serialise(name, channel.sequence, "snapshot", data)};
    for (const auto& subscriber : channel.waiting) {
      send(*subscriber, name, channel.snapshot->text, true);
      channel.subscribers.insert(subscriber);
    }
    channel.waiting.clear();
  });
}

void Hub::publish_replacement(std::string name, Value data) {
  strand_.post([this, name = std::move(name), data = std::move(data)] {
    const auto known = channels_.find(name);
    if (known == channels_.end()) return;
    Channel& channel = known->second;
    begin_anew(channel);
    channel.snapshot = Message{channel.sequence, serialise(name, channel.sequence, "snapshot", data)};
    channel.subscribers.merge(channel.waiting);
    for (const auto& subscriber : channel.subscribers)
      send(*subscriber, name, channel.snapshot->text, channel.source.sampled);
  });
}

void Hub::restart(std::string prefix) {
  strand_.post([this, prefix = std::move(prefix)] {
    for (auto& [name, channel] : channels_) {
      if (!name.starts_with(prefix)) continue;
      begin_anew(channel);
      channel.waiting.merge(channel.subscribers);
      if (!channel.waiting.empty() && channel.source.refresh) channel.source.refresh();
    }
  });
}

// A client that has everything up to here lacks something all the same.
void Hub::begin_anew(Channel& channel) {
  ++channel.sequence;
  channel.deltas.clear();
  channel.bytes = 0;
  channel.snapshot.reset();
}

void Hub::send(std::weak_ptr<Subscriber> client, std::string name, const char* kind, Value data, To to) {
  strand_.post([this, client = std::move(client), name = std::move(name), kind, data = std::move(data), to] {
    const auto subscriber = shut_down_ ? nullptr : client.lock();
    if (!subscriber) return;
    const auto channel = channels_.find(name);
    const bool hears = channel != channels_.end() && channel->second.subscribers.contains(subscriber);
    if (to == To::those_not_subscribed && hears) return;
    send(*subscriber, kPrivateQueue, serialise(name, first_, kind, data), false);
  });
}

void Hub::subscribe(std::shared_ptr<Subscriber> subscriber, std::string name, std::optional<std::int64_t> since) {
  strand_.post([this, subscriber = std::move(subscriber), name = std::move(name), since] {
    if (!shut_down_) join(subscriber, name, since);
  });
}

void Hub::resend_snapshot(std::shared_ptr<Subscriber> subscriber, std::string name) {
  strand_.post([this, subscriber = std::move(subscriber), name = std::move(name)] {
    const auto known = channels_.find(name);
    if (known != channels_.end() && known->second.subscribers.contains(subscriber))
      join(subscriber, name, std::nullopt);
  });
}

void Hub::join(const std::shared_ptr<Subscriber>& subscriber, const std::string& name,
               std::optional<std::int64_t> since) {
  subscriber->outbox().drop(name);
  Channel* channel = find(name);
  if (!channel) return send_error(*subscriber, name, {ErrorCode::not_found, "there is no channel of this name", name});
  std::set<std::string>& joined = joined_[subscriber];
  if (!joined.contains(name) && joined.size() == kMaxSubscriptions) {
    if (channel->is_idle()) put_idle(name);
    return send_error(*subscriber, name,
                      {ErrorCode::too_large,
                       "a client has at most " + std::to_string(kMaxSubscriptions) + " channels at once", name});
  }
  joined.insert(name);
  const bool first = channel->is_idle();
  channel->subscribers.erase(subscriber);
  if (since && catch_up(name, *channel, *subscriber, *since)) {
    channel->subscribers.insert(subscriber);
  } else if (channel->snapshot && !channel->source.sampled && channel->snapshot->sequence == channel->sequence) {
    send(*subscriber, name, channel->snapshot->text, false);
    channel->subscribers.insert(subscriber);
  } else {
    channel->waiting.insert(subscriber);
  }
  if (first && channel->source.watched) channel->source.watched(true);
  if (channel->waiting.contains(subscriber) && channel->source.refresh) channel->source.refresh();
}

// What a subscriber that has everything up to `since` lacks; false if that is not kept any more. One that starts from
// the snapshot gets it first.
bool Hub::catch_up(const std::string& name, Channel& channel, Subscriber& subscriber, std::int64_t since) {
  if (since < channel.first || since > channel.sequence) return false;
  const std::int64_t oldest = channel.deltas.empty() ? channel.sequence + 1 : channel.deltas.front().sequence;
  if (since + 1 < oldest) return false;
  if (channel.snapshot && channel.snapshot->sequence == since)
    send(subscriber, name, channel.snapshot->text, channel.source.sampled);
  for (const Message& message : channel.deltas)
    if (message.sequence > since) send(subscriber, name, message.text, channel.source.sampled);
  return true;
}

void Hub::send_error(Subscriber& subscriber, const std::string& name, const Error& error) {
  send(subscriber, kPrivateQueue, serialise(name, first_, "error", errors_json({error})), false);
}

void Hub::detach(const std::string& name, const std::shared_ptr<Subscriber>& subscriber) {
  const auto known = channels_.find(name);
  if (known == channels_.end()) return;
  Channel& channel = known->second;
  const std::size_t removed = channel.subscribers.erase(subscriber) + channel.waiting.erase(subscriber);
  if (removed == 0 || !channel.is_idle()) return;
  if (channel.source.watched) {
    channel.source.watched(false);
    // A source that publishes only while it is watched leaves a gap from here on.
    channel.snapshot.reset();
    channel.deltas.clear();
    channel.bytes = 0;
  }
  put_idle(name);
}

// The channel has no subscriber any more. Beyond the bounds, those that were left first are forgotten.
void Hub::put_idle(const std::string& name) {
  std::erase(idle_, name);
  idle_.push_back(name);
  std::size_t bytes = 0;
  std::erase_if(idle_, [&](const std::string& each) {
    const auto channel = channels_.find(each);
    if (channel == channels_.end() || !channel->second.is_idle()) return true;
    bytes += channel->second.kept_bytes();
    return false;
  });
  while (idle_.size() > kMaxIdle || bytes > kMaxIdleBytes) {
    const auto oldest = channels_.find(idle_.front());
    bytes -= oldest->second.kept_bytes();
    remove_channel(oldest);
    idle_.pop_front();
  }
}

void Hub::remove_channel(std::map<std::string, Channel>::iterator channel) {
  next_first_ = std::max(next_first_, channel->second.sequence + 2);
  channels_.erase(channel);
}

void Hub::unsubscribe(std::shared_ptr<Subscriber> subscriber, std::string name) {
  strand_.post([this, subscriber = std::move(subscriber), name = std::move(name)] {
    if (const auto of = joined_.find(subscriber); of != joined_.end()) of->second.erase(name);
    detach(name, subscriber);
    subscriber->outbox().drop(name);
  });
}

void Hub::disconnect(std::shared_ptr<Subscriber> subscriber) {
  strand_.post([this, subscriber = std::move(subscriber)] {
    const auto of = joined_.extract(subscriber);
    if (of.empty()) return;
    for (const std::string& name : of.mapped()) detach(name, subscriber);
  });
}

void Hub::shut_down() {
  strand_.ask([this] {
    shut_down_ = true;
    for (auto& [name, channel] : channels_) {
      channel.subscribers.clear();
      channel.waiting.clear();
    }
    joined_.clear();
    return true;
  });
}

void Hub::close(std::string name, std::vector<Error> errors) {
  strand_.post([this, name = std::move(name), errors = std::move(errors)] {
    const auto known = channels_.find(name);
    if (known == channels_.end()) return;
    const Text text = serialise(name, known->second.sequence + 1, "error", errors_json(errors));
    for (const Subscribers* all : {&known->second.subscribers, &known->second.waiting})
      for (const auto& subscriber : *all) send(*subscriber, kPrivateQueue, text, false);
    for (auto& [subscriber, names] : joined_) names.erase(name);
    remove_channel(known);
  });
}

void Hub::refuse(std::shared_ptr<Subscriber> subscriber, std::string name, std::vector<Error> errors) {
  strand_.post([this, subscriber = std::move(subscriber), name = std::move(name), errors = std::move(errors)] {
    send(*subscriber, kPrivateQueue, serialise(name, first_, "error", errors_json(errors)), false);
  });
}

}  // namespace race::server
