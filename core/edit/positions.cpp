#include "core/edit/positions.h"

#include <algorithm>
#include <cassert>

namespace race::edit {

void Positions::rollback() {
  for (auto& [key, entries] : saved_) {
    if (entries) {
      lists_[key] = std::move(*entries);
    } else {
      lists_.erase(key);
    }
  }
  saved_.clear();
}

void Positions::save(const Key& key) {
  if (saved_.contains(key)) return;
  const auto found = lists_.find(key);
  saved_.emplace(key, found == lists_.end() ? std::nullopt : std::optional(found->second));
}

void Positions::sync(const Tree& tree, const std::string& parent, ListName list) {
  const Key key{0, parent, list};
  const auto found = lists_.find(key);
  save(key);
  const Ids& present = tree.list(parent, list);
  if (found != lists_.end()) {
    auto expected = present.begin();
    bool same = true;
    for (const Entry& entry : found->second) {
      if (entry.left == 0) same = same && expected != present.end() && *expected++ == entry.id;
    }
    if (same && expected == present.end()) return;
  }
  assert(found == lists_.end());  // a list that nobody has touched
  Entries entries;
  for (const std::string& id : present) entries.push_back({id, 0});
  lists_[key] = std::move(entries);
}

Departure Positions::leave(const std::string& parent, ListName list, std::string_view id) {
  Entries& entries = lists_.at({0, parent, list});
  const auto entry = std::ranges::find_if(entries, [&](const Entry& s) { return s.left == 0 && s.id == id; });
  return entry->left = ++last_;
}

Positions::Spot Positions::spot_at(const Key& key, const Entries& entries, std::size_t entry, bool is_return) {
  Spot out{{key.parent, key.list, std::nullopt}, entry, is_return};
  for (std::size_t i = entry; i > 0 && !out.place.after; --i) {
    if (entries[i - 1].left == 0) out.place.after = entries[i - 1].id;
  }
  return out;
}

std::optional<Positions::Spot> Positions::spot(const Place& place, Departure since, Departure until) const {
  const Key key{0, place.parent, place.list};
  const Entries& entries = lists_.at(key);
  if (!place.after) return Spot{place, 0, false};
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].id != *place.after) continue;
    if (entries[i].left == 0) return Spot{place, i + 1, false};
    const bool counts = entries[i].left > since && entries[i].left <= until;
    if (counts && (!best || entries[i].left > entries[*best].left)) best = i;
  }
  if (!best) return std::nullopt;
  return spot_at(key, entries, *best + 1, false);
}

std::optional<Positions::Spot> Positions::spot(const std::string& parent, ListName list, Departure departure) const {
  const Key key{0, parent, list};
  const Entries& entries = lists_.at(key);
  const auto entry = std::ranges::find(entries, departure, &Entry::left);
  if (departure == 0 || entry == entries.end()) return std::nullopt;
  return spot_at(key, entries, static_cast<std::size_t>(entry - entries.begin()), true);
}

void Positions::enter(const Spot& spot, std::string_view id) {
  Entries& entries = lists_.at({0, spot.place.parent, spot.place.list});
  if (spot.is_return) {
    entries[spot.entry] = {std::string(id), 0};
  } else {
    entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(spot.entry), {std::string(id), 0});
  }
}

Positions::Lists::iterator Positions::rename(Lists::iterator list, Departure removed) {
  Key key{removed, list->first.parent, list->first.list};
  save(list->first);
  save(key);
  const auto next = std::next(list);
  auto node = lists_.extract(list);
  node.key() = std::move(key);
  [[maybe_unused]] const bool is_free = lists_.insert(std::move(node)).inserted;
  assert(is_free);
  return next;
}

void Positions::store(const Ids& elements, Departure departure) {
  for (const std::string& id : elements) {
    for (auto list = lists_.lower_bound({0, id, {}});
         list != lists_.end() && list->first.removed == 0 && list->first.parent == id;)
      list = rename(list, departure);
  }
}

void Positions::restore(Departure departure) {
  for (auto list = lists_.lower_bound({departure, {}, {}}); list != lists_.end() && list->first.removed == departure;)
    list = rename(list, 0);
}

void Positions::prune(Departure departure) {
  for (auto list = lists_.begin(); list != lists_.end();) {
    Entries& entries = list->second;
    std::erase_if(entries, [&](const Entry& entry) { return entry.left > 0 && entry.left <= departure; });
    const bool is_plain = std::ranges::all_of(entries, [](const Entry& entry) { return entry.left == 0; });
    list = is_plain ? lists_.erase(list) : std::next(list);
  }
}

}  // namespace race::edit
