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
  static const Waiting kNone;
  return takes(known == channels_.end() ? kNone : known->second, kind);
}

void Publications::post(const std::string& channel, Kind kind, Publication what, std::size_t units, Work work) {
  if (!add(channel, kind, std::move(what), units, std::move(work))) return;
  std::size_t turns = 1 + missing_turns_.exchange(0);
  try {
    for (; turns > 0; --turns) strand_.post([this] { do_next(); });
  } catch (...) {
    missing_turns_ += turns;
    throw;
  }
}

// Whether there is a piece more.
bool Publications::add(const std::string& channel, Kind kind, Publication what, std::size_t units, Work work) {
  const services::MutexLock lock(mutex_);
  const auto known = channels_.try_emplace(channel).first;
  Waiting& waiting = known->second;
  if (work && takes(waiting, kind)) {
    const bool fitted = fits(waiting);
    add(known, {std::move(work), kind, std::move(what), units, fitted});
    waiting.units += units;
    units_ += units;
    if (!fitted) waiting.has_snapshot = true;
    return true;
  }
  if (kind == Kind::snapshot) {  // what waits leads to the same state
    if (waiting.pieces.empty()) channels_.erase(known);
    return false;
  }
  std::swap(waiting.newest, what);
  if (waiting.ends_anew()) return false;
  add(known, {});
  ++waiting.overflows;
  return true;
}

void Publications::add(Channels::iterator channel, Piece piece) {
  std::deque<Piece>& pieces = channel->second.pieces;
  if (pieces.empty()) turns_.push_back(channel);
  try {
    pieces.push_back(std::move(piece));
  } catch (...) {
    if (pieces.empty()) turns_.pop_back();
    throw;
  }
}

bool Publications::takes(const Waiting& waiting, Kind kind) const {
  return fits(waiting) || (kind != Kind::delta && !waiting.has_snapshot);
}

bool Publications::fits(const Waiting& waiting) const {
  return waiting.overflows == 0 && waiting.pieces.size() < kMost && waiting.units < kMostUnits && units_ < kAllUnits;
}

void Publications::do_next() {
  std::string name;
  Piece piece;
  Overflow overflow;
  {
    const services::MutexLock lock(mutex_);
    if (turns_.empty()) return;
    const auto channel = turns_.front();
    name = channel->first;
    Waiting& waiting = channel->second;
    if (waiting.pieces.size() > 1) turns_.push_back(channel);
    turns_.pop_front();
    piece = std::move(waiting.pieces.front());
    waiting.pieces.pop_front();
    if (piece.work)
      begin(waiting, piece);
    else
      overflow = take_overflow(waiting);
    if (waiting.pieces.empty()) channels_.erase(channel);
  }
  if (!piece.work) return begin_anew_(name, overflow);
  try {
    piece.work();
  } catch (...) {
    if (piece.kind != Kind::snapshot) begin_anew_(name, {piece.what, true});
    throw;
  }
}

void Publications::begin(Waiting& waiting, const Piece& piece) {
  waiting.units -= piece.units;
  units_ -= piece.units;
  if (!piece.fitted) waiting.has_snapshot = false;
}

Publications::Overflow Publications::take_overflow(Waiting& waiting) {
  const bool all = --waiting.overflows == 0;
  Overflow overflow{waiting.newest, all && !waiting.has_snapshot};
  if (all) waiting.newest = {};
  return overflow;
}

// A turn that is left over is none.
void Publications::forget(const std::string& channel) {
  Waiting dropped;  // after the lock
  const services::MutexLock lock(mutex_);
  const auto known = channels_.find(channel);
  if (known == channels_.end()) return;
  std::erase(turns_, known);
  std::swap(dropped, known->second);
  units_ -= dropped.units;
  channels_.erase(known);
}

std::size_t Publications::units() const {
  const services::MutexLock lock(mutex_);
  return units_;
}

}  // namespace race::server
