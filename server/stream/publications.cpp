#include "server/stream/publications.h"

#include <utility>

namespace race::server {

// Posted under the lock: in the order of what is decided here.
void Publications::post(const std::string& channel, Kind kind, Value data, Work work) {
  const services::MutexLock lock(mutex_);
  Waiting& waiting = channels_[channel];
  const bool fitted = fits(waiting);
  if (fitted || (kind != Kind::delta && !waiting.has_snapshot)) {
    const std::size_t units = data.size_units();
    strand_.post([this, channel, kind, units, fitted, data = std::move(data), work = std::move(work)] {
      begin(channel, units, fitted);
      try {
        work();
      } catch (...) {
        if (kind != Kind::snapshot) begin_anew_(channel, {data, true});
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
  waiting.newest = std::move(data);
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
      waiting.newest = Value();
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
