#include "core/value/value.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>

namespace race {

struct Value::StringRep : Counted {
  std::string text;
};
struct Value::ListRep : Counted {
  List items;
};
struct Value::DictRep : Counted {
  Dict entries;
};

Value::Value(std::string text) : kind_(Kind::string) {
  auto* rep = new StringRep;
  rep->text = std::move(text);
  payload_ = reinterpret_cast<std::int64_t>(static_cast<Counted*>(rep));
}

Value::Value(List items) : kind_(Kind::list) {
  auto* rep = new ListRep;
  rep->items = std::move(items);
  payload_ = reinterpret_cast<std::int64_t>(static_cast<Counted*>(rep));
}

Value::Value(Dict entries) : kind_(Kind::dict) {
  auto* rep = new DictRep;
  rep->entries = std::move(entries);
  payload_ = reinterpret_cast<std::int64_t>(static_cast<Counted*>(rep));
}

const std::string& Value::as_string() const noexcept {
  assert(is_string());
  return static_cast<const StringRep*>(heap())->text;
}

const List& Value::as_list() const noexcept {
  assert(is_list());
  return static_cast<const ListRep*>(heap())->items;
}

const Dict& Value::as_dict() const noexcept {
  assert(is_dict());
  return static_cast<const DictRep*>(heap())->entries;
}

List& Value::mutable_list() {
  assert(is_list());
  if (heap()->frozen || heap()->references != 1) *this = Value(as_list());
  return static_cast<ListRep*>(heap())->items;
}

Dict& Value::mutable_dict() {
  assert(is_dict());
  if (heap()->frozen || heap()->references != 1) *this = Value(as_dict());
  return static_cast<DictRep*>(heap())->entries;
}

const Value* Value::find(std::string_view key) const noexcept { return is_dict() ? as_dict().find(key) : nullptr; }

Value& Value::freeze() {
  if (!counted() || heap()->frozen) return *this;
  if (is_list()) {
    for (Value& item : static_cast<ListRep*>(heap())->items) item.freeze();
  } else if (is_dict()) {
    static_cast<DictRep*>(heap())->entries.freeze();
  }
  heap()->frozen = true;
  return *this;
}

std::size_t Value::size_units() const noexcept {
  std::size_t units = 1;
  if (is_string()) return as_string().size() + 1;
  if (is_list())
    for (const Value& item : as_list()) units += item.size_units();
  if (is_dict())
    for (const auto& [key, item] : as_dict()) units += key.size_units() + item.size_units();
  return units;
}

bool Value::is_finite() const noexcept {
  if (is_number()) return std::isfinite(as_number());
  if (is_list()) return std::ranges::all_of(as_list(), [](const Value& item) { return item.is_finite(); });
  if (is_dict()) return std::ranges::all_of(as_dict(), [](const auto& entry) { return entry.second.is_finite(); });
  return true;
}

bool Value::operator==(const Value& other) const noexcept {
  if (kind_ != other.kind_) return false;
  if (payload_ == other.payload_) return true;  // the same scalar, bit by bit, or the same object
  switch (kind_) {
    case Kind::string:
      return as_string() == other.as_string();
    case Kind::list:
      return as_list() == other.as_list();
    case Kind::dict:
      return as_dict() == other.as_dict();
    case Kind::unknown:
    case Kind::null:
      return true;
    default:
      return false;
  }
}

void Value::destroy() noexcept {
  if (kind_ == Kind::string) delete static_cast<StringRep*>(heap());
  if (kind_ == Kind::list) delete static_cast<ListRep*>(heap());
  if (kind_ == Kind::dict) delete static_cast<DictRep*>(heap());
}

Dict::Dict(std::initializer_list<std::pair<std::string_view, Value>> entries) {
  entries_.reserve(entries.size());
  for (const auto& [key, value] : entries) set(key, value);
}

namespace {

// OPTIMIZATION: names are short; an inlined comparison costs less than a call of memcmp.
bool same(const std::string& a, const std::string& b) noexcept {
  const std::size_t size = a.size();
  if (size != b.size()) return false;
  for (std::size_t i = 0; i < size; ++i)
    if (a[i] != b[i]) return false;
  return true;
}

}  // namespace

// The position of `key` in the index, or the free position for it.
std::size_t Dict::probe(std::string_view key) const noexcept {
  const std::size_t mask = index_.size() - 1;
  std::size_t at = std::hash<std::string_view>{}(key)&mask;
  while (index_[at] != 0 && entries_[index_[at] - 1].first.as_string() != key) at = (at + 1) & mask;
  return at;
}

std::size_t Dict::position(std::string_view key) const noexcept {
  if (!index_.empty()) {
    const std::uint32_t found = index_[probe(key)];
    return found == 0 ? entries_.size() : found - 1;
  }
  std::size_t i = 0;
  while (i < entries_.size() && entries_[i].first.as_string() != key) ++i;
  return i;
}

void Dict::rebuild() {
  index_.clear();
  if (entries_.size() < kIndexed) return;
  index_.assign(std::bit_ceil(entries_.size() * 3), 0);
  for (std::size_t i = 0; i < entries_.size(); ++i)
    index_[probe(entries_[i].first.as_string())] = static_cast<std::uint32_t>(i + 1);
}

const Value* Dict::find_text(std::string_view key) const noexcept {
  const std::size_t i = position(key);
  return i == entries_.size() ? nullptr : &entries_[i].second;
}

const Value* Dict::find(const Value& key) const noexcept {
  const std::string& text = key.as_string();
  if (!index_.empty()) return find_text(text);
  for (const Entry& entry : entries_)
    if (entry.first.identical(key) || same(entry.first.as_string(), text)) return &entry.second;
  return nullptr;
}

Value* Dict::find(const Value& key) noexcept { return const_cast<Value*>(std::as_const(*this).find(key)); }

void Dict::set(const Value& key, Value value) {
  const std::size_t i = position(key.as_string());
  if (i < entries_.size()) {
    entries_[i].second = std::move(value);
    return;
  }
  entries_.emplace_back(key, std::move(value));
  if (index_.empty() ? entries_.size() >= kIndexed : entries_.size() * 2 > index_.size())
    rebuild();
  else if (!index_.empty())
    index_[probe(key.as_string())] = static_cast<std::uint32_t>(entries_.size());
}

bool Dict::erase(std::string_view key) {
  const std::size_t i = position(key);
  if (i == entries_.size()) return false;
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(i));
  rebuild();
  return true;
}

void Dict::clear() noexcept {
  entries_.clear();
  index_.clear();
}

namespace {

bool is_before(const Dict::Entry& a, const Dict::Entry& b) { return a.first.as_string() < b.first.as_string(); }

}  // namespace

bool Dict::is_sorted() const { return std::ranges::is_sorted(entries_, is_before); }

Dict Dict::sorted() const {
  Dict out = *this;
  std::ranges::sort(out.entries_, is_before);
  out.rebuild();
  return out;
}

void Dict::freeze() {
  for (auto& [key, value] : entries_) {
    key.freeze();
    value.freeze();
  }
}

bool Dict::operator==(const Dict& other) const noexcept {
  if (size() != other.size()) return false;
  for (const auto& [key, value] : entries_) {
    const Value* found = other.find(key);
    if (!found || !(*found == value)) return false;
  }
  return true;
}

}  // namespace race
