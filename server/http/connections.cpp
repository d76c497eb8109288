#include "server/http/connections.h"

#include <algorithm>
#include <map>
#include <utility>

namespace race::server {

std::unique_ptr<Connections::Place> Connections::admit(std::string address, End end) {
  const bool regular = make_room(address);
  if (!regular && !make_reserved_room()) return nullptr;
  entries_.push_back({std::move(address), std::move(end), !regular, Phase::idle, ++phases_});
  return std::unique_ptr<Place>(new Place(*this, std::prev(entries_.end())));
}

bool Connections::make_room(const std::string& address) {
  const auto is_regular = [](const Entry& entry) { return !entry.reserved && !entry.ended; };
  const auto is_of_address = [&](const Entry& entry) { return is_regular(entry) && entry.address == address; };
  if (count(is_of_address) >= limits_.of_address) return end(find_idle(&address));
  return count(is_regular) < limits_.all || end(find_idle(nullptr));
}

bool Connections::make_reserved_room() {
  const auto is_reserved = [](const Entry& entry) { return entry.reserved && !entry.ended; };
  if (count(is_reserved) < limits_.reserved) return true;
  Entry* oldest = nullptr;
  for (Entry& entry : entries_)
    if (is_reserved(entry) && entry.phase != Phase::answering && (!oldest || entry.since < oldest->since))
      oldest = &entry;
  return end(oldest);
}

// The connection that has been idle for longest: of the address, or of the address that has most connections.
Connections::Entry* Connections::find_idle(const std::string* address) {
  std::map<std::string, std::size_t> of_addresses;
  for (const Entry& entry : entries_) of_addresses[entry.address] += entry.ended ? 0 : 1;
  Entry* found = nullptr;
  for (Entry& entry : entries_) {
    if (entry.reserved || entry.ended || entry.phase != Phase::idle) continue;
    if (address && entry.address != *address) continue;
    const auto most = found ? of_addresses[found->address] : 0, of_this = of_addresses[entry.address];
    if (of_this > most || (of_this == most && entry.since < found->since)) found = &entry;
  }
  return found;
}

std::size_t Connections::count(const std::function<bool(const Entry&)>& which) const {
  return static_cast<std::size_t>(std::ranges::count_if(entries_, which));
}

bool Connections::end(Entry* entry) {
  if (!entry) return false;
  entry->ended = true;
  entry->end();
  return true;
}

void Connections::end_all() {
  for (Entry& entry : entries_)
    if (entry.phase != Phase::answering && !entry.ended) end(&entry);
}

void Connections::Place::begin(Phase phase) {
  entry_->phase = phase;
  entry_->since = ++all_.phases_;
}

bool Connections::Place::begin_websocket() {
  const auto is_websocket = [](const Entry& entry) { return entry.phase == Phase::websocket; };
  if (entry_->reserved || all_.count(is_websocket) >= all_.limits_.websockets) return false;
  begin(Phase::websocket);
  return true;
}

}  // namespace race::server
