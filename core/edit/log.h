// The log of a document: the latest accepted edits, each with what it takes to undo it and to judge what comes after.
// Pure values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/edit/operation.h"
#include "core/edit/positions.h"

namespace race::edit {

/// Of a document: how many edits it has had.
using Revision = std::uint64_t;

/// An edit as it was applied: positions and all are those of the revision before it. Its values are frozen.
struct Accepted {
  enum class Kind { change, undo, redo };

  Revision revision = 0;  // of the document after it
  std::string author;
  Edit edit, inverse;
  Kind kind = Kind::change;
  Revision of = 0;  // an undo: what it takes back; a redo: the undo that it takes back
};

struct LogEntry {
  Accepted accepted;
  std::vector<Departure> departures;  // of each operation: the place that its element left
  Departure last_departure = 0;       // of all edits up to this one
  Ids inserted, removed;              // all elements that came and went, sorted
  bool in_effect = true;              // false: an edit and its undo, which together change nothing
  Revision partner = 0;               // of an edit that is not in effect, the undo, and of an undo, the edit
  std::size_t units = 0;              // its size
};

using Log = std::deque<LogEntry>;

}  // namespace race::edit
