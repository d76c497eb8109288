#include "server/stream/hub.h"

#include <algorithm>
#include <utility>

#include "core/value/json.h"
#include "server/wire/errors.h"

namespace race::server {

Hub::Hub(Pool& pool, std::int64_t first, std::function<std::optional<Source>(const std::string&)> find)
    : strand_(pool),
      publications_(strand_, [this](const auto& name, const auto& what) { overflow(name, what); }),
      first_(first),
      next_first_(first),
      find_(std::move(find)) {}

Text Hub::serialise(const std::string& channel, std::int64_t sequence, const char* kind, const Value& data) {
  return messages_.make(
      {sequence, kind, to_json(Dict{{"channel", channel}, {"sequence", sequence}, {"kind", kind}, {"data", data}})});
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

void Hub::send(std::weak_ptr<Subscriber> client, std::string name, const char* kind, Value data, To to) {
  strand_.post([this, client = std::move(client), name = std::move(name), kind, data = std::move(data), to] {
    const auto subscriber = shut_down_ ? nullptr : client.lock();
    if (!subscriber) return;
    const auto channel = channels_.find(name);
    const bool hears = channel != channels_.end() && channel->second.subscribers.contains(subscriber);
    if (to == To::those_not_subscribed && hears) return;
    send_alone(subscriber, name, kind, data);
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
    if (known == channels_.end()) return;
    const Channel& channel = known->second;
    if (channel.subscribers.contains(subscriber) || channel.waiting.contains(subscriber))
      join(subscriber, name, std::nullopt);
  });
}

void Hub::join(const std::shared_ptr<Subscriber>& subscriber, const std::string& name,
               std::optional<std::int64_t> since) {
  subscriber->outbox().drop(name);
  Channel* channel = find(name);
  const auto refused = [&](ErrorCode code, const std::string& why) {
    send_alone(subscriber, name, "error", errors_json({{code, why, name}}));
  };
  if (!channel) return refused(ErrorCode::not_found, "there is no channel of this name");
  std::set<std::string>& joined = joined_[subscriber];
  if (!joined.contains(name) && joined.size() == kMaxSubscriptions) {
    if (channel->is_idle()) put_idle(name);
    return refused(ErrorCode::too_large,
                   "a client has at most " + std::to_string(kMaxSubscriptions) + " channels at once");
  }
  joined.insert(name);
  const bool first = channel->is_idle();
  channel->subscribers.erase(subscriber);
  if (since && catch_up(name, *channel, *subscriber, *since)) {
    channel->subscribers.insert(subscriber);
  } else if (channel->snapshot && !channel->source.sampled && channel->snapshot->sequence == channel->sequence) {
    send(*subscriber, name, channel->snapshot, false);
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
  const std::int64_t oldest = channel.deltas.empty() ? channel.sequence + 1 : channel.deltas.front()->sequence;
  if (since + 1 < oldest) return false;
  if (channel.snapshot && channel.snapshot->sequence == since)
    send(subscriber, name, channel.snapshot, channel.source.sampled);
  for (const Text& message : channel.deltas)
    if (message->sequence > since) send(subscriber, name, message, channel.source.sampled);
  return true;
}

void Hub::send_alone(const std::shared_ptr<Subscriber>& subscriber, const std::string& name, const char* kind,
                     const Value& data) {
  send(*subscriber, Outbox::kPrivateQueue, serialise(name, first_, kind, data), false);
  limit_memory(subscriber);
}

void Hub::detach(const std::string& name, const std::shared_ptr<Subscriber>& subscriber) {
  const auto known = channels_.find(name);
  if (known == channels_.end()) return;
  Channel& channel = known->second;
  const std::size_t removed = channel.subscribers.erase(subscriber) + channel.waiting.erase(subscriber);
  if (removed == 0 || !channel.is_idle()) return;
  if (channel.source.watched) {
    channel.source.watched(false);
    channel.drop_kept();  // a source that publishes only while it is watched leaves a gap from here on
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
  shut_down_ = true;
  strand_.ask([this] {
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
    publications_.forget(name);
    const auto known = channels_.find(name);
    if (known == channels_.end()) return;
    const Text text = serialise(name, known->second.sequence + 1, "error", errors_json(errors));
    for (const Subscribers* all : {&known->second.subscribers, &known->second.waiting})
      for (const auto& subscriber : *all) send(*subscriber, Outbox::kPrivateQueue, text, false);
    for (auto& [subscriber, names] : joined_) names.erase(name);
    remove_channel(known);
  });
}

void Hub::refuse(std::shared_ptr<Subscriber> subscriber, std::string name, std::vector<Error> errors) {
  strand_.post([this, subscriber = std::move(subscriber), name = std::move(name), errors = std::move(errors)] {
    send_alone(subscriber, name, "error", errors_json(errors));
  });
}

}  // namespace race::server
