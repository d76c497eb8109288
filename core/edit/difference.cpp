#include "core/edit/difference.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/value/fields.h"

namespace race::edit {
namespace {

constexpr ListName kStateLists[] = {ListName::parameters, ListName::results,  ListName::variables,
                                    ListName::actions,    ListName::children, ListName::ports};

/// Whether both have the same text: as ==, and the entries are in the same order.
bool same(const Value& a, const Value& b) {
  if (a.identical(b)) return true;
  if (a.is_list() && b.is_list())
    return std::ranges::equal(a.as_list(), b.as_list(), [](const Value& x, const Value& y) { return same(x, y); });
  if (a.is_dict() && b.is_dict()) {
    const Dict &x = a.as_dict(), &y = b.as_dict();
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](const auto& p, const auto& q) { return p.first == q.first && same(p.second, q.second); });
  }
  return a == b;
}

/// Which of `numbers`, each another one, are in the longest rising sequence.
std::vector<bool> longest_rising(const std::vector<std::size_t>& numbers) {
  std::vector<std::size_t> ends;  // [length - 1]: index of the least number that ends a sequence of this length
  std::vector<std::size_t> before(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto end = std::ranges::lower_bound(ends, numbers[i], {}, [&](std::size_t at) { return numbers[at]; });
    if (end != ends.begin()) before[i] = *std::prev(end);
    if (end == ends.end()) {
      ends.push_back(i);
    } else {
      *end = i;
    }
  }
  std::vector<bool> out(numbers.size(), false);
  std::size_t at = ends.empty() ? 0 : ends.back();
  for (std::size_t left = ends.size(); left > 0; --left, at = before[at]) out[at] = true;
  return out;
}

bool is_node(ListName list) { return list == ListName::children || list == ListName::library; }

class Difference {
 public:
  Difference(const Tree& from, const Tree& to) : from_(from), to_(to) {}

  Expected<Edit> make() {
    if (from_.root() != to_.root()) return unexpected(ErrorCode::not_accepted, "the documents have different roots");
    remove_replaced();
    arrange("", ListName::library);
    arrange_below(to_.root());
    remove_rest();
    to_.for_each([this](const Element& element) { set_fields(element); });
    if (auto set = set_document(); !set) return tl::unexpected(std::move(set).error());
    if (edit_.operations.size() > kMaxOperations)
      return unexpected(ErrorCode::too_large, "more than " + std::to_string(kMaxOperations) + " operations");
    freeze(edit_);
    return std::move(edit_);
  }

 private:
  void add(Operation operation) { edit_.operations.push_back(std::move(operation)); }

  static const std::string& id_of(const Element& element) { return meta_of(element.content).id; }

  /// Whether it stays the element that it is, wherever it stands then.
  bool is_kept(const std::string& id) const { return from_.find(id) && to_.find(id) && !replaced_.contains(id); }

  /// Ids that are elements of another kind now cannot be moved, and have to go before the new ones come. What is in
  /// such an element goes with it.
  void remove_replaced() {
    from_.for_each([this](const Element& old) {
      const std::string& id = id_of(old);
      const Element* next = to_.find(id);
      if (!next || !old.list || replaced_.contains(id)) return;
      const bool has_kind = old.content.index() == next->content.index() &&
                            (old.list == next->list || (is_node(*old.list) && is_node(*next->list)));
      if (has_kind) return;
      const Ids gone = from_.subtree(id);
      replaced_.insert(gone.begin(), gone.end());
      add(Remove{id});
    });
  }

  /// Brings the elements of a list to their places, parents first: a place is final once it is taken, and nothing moves
  /// into itself.
  void arrange(const std::string& parent, ListName list) {
    const Ids& wanted = to_.list(parent, list);
    if (wanted.empty()) return;
    const std::vector<bool> stays = staying(parent, list, wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const std::string& id = wanted[i];
      if (!stays[i]) {
        Place place{parent, list, i == 0 ? std::nullopt : std::optional(wanted[i - 1])};
        if (is_kept(id))
          add(Move{id, std::move(place)});
        else
          add(Insert{std::move(place), write_content(new_part(id), list)});
      }
      arrange_below(id);
    }
  }

  void arrange_below(const std::string& id) {
    for (const ListName list : kStateLists) arrange(id, list);
  }

