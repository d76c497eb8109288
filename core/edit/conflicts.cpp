#include "core/edit/conflicts.h"

#include <algorithm>
#include <utility>

namespace race::edit {
namespace {

/// The element whose content or place an operation changes; nothing for one that only takes away.
std::string_view changed(const Operation& operation) {
  if (const auto* insert = std::get_if<Insert>(&operation)) {
    const Value* meta = insert->node.find("meta");
    const Value* id = meta ? meta->find("id") : nullptr;
    return id && id->is_string() ? std::string_view(id->as_string()) : std::string_view();
  }
  if (const auto* move = std::get_if<Move>(&operation)) return move->id;
  if (const auto* set = std::get_if<Set>(&operation)) return set->id;
  return {};
}

bool contains(const Ids& sorted, std::string_view id) { return std::ranges::binary_search(sorted, id); }

Rejection because(const LogEntry* entry, std::string what, std::string field) {
  const Accepted& edit = entry->accepted;
  what += " by " + quote(edit.author) + " (revision " + std::to_string(edit.revision) + ")";
  return {Error{ErrorCode::conflict, std::move(what), std::move(field)}, edit.revision, edit.author};
}

}  // namespace

Conflicts::Conflicts(const Log& log, const Tree& tree, Of of, Revision base, std::string_view author)
    : log_(log),
      tree_(tree),
      of_(of),
      base_(base),
      author_(author),
      taken_back_(of == Of::change ? nullptr : &log[base - log.front().accepted.revision]) {}

bool Conflicts::counts(const LogEntry& entry) const {
  // An author's own edits are taken back in reverse order, unless one could not be; what they have redone since an undo
  // was there when they did what they redo now.
  if (of_ == Of::undo) return entry.in_effect;
  if (of_ == Of::redo) return entry.in_effect && entry.accepted.author != author_;
  // Whoever has seen an edit has not seen that it was undone.
  return entry.accepted.author != author_ && (entry.in_effect || entry.partner <= base_);
}

template <typename Matches>
const LogEntry* Conflicts::find(Matches matches) const {
  for (auto entry = log_.rbegin(); entry != log_.rend() && entry->accepted.revision > base_; ++entry) {
    if (!counts(*entry)) continue;
    const auto& operations = entry->accepted.edit.operations;
    const auto& inverses = entry->accepted.inverse.operations;
    for (std::size_t i = 0; i < operations.size(); ++i) {
      if (matches(operations[i], inverses[operations.size() - 1 - i])) return &*entry;
    }
  }
  return nullptr;
}

const LogEntry* Conflicts::change_below(std::string_view id) const {
  return find([&](const Operation& o, const Operation& inverse) {
    const std::string_view at = changed(o);
    if (!at.empty() && tree_.is_below(id, at)) return true;
    // What was taken out of there would have no way back.
    const Place* left = place_of(inverse);
    return of_ != Of::change && left && tree_.is_below(id, left->parent);
  });
}

const LogEntry* Conflicts::move_of(std::string_view id) const {
  return find([&](const Operation& o, const Operation&) {
    const auto* move = std::get_if<Move>(&o);
    return move && move->id == id;
  });
}

const LogEntry* Conflicts::set_of(const Set& set) const {
  return find([&](const Operation& o, const Operation&) {
    const auto* other = std::get_if<Set>(&o);
    return other && other->id == set.id && other->field == set.field && other->key == set.key;
  });
}

const LogEntry* Conflicts::replacement_of(std::string_view id) const {
  for (auto entry = log_.rbegin(); entry != log_.rend() && entry->accepted.revision > base_; ++entry) {
    if (counts(*entry) && contains(entry->inserted, id)) return &*entry;
  }
  return nullptr;
}

std::optional<Rejection> Conflicts::of(const Operation& operation) const {
  // An undo puts nothing into what has come in the place of the element that it was in, under its id, and brings
  // nothing back that others have inserted since.
  if (const Place* place = place_of(operation); place && of_ != Of::change) {
    if (const auto* entry = replacement_of(place->parent))
      return because(entry, quote(place->parent) + " was replaced", "parent");
    if (std::holds_alternative<Insert>(operation)) {
      for (const std::string& id : taken_back_->removed) {
        if (const auto* entry = replacement_of(id)) return because(entry, quote(id) + " was replaced", "node");
      }
    }
  }
  if (const auto* remove = std::get_if<Remove>(&operation)) {
    if (const auto* entry = change_below(remove->id))
      return because(entry, quote(remove->id) + ", or what is in it, was changed", "id");
    if (const auto* entry = replacement_of(remove->id))
      return because(entry, quote(remove->id) + " was replaced", "id");
  } else if (const auto* move = std::get_if<Move>(&operation)) {
    if (const auto* entry = move_of(move->id)) return because(entry, quote(move->id) + " was moved", "id");
    if (const auto* entry = replacement_of(move->id)) return because(entry, quote(move->id) + " was replaced", "id");
  } else if (const auto* set = std::get_if<Set>(&operation); set && of_ != Of::change) {
    if (const auto* entry = set_of(*set))
      return because(entry,
                     quote(set->field) + " of " + (set->id.empty() ? "the document" : quote(set->id)) + " was set",
                     "field");
    if (const auto* entry = replacement_of(set->id)) return because(entry, quote(set->id) + " was replaced", "id");
  }
  return std::nullopt;
}

Rejection Conflicts::explain(Error error, const Operation& operation) const {
  const auto last = [&](const Ids LogEntry::*ids, std::string_view id) -> const LogEntry* {
    for (auto entry = log_.rbegin(); entry != log_.rend(); ++entry) {
      if (contains((*entry).*ids, id)) return &*entry;
    }
    return nullptr;
  };
  const auto gone = [&](std::string_view id) -> std::optional<Rejection> {
    const LogEntry* entry = last(&LogEntry::removed, id);
    if (!entry || tree_.find(id)) return std::nullopt;
    return because(entry, quote(id) + " was removed", error.path);
  };
  std::optional<Rejection> out;
  const auto* move = std::get_if<Move>(&operation);
  const auto* insert = std::get_if<Insert>(&operation);
  if (error.code == ErrorCode::not_found && error.path == "parent") {
    out = gone(move ? move->place.parent : insert->place.parent);
  } else if (error.code == ErrorCode::not_found && error.path == "id") {
    const auto* remove = std::get_if<Remove>(&operation);
    out = gone(remove ? remove->id : move ? move->id : std::get<Set>(operation).id);
  } else if (error.code == ErrorCode::not_accepted && move && error.path == "parent") {
    const auto* entry = find([&](const Operation& o, const Operation&) {
      const auto* other = std::get_if<Move>(&o);
      return other && tree_.is_below(move->id, other->id) && tree_.is_below(other->id, move->place.parent);
    });
    if (entry) out = because(entry, quote(move->place.parent) + " was moved into " + quote(move->id), "parent");
  }
  return out ? *std::move(out) : Rejection{std::move(error), 0, ""};
}

}  // namespace race::edit
