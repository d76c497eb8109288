// Value: what parameters, results, variables, events and responses hold: null, bool, 64-bit int, double, string, list,
// dict. Lists and dicts are copy-on-write: a copy costs a counter, and the first change of a shared one copies it (one
// level).
//
// Threads: a value belongs to one thread until it is frozen. `freeze()` makes it and all it contains immutable and safe
// to share: from then on its counters are atomic, and a change copies. What leaves a core's strand is frozen first.
//
// The eighth kind, `unknown`, is "no value": a slot of Δ that is not set, missing service data (core/SEMANTICS.md, R2).
// It is never an element of a list or dict and never leaves the core.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace race {

class Value;
class Dict;
using List = std::vector<Value>;

/// The heap part of a string, list or dict: counted, and frozen when shared between threads.
struct Counted {
  mutable std::uint32_t references = 1;
  bool frozen = false;
};

class Value {
 public:
  enum class Kind : std::uint8_t { unknown, null, boolean, integer, number, string, list, dict };

  Value() noexcept : kind_(Kind::null), payload_(0) {}
  Value(std::nullptr_t) noexcept : Value() {}
  Value(bool v) noexcept : kind_(Kind::boolean), payload_(v ? 1 : 0) {}
  Value(std::int64_t v) noexcept : kind_(Kind::integer), payload_(v) {}
  Value(int v) noexcept : Value(static_cast<std::int64_t>(v)) {}
  Value(double v) noexcept : kind_(Kind::number), payload_(std::bit_cast<std::int64_t>(v)) {}
  Value(std::string text);
  Value(std::string_view text) : Value(std::string(text)) {}
  Value(const char* text) : Value(std::string(text)) {}
  Value(List items);
  Value(Dict entries);

  Value(const Value& other) noexcept : kind_(other.kind_), payload_(other.payload_) {
    if (counted()) retain();
  }
  Value(Value&& other) noexcept : kind_(other.kind_), payload_(other.payload_) { other.kind_ = Kind::null; }
  // Both assignments release the old value last: `other` may be an element of it.
  Value& operator=(const Value& other) noexcept {
    Value old(other);
    swap(old);
    return *this;
  }
  Value& operator=(Value&& other) noexcept {
    Value old(std::move(other));
    swap(old);
    return *this;
  }
  ~Value() {
    if (counted()) release();
  }

  /// "No value".
  static Value unknown() noexcept {
    Value v;
    v.kind_ = Kind::unknown;
    return v;
  }

  Kind kind() const noexcept { return kind_; }
  bool is_unknown() const noexcept { return kind_ == Kind::unknown; }
  bool is_null() const noexcept { return kind_ == Kind::null; }
  bool is_bool() const noexcept { return kind_ == Kind::boolean; }
  bool is_integer() const noexcept { return kind_ == Kind::integer; }
  bool is_number() const noexcept { return kind_ == Kind::number; }
  /// An int or a double.
  bool is_numeric() const noexcept { return kind_ == Kind::integer || kind_ == Kind::number; }
  bool is_string() const noexcept { return kind_ == Kind::string; }
  bool is_list() const noexcept { return kind_ == Kind::list; }
  bool is_dict() const noexcept { return kind_ == Kind::dict; }

  // Each requires its kind.
  bool as_bool() const noexcept { return payload_ != 0; }
  std::int64_t as_integer() const noexcept { return payload_; }
  double as_number() const noexcept { return std::bit_cast<double>(payload_); }
  const std::string& as_string() const noexcept;
  const List& as_list() const noexcept;
  const Dict& as_dict() const noexcept;
  /// An int or a double as a double. Requires is_numeric().
  double to_double() const noexcept { return is_integer() ? static_cast<double>(as_integer()) : as_number(); }

  /// Whether a change in place copies first: something else holds the list or dict, too, or it is frozen. Requires a
  /// list, dict or string.
  bool is_shared() const noexcept { return heap()->frozen || heap()->references != 1; }