  /// Which of the elements of a list need no operation: of a list of a new state, those that came with it, else the
  /// most that are there in this order.
  std::vector<bool> staying(const std::string& parent, ListName list, const Ids& wanted) const {
    std::vector<bool> out(wanted.size(), false);
    if (!parent.empty() && !is_kept(parent)) {
      for (std::size_t i = 0; i < wanted.size(); ++i) out[i] = !is_kept(wanted[i]);
      return out;
    }
    std::unordered_map<std::string_view, std::size_t> places;
    for (const std::string& id : from_.list(parent, list)) places.emplace(id, places.size());
    std::vector<std::size_t> there, old_places;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto old = places.find(wanted[i]);
      if (old == places.end() || !is_kept(wanted[i])) continue;
      there.push_back(i);
      old_places.push_back(old->second);
    }
    const std::vector<bool> rising = longest_rising(old_places);
    for (std::size_t i = 0; i < there.size(); ++i) out[there[i]] = rising[i];
    return out;
  }

  /// A new element, with what is new in it.
  Content new_part(const std::string& id) const {
    const Element& element = *to_.find(id);
    Content out = element.content;
    if (auto* state = std::get_if<rcm::State>(&out)) {
      for (const ListName list : kStateLists) {
        for (const std::string& inner : to_.list(id, list)) {
          if (!is_kept(inner)) append(*state, list, new_part(inner));
        }
      }
    }
    return out;
  }

  void remove_rest() {
    from_.for_each([this](const Element& old) {
      const std::string& id = id_of(old);
      if (to_.find(id) || replaced_.contains(id)) return;
      if (old.parent.empty() || to_.find(old.parent)) add(Remove{id});
    });
  }

  void set_fields(const Element& next) {
    const std::string& id = id_of(next);
    if (!is_kept(id)) return;
    const Element& old = *from_.find(id);
    const ListName list = next.list.value_or(ListName::children);
    const Value before = write_content(old.content, list), after = write_content(next.content, list);
    set_entries(before, after, [&](const std::string& field, std::optional<Value> value) {
      if (field != "meta") add(Set{id, field, std::nullopt, std::move(value)});
    });
    set_keys(id, "meta", meta_of(old.content).rest, meta_of(next.content).rest);
  }

  /// Calls set(key, value) for each entry in which two objects differ: first those that go.
  template <typename SetEntry>
  static void set_entries(const Value& before, const Value& after, const SetEntry& set) {
    if (before.is_dict()) {
      for (const auto& [key, value] : before.as_dict()) {
        if (!after.find(key.as_string())) set(key.as_string(), std::nullopt);
      }
    }
    if (!after.is_dict()) return;
    for (const auto& [key, value] : after.as_dict()) {
      const Value* old = before.find(key.as_string());
      if (!old || !same(*old, value)) set(key.as_string(), value);
    }
  }

  void set_keys(const std::string& id, const char* field, const Value& before, const Value& after) {
    set_entries(before, after, [&](const std::string& key, std::optional<Value> value) {
      add(Set{id, field, key, std::move(value)});
    });
  }

  Expected<void> set_document_keys(const char* field, const Value& before, const Value& after) {
    if (same(before, after)) return {};
    const auto has_entries = [](const Value& value) { return value.is_null() || value.is_dict(); };
    if (!has_entries(before) || !has_entries(after))
      return unexpected(ErrorCode::not_accepted, "`" + std::string(field) + "` of the document is no object");
    set_keys("", field, before, after);
    return {};
  }

  Expected<void> set_document() {
    const rcm::Document &before = from_.fields(), &after = to_.fields();
    if (before.name != after.name)
      add(Set{"", "name", {}, after.name.empty() ? std::nullopt : std::optional<Value>(after.name)});
    set_keys("", "services", services(before), services(after));
    if (auto set = set_document_keys("layout", before.layout, after.layout); !set) return set;
    if (auto set = set_document_keys("notes", notes(before), notes(after)); !set) return set;
    return set_document_keys("meta", without_notes(before), without_notes(after));
  }

  static Value services(const rcm::Document& document) {
    Dict out;
    for (const auto& [key, type] : document.services) out.set(key, type);
    return out;
  }

  static Value notes(const rcm::Document& document) {
    const Value* found = document.meta.find("notes");
    return found ? *found : Value();
  }

  static Value without_notes(const rcm::Document& document) {
    Value out = document.meta;
    if (out.find("notes")) out.mutable_dict().erase("notes");
    return out;
  }

  const Tree& from_;
  const Tree& to_;
  std::unordered_set<std::string> replaced_;  // ids of elements of `from`
  Edit edit_;
};

}  // namespace

Expected<Edit> difference(const Tree& from, const Tree& to) { return Difference(from, to).make(); }

}  // namespace race::edit
