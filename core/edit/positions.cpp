#include "core/edit/positions.h"

#include <algorithm>

namespace race::edit {

void Positions::rollback() {
  for (auto& [key, slots] : saved_) {
    if (slots) {
      lists_[key] = std::move(*slots);
    } else {
      lists_.erase(key);
    }
  }
  saved_.clear();
}

void Positions::sync(const Tree& tree, const std::string& parent, ListName list) {
  const Key key{parent, list};
  const auto found = lists_.find(key);
  if (!saved_.contains(key)) saved_.emplace(key, found == lists_.end() ? std::nullopt : std::optional(found->second));
  const Ids& present = tree.list(parent, list);
  if (found != lists_.end()) {
    auto expected = present.begin();
    bool same = true;
    for (const Slot& slot : found->second) {
      if (slot.left == 0) same = same && expected != present.end() && *expected++ == slot.id;
    }
    if (same && expected == present.end()) return;
  }
  // A list that nobody has touched, or that of an element which was inserted anew under the id of another one.
  Slots slots;
  for (const std::string& id : present) slots.push_back({id, 0});
  lists_[key] = std::move(slots);
}

Departure Positions::leave(const std::string& parent, ListName list, std::string_view id) {
  Slots& slots = lists_.at({parent, list});
  const auto slot = std::ranges::find_if(slots, [&](const Slot& s) { return s.left == 0 && s.id == id; });
  return slot->left = ++last_;
}

Positions::Spot Positions::spot_at(const Key& key, const Slots& slots, std::size_t slot, bool is_return) {
  Spot out{{key.first, key.second, std::nullopt}, slot, is_return};
  for (std::size_t i = slot; i > 0 && !out.place.after; --i) {
    if (slots[i - 1].left == 0) out.place.after = slots[i - 1].id;
  }
  return out;
}

std::optional<Positions::Spot> Positions::spot(const Place& place, Departure since, Departure until) const {
  const Key key{place.parent, place.list};
  const Slots& slots = lists_.at(key);
  if (!place.after) return Spot{place, 0, false};
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].id != *place.after) continue;
    if (slots[i].left == 0) return Spot{place, i + 1, false};
    const bool counts = slots[i].left > since && slots[i].left <= until;
    if (counts && (!best || slots[i].left > slots[*best].left)) best = i;
  }
  if (!best) return std::nullopt;
  return spot_at(key, slots, *best + 1, false);
}

std::optional<Positions::Spot> Positions::spot(const std::string& parent, ListName list, Departure departure) const {
  const Key key{parent, list};
  const Slots& slots = lists_.at(key);
  const auto slot = std::ranges::find(slots, departure, &Slot::left);
  if (departure == 0 || slot == slots.end()) return std::nullopt;
  return spot_at(key, slots, static_cast<std::size_t>(slot - slots.begin()), true);
}

void Positions::enter(const Spot& spot, std::string_view id) {
  Slots& slots = lists_.at({spot.place.parent, spot.place.list});
  if (spot.is_return) {
    slots[spot.slot] = {std::string(id), 0};
  } else {
    slots.insert(slots.begin() + static_cast<std::ptrdiff_t>(spot.slot), {std::string(id), 0});
  }
}

void Positions::prune(Departure departure) {
  for (auto list = lists_.begin(); list != lists_.end();) {
    Slots& slots = list->second;
    std::erase_if(slots, [&](const Slot& slot) { return slot.left > 0 && slot.left <= departure; });
    const bool is_plain = std::ranges::all_of(slots, [](const Slot& slot) { return slot.left == 0; });
    list = is_plain ? lists_.erase(list) : std::next(list);
  }
}

}  // namespace race::edit
