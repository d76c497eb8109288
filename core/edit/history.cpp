#include "core/edit/history.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "core/edit/apply.h"
#include "core/edit/extent.h"

namespace race::edit {
namespace {

std::size_t units_of(const Edit& edit) {
  std::size_t out = 0;
  for (const Operation& operation : edit.operations) {
    out += kOperationUnits;
    if (const auto* insert = std::get_if<Insert>(&operation)) out += insert->node.size_units();
    if (const auto* set = std::get_if<Set>(&operation); set && set->value) out += set->value->size_units();
  }
  return out;
}

/// The element that an operation takes from its place; empty if none.
std::string_view leaving(const Operation& operation) {
  if (const auto* remove = std::get_if<Remove>(&operation)) return remove->id;
  if (const auto* move = std::get_if<Move>(&operation)) return move->id;
  return {};
}

}  // namespace

/// What shall be done, by whom, and of what it keeps the meaning.
struct History::Request {
  Conflicts conflicts;
  const Edit& edit;
  const std::vector<Departure>* departures = nullptr;  // of the edit that it takes back
  Departure since = 0;                                 // what its author has seen
  Departure until = 0;                                 // what was there before it
};

History::History(Tree tree, Revision revision, HistoryLimits limits)
    : tree_(std::move(tree)), revision_(revision), limits_(limits) {}

tl::expected<Positions::Spot, Rejection> History::spot(const Request& request, const Place& place,
                                                       Departure returning) const {
  if (auto own = positions_.spot(place.parent, place.list, returning)) return *std::move(own);
  if (auto found = positions_.spot(place, request.since, request.until)) return *std::move(found);
  return tl::unexpected(Rejection{
      Error{ErrorCode::not_found, "there is no element `" + *place.after + "` in this list", "after"}, 0, ""});
}

tl::expected<Operation, Rejection> History::execute(const Request& request, const Operation& operation,
                                                    Departure returning, LogEntry& entry) {
  if (auto conflict = request.conflicts.of(operation)) return tl::unexpected(*std::move(conflict));
  Operation concrete = operation;
  const std::string_view id = leaving(operation);
  const Element* element = id.empty() ? nullptr : tree_.find(id);
  const Place* place = place_of(operation);
  // What cannot be applied in any case is left to the tree, which says why.
  const bool is_possible = (id.empty() || (element && element->list)) &&
                           !(place && place->after == id && !id.empty()) &&
                           (!place || place->parent.empty() || tree_.find(place->parent));
  Departure departure = 0;
  std::optional<Positions::Spot> entered;
  if (is_possible) {
    if (element) positions_.sync(tree_, element->parent, *element->list);
    if (place) positions_.sync(tree_, place->parent, place->list);
    if (element) departure = positions_.leave(element->parent, *element->list, id);
    if (place) {
      auto found = spot(request, *place, returning);
      if (!found) return tl::unexpected(std::move(found).error());
      entered = *std::move(found);
      if (auto* insert = std::get_if<Insert>(&concrete)) insert->place = entered->place;
      if (auto* move = std::get_if<Move>(&concrete)) move->place = entered->place;
    }
  }
  if (const auto* remove = std::get_if<Remove>(&concrete); remove && element) {
    const Ids ids = tree_.subtree(remove->id);
    entry.removed.insert(entry.removed.end(), ids.begin(), ids.end());
    positions_.store(ids, departure);
  }
  auto inverse = edit::apply(tree_, concrete);
  if (!inverse) return tl::unexpected(request.conflicts.explain(std::move(inverse).error(), operation));
  if (std::holds_alternative<Insert>(concrete)) {
    const std::string& inserted = std::get<Remove>(*inverse).id;
    const Ids ids = tree_.subtree(inserted);
    entry.inserted.insert(entry.inserted.end(), ids.begin(), ids.end());
    positions_.enter(*entered, inserted);
    if (entered->is_return) positions_.restore(returning);
  } else if (entered) {
    positions_.enter(*entered, id);
  }
  entry.departures.push_back(departure);
  entry.accepted.edit.operations.push_back(std::move(concrete));
  return *std::move(inverse);
}

tl::expected<LogEntry, Rejection> History::execute(const Request& request) {
  LogEntry out;
  std::vector<Operation>& inverse = out.accepted.inverse.operations;
  positions_.begin();
  const auto rejected = [&](Rejection reason) {
    std::ranges::reverse(inverse);
    apply_known(tree_, out.accepted.inverse);
    positions_.rollback();
    return tl::unexpected(std::move(reason));
  };
  const std::size_t count = request.edit.operations.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Departure returning = request.departures ? (*request.departures)[count - 1 - i] : 0;
    auto undo = execute(request, request.edit.operations[i], returning, out);
    if (!undo) {
      Rejection reason = std::move(undo).error();
      reason.error.path = "operations/" + std::to_string(i) + "/" + reason.error.path;
      return rejected(std::move(reason));
    }
    inverse.push_back(*std::move(undo));
  }
  if (auto fits = check_extent(tree_); !fits) return rejected({std::move(fits).error(), 0, ""});
  std::ranges::reverse(inverse);
  return out;
}

