// Of the hub: what is published, and how much memory its messages take.
#include <algorithm>
#include <utility>

#include "core/value/json.h"
#include "server/stream/hub.h"

namespace race::server {

// A channel that nobody has asked for yet keeps nothing.
void Hub::publish(Publish publish, Publications::Kind kind, const std::string& name, Value data) {
  if (!publications_.has_room(name, kind)) return publications_.post(name, kind, {std::move(data), nullptr}, 0, {});
  const std::size_t units = data.size_units();
  const Publication what = Publication::of(std::move(data));
  publications_.post(name, kind, what, units, [this, publish, name, what] {
    const auto known = channels_.find(name);
    if (known == channels_.end() || shut_down_) return;
    (this->*publish)(name, known->second, what);
    limit_memory(nullptr);
  });
}

Text Hub::serialise(const std::string& channel, std::int64_t sequence, const char* kind, const Publication& what) {
  if (!what.json) return serialise(channel, sequence, kind, what.data);
  std::string text = to_json(Dict{{"channel", channel}, {"sequence", sequence}, {"kind", kind}});
  text.pop_back();  // the brace
  text.reserve(text.size() + what.json->size() + 16);
  text.append(",\"data\":").append(*what.json).append("}");
  return messages_.make({sequence, kind, std::move(text)});
}

void Hub::publish_snapshot(const std::string& name, Value data) {
  publish(&Hub::add_snapshot, Publications::Kind::snapshot, name, std::move(data));
}

void Hub::publish_delta(const std::string& name, Value data) {
  publish(&Hub::add_delta, Publications::Kind::delta, name, std::move(data));
}

void Hub::publish_replacement(const std::string& name, Value data) {
  publish(&Hub::replace, Publications::Kind::replacement, name, std::move(data));
}

// A snapshot has the number of the last delta that it contains.
void Hub::add_snapshot(const std::string& name, Channel& channel, const Publication& what) {
  if (channel.is_idle()) return;
  Text snapshot = serialise(name, channel.sequence, "snapshot", what);
  for (const auto& subscriber : channel.waiting) {
    send(*subscriber, name, snapshot, channel.source.sampled);
    channel.subscribers.insert(subscriber);
  }
  channel.waiting.clear();
  channel.snapshot = std::move(snapshot);
}

void Hub::add_delta(const std::string& name, Channel& channel, const Publication& what) {
  ++channel.sequence;
  const Text message = serialise(name, channel.sequence, "delta", what);
  for (const auto& subscriber : channel.subscribers) send(*subscriber, name, message, channel.source.sampled);
  channel.bytes += message->json.size();
  channel.deltas.push_back(message);
  const std::size_t most = channel.source.sampled ? 1 : kMaxDeltas;
  const std::size_t most_bytes = channel.is_idle() ? kMaxIdleDeltaBytes : kMaxDeltaBytes;
  while (channel.deltas.size() > most || channel.bytes > most_bytes) {
    channel.bytes -= channel.deltas.front()->json.size();
    channel.deltas.pop_front();
  }
  // Every message of a sampled channel is the whole.
  if (channel.source.sampled && !channel.waiting.empty()) add_snapshot(name, channel, what);
}

void Hub::replace(const std::string& name, Channel& channel, const Publication& what) {
  begin_anew(channel);
  channel.waiting.merge(channel.subscribers);
  add_snapshot(name, channel, what);
}

// Its subscribers lack something: they wait for the snapshot that contains it.
void Hub::overflow(const std::string& name, const Publications::Overflow& overflow) {
  const auto known = channels_.find(name);
  if (known == channels_.end()) return;
  if (!known->second.source.sampled) return restart(known->second, overflow.asks);
  if (!overflow.newest.empty()) add_delta(name, known->second, overflow.newest);
}

void Hub::restart(std::string prefix) {
  strand_.post([this, prefix = std::move(prefix)] {
    for (auto& [name, channel] : channels_)
      if (name.starts_with(prefix)) {
        publications_.forget(name);
        restart(channel, true);
      }
  });
}

// `ask`: the source is asked for the snapshot.
void Hub::restart(Channel& channel, bool ask) {
  begin_anew(channel);
  channel.waiting.merge(channel.subscribers);
  if (ask && !channel.waiting.empty() && channel.source.refresh) channel.source.refresh();
}

// A client that has everything up to here lacks something all the same.
void Hub::begin_anew(Channel& channel) {
  ++channel.sequence;
  channel.drop_kept();
}

// `told`: a client that may have no channel.
void Hub::limit_memory(const std::shared_ptr<Subscriber>& told) {
  if (messages_.held() > kMaxBytes) drop_kept();
  while (messages_.held() > kMaxBytes) {
    Subscriber* most = told && !told->outbox().is_cut() ? told.get() : nullptr;
    std::size_t leaving = 0;  // is held by those that were cut
    for (const auto& [subscriber, names] : joined_) {
      const std::size_t bytes = subscriber->outbox().bytes();
      if (subscriber->outbox().is_cut())
        leaving += bytes;
      else if (!most || bytes > most->outbox().bytes())
        most = subscriber.get();
    }
    if (!most || most->outbox().bytes() == 0 || messages_.held() <= kMaxBytes + leaving) return;
    most->outbox().cut();
    most->wake();
  }
}

void Hub::drop_kept() {
  while (messages_.held() > kMaxBytes) {
    const auto most =
        std::ranges::max_element(channels_, {}, [](const auto& channel) { return channel.second.kept_bytes(); });
    if (most == channels_.end() || most->second.kept_bytes() == 0) return;
    most->second.drop_kept();
  }
}

}  // namespace race::server
