#include "server/stream/publications.h"

#include <utility>

#include "core/value/json.h"

namespace race::server {

Publication Publication::of(Value data) {
  if (data.size_units() < kLargeUnits) return {std::move(data), nullptr};
  return {Value(), std::make_shared<const std::string>(to_json(data))};
}

bool Publications::has_room(const std::string& channel, Kind kind) const {
  const services::MutexLock lock(mutex_);
  const auto known = channels_.find(channel);
  return takes(known == channels_.end() ? Waiting() : known->second, kind);
}

// Posted under the lock: in the order of what is decided here.
void Publications::post(const std::string& channel, Kind kind, Publication what, std::size_t units, Work work) {
  const services::MutexLock lock(mutex_);
  Waiting& waiting = channels_[channel];
  if (work && takes(waiting, kind)) {
    const bool fitted = fits(waiting);
    strand_.post([this, channel, kind, units, fitted, what = std::move(what), work = std::move(work)] {
      begin(channel, units, fitted);
      try {
        work();
      } catch (...) {
        if (kind != Kind::snapshot) begin_anew_(channel, {what, true});
        throw;
      }
    });
    ++waiting.count;
    waiting.units += units;
    units_ += units;
    if (!fitted) waiting.has_snapshot = true;
    waiting.ends_anew = false;
    return;
  }
  if (kind == Kind::snapshot) return;  // what waits leads to the same state
  if (!waiting.ends_anew) {
    strand_.post([this, channel] { overflow(channel); });
    ++waiting.overflows;
    waiting.ends_anew = true;
  }
  waiting.newest = std::move(what);
}

bool Publications::takes(const Waiting& waiting, Kind kind) const {
  return fits(waiting) || (kind != Kind::delta && !waiting.has_snapshot);
}

bool Publications::fits(const Waiting& waiting) const {
  return waiting.overflows == 0 && waiting.count < kMost && waiting.units < kMostUnits && units_ < kAllUnits;
}

void Publications::begin(const std::string& channel, std::size_t units, bool fitted) {
  const services::MutexLock lock(mutex_);
  const auto known = channels_.find(channel);
  Waiting& waiting = known->second;
  --waiting.count;
  waiting.units -= units;
  units_ -= units;
  if (!fitted) waiting.has_snapshot = false;
  forget_empty(known);
}

void Publications::overflow(const std::string& channel) {
  Overflow overflow;
  {
    const services::MutexLock lock(mutex_);
    const auto known = channels_.find(channel);
    Waiting& waiting = known->second;
    const bool all = --waiting.overflows == 0;
    overflow = {waiting.newest, all && !waiting.has_snapshot};
    if (all) {
      waiting.ends_anew = false;
      waiting.newest = {};
    }
    forget_empty(known);
  }
  begin_anew_(channel, overflow);
}

void Publications::forget_empty(Channels::iterator channel) {
  if (channel->second.count == 0 && channel->second.overflows == 0) channels_.erase(channel);
}

std::size_t Publications::units() const {
  const services::MutexLock lock(mutex_);
  return units_;
}

}  // namespace race::server