const Accepted* History::commit(LogEntry entry) {
  Accepted& accepted = entry.accepted;
  accepted.revision = ++revision_;
  freeze(accepted.edit);
  freeze(accepted.inverse);
  std::ranges::sort(entry.inserted);
  std::ranges::sort(entry.removed);
  entry.last_departure = positions_.last();
  entry.units = units_of(accepted.edit) + units_of(accepted.inverse);
  units_ += entry.units;
  log_.push_back(std::move(entry));
  forget();
  return &log_.back().accepted;
}

void History::forget() {
  const Revision first = log_.front().accepted.revision;
  Departure departure = 0;
  while (log_.size() > 1 && (log_.size() > limits_.edits || units_ > limits_.units)) {
    departure = log_.front().last_departure;
    units_ -= log_.front().units;
    log_.pop_front();
  }
  const Revision oldest = log_.front().accepted.revision;
  if (oldest == first) return;
  positions_.prune(departure);
  const auto is_gone = [&](const Step& step) { return step.revision < oldest; };
  for (auto& [author, stacks] : stacks_) {
    std::erase_if(stacks.undo, is_gone);
    std::erase_if(stacks.redo, is_gone);
  }
  std::erase_if(stacks_, [](const auto& of) { return of.second.undo.empty() && of.second.redo.empty(); });
}

Departure History::last_departure(Revision revision) const {
  if (log_.empty() || revision < log_.front().accepted.revision) return 0;
  return log_[revision - log_.front().accepted.revision].last_departure;
}

History::Result History::apply(std::string_view author, Revision base, const Edit& edit) {
  const auto refused = [](ErrorCode code, std::string message) {
    return tl::unexpected(Rejection{Error{code, std::move(message), ""}, 0, ""});
  };
  const Revision oldest = revision_ - log_.size();
  if (base > revision_) return refused(ErrorCode::out_of_range, "there is no revision " + std::to_string(base));
  if (base < oldest)
    return refused(ErrorCode::conflict, "revision " + std::to_string(base) +
                                            " is too old; the oldest that can be edited is " + std::to_string(oldest));
  auto entry = execute({Conflicts(log_, tree_, Conflicts::Of::change, base, author), edit, nullptr,
                        last_departure(base), positions_.last()});
  if (!entry) return tl::unexpected(std::move(entry).error());
  entry->accepted.author = author;
  const Accepted* accepted = commit(*std::move(entry));
  Stacks& stacks = stacks_[std::string(author)];
  stacks.redo.clear();
  stacks.undo.push_back({accepted->revision});
  return accepted;
}

History::Result History::take_back(std::string_view author, Steps Stacks::*from, Accepted::Kind kind) {
  const auto stacks = stacks_.find(author);
  const auto step = [&](Steps& steps) {
    return std::ranges::find(steps | std::views::reverse, false, &Step::is_blocked);
  };
  const bool is_undo = kind == Accepted::Kind::undo;
  if (stacks == stacks_.end() || step(stacks->second.*from) == (stacks->second.*from).rend())
    return tl::unexpected(Rejection{
        Error{ErrorCode::not_found, std::string("there is nothing to ") + (is_undo ? "undo" : "redo"), ""}, 0, ""});
  const auto latest = step(stacks->second.*from);
  const Revision revision = latest->revision;
  const LogEntry& taken = entry_of(revision);
  const auto of = is_undo ? Conflicts::Of::undo : Conflicts::Of::redo;
  auto entry = execute({Conflicts(log_, tree_, of, revision, author), taken.accepted.inverse, &taken.departures,
                        taken.last_departure, positions_.last()});
  if (!entry) {
    latest->is_blocked = true;
    return tl::unexpected(std::move(entry).error());
  }
  (stacks->second.*from).erase(std::prev(latest.base()));
  for (auto& [name, others] : stacks_) {
    for (Step& other : others.undo) other.is_blocked = false;
    for (Step& other : others.redo) other.is_blocked = false;
  }
  if (is_undo) {
    LogEntry& undone = entry_of(revision);
    undone.in_effect = entry->in_effect = false;
    undone.partner = revision_ + 1;
    entry->partner = revision;
  }
  entry->accepted.author = author;
  entry->accepted.kind = kind;
  entry->accepted.of = revision;
  const Accepted* accepted = commit(*std::move(entry));
  Stacks& own = stacks_[std::string(author)];
  (is_undo ? own.redo : own.undo).push_back({accepted->revision});
  return accepted;
}

History::Result History::undo(std::string_view author) {
  return take_back(author, &Stacks::undo, Accepted::Kind::undo);
}

History::Result History::redo(std::string_view author) {
  return take_back(author, &Stacks::redo, Accepted::Kind::redo);
}

std::size_t History::undo_depth(std::string_view author) const {
  const auto stacks = stacks_.find(author);
  return stacks == stacks_.end() ? 0 : stacks->second.undo.size();
}

std::size_t History::redo_depth(std::string_view author) const {
  const auto stacks = stacks_.find(author);
  return stacks == stacks_.end() ? 0 : stacks->second.redo.size();
}

}  // namespace race::edit
