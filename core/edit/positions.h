// Positions: the lists that edits have touched, with the places that elements have left. Whoever inserts behind an
// element that has gone meanwhile still finds where it stood, and an element that returns (undo) stands where it was,
// whatever happened around it: places are never reordered.
//
// The lists of an element that was removed go with it, and come back with it: what is inserted under its id meanwhile
// has lists of its own.
//
// A value. Each departure has a number, in order; departures that nobody needs any more are pruned.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/edit/operation.h"
#include "core/edit/tree.h"

namespace race::edit {

/// The number of a departure, from 1; 0: none.
using Departure = std::uint64_t;

class Positions {
 public:
  /// A place for an element to enter, in terms of the tree.
  struct Spot {
    Place place;
    std::size_t entry = 0;
    bool is_return = false;  // to a entry that is there already
  };

  Departure last() const { return last_; }

  /// Changes from here on are kept (commit) or taken back together.
  void begin() { saved_.clear(); }
  void rollback();

  /// Must come before the other calls for a list, while the tree is as these calls left it.
  void sync(const Tree& tree, const std::string& parent, ListName list);

  /// An element leaves its place. Requires a list in sync that has it.
  Departure leave(const std::string& parent, ListName list, std::string_view id);

  /// Behind `place.after`, or behind the place that it has left with a departure after `since`, up to `until`, and
  /// there behind the nearest element that is still present; nothing if there is no such place. Requires a list in
  /// sync.
  std::optional<Spot> spot(const Place& place, Departure since, Departure until) const;

  /// The place that was left by `departure`; nothing if it was pruned. Requires a list in sync.
  std::optional<Spot> spot(const std::string& parent, ListName list, Departure departure) const;

  /// An element enters a place that nothing has changed since.
  void enter(const Spot& spot, std::string_view id);

  /// The lists of `elements`, which were removed by `departure`, go with them.
  void store(const Ids& elements, Departure departure);

  /// The lists that have gone with `departure` are back, as what was removed by it is.
  void restore(Departure departure);

  /// Forgets all departures up to `departure`.
  void prune(Departure departure);

 private:
  struct Entry {
    std::string id;
    Departure left = 0;  // 0: the element is there
  };
  using Entries = std::vector<Entry>;
  struct Key {
    Departure removed = 0;  // by which the parent was removed; 0: it is there
    std::string parent;
    ListName list{};
    auto operator<=>(const Key&) const = default;
  };
  using Lists = std::map<Key, Entries>;

  static Spot spot_at(const Key& key, const Entries& entries, std::size_t entry, bool is_return);

  void save(const Key& key);
  Lists::iterator rename(Lists::iterator list, Departure removed);

  Lists lists_;
  std::map<Key, std::optional<Entries>> saved_;  // what lists were at begin()
  Departure last_ = 0;
};

}  // namespace race::edit
