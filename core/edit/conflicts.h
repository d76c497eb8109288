// Conflicts: whether an operation keeps its meaning although others have edited the document meanwhile. README.md has
// the rules as a table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/edit/log.h"
#include "core/edit/tree.h"
#include "core/value/expected.h"

namespace race::edit {

/// Why an edit was not accepted, and the edit of another that is the reason, if there is one.
struct Rejection {
  Error error;
  Revision revision = 0;  // 0: nobody's edit
  std::string author;
};

class Conflicts {
 public:
  /// A change was made by somebody who has seen `base` and their own edits; an undo takes back the edit `base`, a redo
  /// the undo `base`.
  enum class Of { change, undo, redo };
  Conflicts(const Log& log, const Tree& tree, Of of, Revision base, std::string_view author);

  /// Why `operation`, about to be applied, would not do what its author meant. `conflict`, and the path is the field.
  std::optional<Rejection> of(const Operation& operation) const;

  /// Names the edit because of which `operation` was refused with `error`, if one is known.
  Rejection explain(Error error, const Operation& operation) const;

 private:
  /// Of an edit after `base`.
  bool counts(const LogEntry& entry) const;
  /// The latest entry that counts of which matches(operation) holds for an operation.
  template <typename Matches>
  const LogEntry* find(Matches matches) const;
  const LogEntry* change_below(std::string_view id) const;
  const LogEntry* move_of(std::string_view id) const;
  const LogEntry* set_of(const Set& set) const;
  const LogEntry* replacement_of(std::string_view id) const;

  const Log& log_;
  const Tree& tree_;
  Of of_;
  Revision base_;
  std::string_view author_;
  const LogEntry* taken_back_;  // by an undo or redo
};

}  // namespace race::edit