  // For changing in place: copies first if the value is shared. Each requires its kind. The reference is good
  // until this value is copied again.
  List& mutable_list();
  Dict& mutable_dict();

  /// The entry `key` of a dict; nullptr if this is no dict or has no such entry.
  const Value* find(std::string_view key) const noexcept;

  /// Makes this and all it contains immutable and safe to share between threads. Returns *this.
  Value& freeze();

  /// The number of elements, entries and string bytes in it, all levels; 1 for a scalar (SEMANTICS.md section 8,
  /// Budget).
  std::size_t size_units() const noexcept;

  /// Whether it holds no NaN and no infinity, at any level: what may be stored and sent (SEMANTICS.md section 8).
  bool is_finite() const noexcept;

  /// Structural equality: 1, 1.0 and True are three values; doubles are compared bit by bit; dicts regardless of order.
  bool operator==(const Value& other) const noexcept;

  /// Whether both are the same object or the same scalar: cheap, false for equal but separate lists.
  bool identical(const Value& other) const noexcept { return kind_ == other.kind_ && payload_ == other.payload_; }

 private:
  struct StringRep;
  struct ListRep;
  struct DictRep;

  void swap(Value& other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(payload_, other.payload_);
  }
  bool counted() const noexcept { return kind_ >= Kind::string; }
  void retain() const noexcept {
    if (heap()->frozen) {
      __atomic_fetch_add(&heap()->references, 1U, __ATOMIC_RELAXED);
    } else {
      ++heap()->references;
    }
  }
  void release() noexcept {
    if (heap()->frozen ? __atomic_sub_fetch(&heap()->references, 1U, __ATOMIC_ACQ_REL) == 0 : --heap()->references == 0)
      destroy();
  }
  void destroy() noexcept;

  Counted* heap() const noexcept { return reinterpret_cast<Counted*>(payload_); }

  Kind kind_;
  // An integer, the bits of a double, or the address of the heap part. Not a union: g++ 12.2 at -O2 loses stores to one
  // member before loads from another where assignments are inlined (into std::optional, for one).
  std::int64_t payload_;
};
static_assert(sizeof(Value) == 16);

/// The entries of a dict in order of insertion, as in Python. Small dicts are searched linearly, large ones through an
/// index.
class Dict {
 public:
  using Entry = std::pair<Value, Value>;  // key (a string), value
  Dict() = default;
  Dict(std::initializer_list<std::pair<std::string_view, Value>> entries);

  std::size_t size() const noexcept { return entries_.size(); }
  bool empty() const noexcept { return entries_.empty(); }
  auto begin() const noexcept { return entries_.begin(); }
  auto end() const noexcept { return entries_.end(); }

  template <std::convertible_to<std::string_view> Text>
  const Value* find(const Text& key) const noexcept {
    return find_text(std::string_view(key));
  }
  /// As above; a key that is the very string of the entry is found without comparing characters. Requires a string.
  const Value* find(const Value& key) const noexcept;
  Value* find(const Value& key) noexcept;
  /// Sets `key` (a string) to `value`; a new key goes to the end.
  void set(const Value& key, Value value);
  template <std::convertible_to<std::string_view> Text>
  void set(const Text& key, Value value) {
    set(Value(std::string_view(key)), std::move(value));
  }
  /// Removes `key`; false if there is none. The order of the others stays.
  bool erase(std::string_view key);
  void clear() noexcept;
  /// Whether the entries are in order of their keys (byte by byte).
  bool is_sorted() const;
  /// The same entries in this order.
  Dict sorted() const;
  /// Freezes every key and value.
  void freeze();

  /// Same keys with equal values, in any order.
  bool operator==(const Dict& other) const noexcept;

 private:
  static constexpr std::size_t kIndexed = 12;  // entries from which on the index is kept
  const Value* find_text(std::string_view key) const noexcept;
  std::size_t position(std::string_view key) const noexcept;
  void rebuild();
  std::size_t probe(std::string_view key) const noexcept;

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> index_;  // open addressing, entry number + 1; size a power of two; empty while small
};

}  // namespace race
