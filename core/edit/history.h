// History: a document, the edits that it has had lately, and what each author can undo. The order of the calls is the
// order of the edits; an edit that was made on an earlier revision is accepted if its meaning is kept (conflicts.h),
// else rejected with the reason. Replicas that apply the accepted edits in this order have the same document.
//
// A value, on one thread; what it hands out is frozen.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/edit/conflicts.h"
#include "core/edit/log.h"
#include "core/edit/positions.h"
#include "core/edit/tree.h"

namespace race::edit {

/// The log forgets the oldest edits beyond this, but never the latest one.
struct HistoryLimits {
  std::size_t edits = 1000;
  std::size_t units = 64U << 20U;  // Value::size_units of what is inserted and set, and kOperationUnits an operation
};
inline constexpr std::size_t kOperationUnits = 1024;

class History {
 public:
  explicit History(Tree tree, Revision revision = 0, HistoryLimits limits = {});

  const Tree& tree() const { return tree_; }
  Revision revision() const { return revision_; }
  const Log& log() const { return log_; }

  /// The edit as it was applied: good until the next call. What is rejected changes nothing.
  using Result = tl::expected<const Accepted*, Rejection>;

  /// An edit by somebody who has seen revision `base` and their own edits after it. Rejections: those of apply() and
  /// `conflict`; paths name the field (`operations/0/id`). `out_of_range`: there is no such revision; `conflict`
  /// without an edit: the log has forgotten what came after it.
  Result apply(std::string_view author, Revision base, const Edit& edit);

  /// Takes back the latest edit of `author` that is in effect. Rejected: `not_found`, there is none; `conflict`, if an
  /// edit that is in effect has changed the same thing since. Then that edit is left out by the next undo, until
  /// somebody takes something back.
  Result undo(std::string_view author);

  /// Takes back the latest undo of `author`, if they have not applied an edit since.
  Result redo(std::string_view author);

  /// How many edits undo and redo could try.
  std::size_t undo_depth(std::string_view author) const;
  std::size_t redo_depth(std::string_view author) const;

 private:
  struct Step {
    Revision revision;
    bool is_blocked = false;  // it was rejected; nothing was taken back since
  };
  using Steps = std::vector<Step>;
  struct Stacks {
    Steps undo, redo;
  };
  struct Request;

  tl::expected<LogEntry, Rejection> execute(const Request& request);
  tl::expected<Operation, Rejection> execute(const Request& request, const Operation& operation, Departure returning,
                                             LogEntry& entry);
  tl::expected<Positions::Spot, Rejection> spot(const Request& request, const Place& place, Departure returning) const;
  Result take_back(std::string_view author, Steps Stacks::*from, Accepted::Kind kind);
  const Accepted* commit(LogEntry entry);
  LogEntry& entry_of(Revision revision) { return log_[revision - log_.front().accepted.revision]; }
  Departure last_departure(Revision revision) const;
  void forget();

  Tree tree_;
  Positions positions_;
  Log log_;
  Revision revision_;
  std::size_t units_ = 0;
  HistoryLimits limits_;
  std::map<std::string, Stacks, std::less<>> stacks_;
};

}  // namespace race::edit
