#include "core/rcm/ids.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace race::rcm {
namespace {

using Hash = std::uint64_t;

constexpr Hash kGolden = 0x9E3779B97F4A7C15U;
constexpr std::size_t kNewLength = 8, kDerivedLength = 13;  // characters, of 5 bits each

/// splitmix64 of `x`.
Hash mixed(Hash x) {
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

/// Of `text` after what `before` is the hash of: FNV-1a, mixed.
Hash hash(Hash before, std::string_view text) {
  Hash out = before ^ 0xCBF29CE484222325U;
  for (const char c : text) out = (out ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return mixed(out + kGolden);
}

/// The first bits of `bits` in base 32.
std::string digits(Hash bits, std::size_t length) {
  std::string out;
  for (std::size_t i = 0; i < length; ++i, bits <<= 5U) out += "abcdefghijklmnopqrstuvwxyz234567"[bits >> 59U];
  return out;
}

Hash node_hash(Hash parent, std::string_view name) { return hash(parent, name); }
Hash element_hash(Hash node, std::string_view kind, std::string_view name) { return hash(hash(node, kind), name); }
Hash library_hash() { return node_hash(0, "library"); }

/// Calls visit(meta, place) for each element of a document, in order; places are all different.
template <typename Visit>
class Walk {
 public:
  explicit Walk(Visit visit) : visit_(std::move(visit)) {}

  template <typename AnyDocument>
  void document(AnyDocument& document) {
    state(document.root, node_hash(0, document.root.name));
    for (auto& entry : document.library) state(entry, node_hash(library_hash(), entry.name));
  }

 private:
  template <typename AnyState>
  void state(AnyState& state, Hash at) {
    element(state.meta, element_hash(at, "state", ""));
    for (auto& parameter : state.parameters) element(parameter.meta, element_hash(at, "parameter", parameter.name));
    for (auto& result : state.results) element(result.meta, element_hash(at, "result", result.name));
    for (auto& variable : state.variables) element(variable.meta, element_hash(at, "variable", variable.name));
    for (auto& action : state.actions) element(action.meta, hash(element_hash(at, "action", action.when), action.code));
    for (auto& child : state.children) node(child, at);
    for (auto& port : state.ports) element(port.meta, element_hash(at, "port", port.name));
  }

  template <typename AnyNode>
  void node(AnyNode& node, Hash parent) {
    const Hash at = node_hash(parent, name_of(node));
    if (auto* inner = std::get_if<State>(&node)) return state(*inner, at);
    element(std::get<Barrier>(node).meta, element_hash(at, "barrier", ""));
  }

  template <typename AnyMeta>
  void element(AnyMeta& meta, Hash place) {
    const Hash earlier = count_[place]++;
    visit_(meta, earlier == 0 ? place : mixed(place + earlier));
  }

  Visit visit_;
  std::unordered_map<Hash, Hash> count_;
};

void set_id(Meta& meta, std::string id) {
  meta.id = std::move(id);
  if (meta.rest.is_dict() && !meta.rest.as_dict().empty()) return;
  meta.rest = meta.rest.is_dict() || meta.rest.is_null() ? Value() : Value(Dict{{"value", meta.rest}});
}

using IdsByPlace = std::unordered_map<Hash, std::string_view>;

/// Where the elements of a document stand and which ids they have.
struct Places {
  explicit Places(const Document& document) {
    Walk([this](const Meta& meta, Hash place) {
      if (meta.id.empty()) return;
      ids.emplace(place, meta.id);
      places.emplace(meta.id, place);
    }).document(document);
  }

  IdsByPlace ids;
  std::unordered_map<std::string_view, Hash> places;
};

/// The node or port with this path.
IdsByPlace::const_iterator element_at(std::string_view path, const IdsByPlace& ids) {
  const auto dot = path.rfind('.');
  Hash node = 0;
  for (std::string_view rest = path.substr(0, dot); !rest.empty();) {
    const auto slash = std::min(rest.find('/'), rest.size());
    node = node_hash(node, rest.substr(0, slash));
    rest.remove_prefix(std::min(slash + 1, rest.size()));
  }
  if (dot != std::string_view::npos) return ids.find(element_hash(node, "port", path.substr(dot + 1)));
  const auto state = ids.find(element_hash(node, "state", ""));
  return state != ids.end() ? state : ids.find(element_hash(node, "barrier", ""));
}

class Giver {
 public:
  explicit Giver(Document& document) {
    Walk([this](Meta& meta, Hash place) { elements_.push_back({&meta, place}); }).document(document);
  }

  void give(const Places* previous) {
    part_equals(previous);
    if (previous) take_over(*previous);
    for (const Element& element : elements_) {
      if (element.meta->id.empty()) make(element, previous);
    }
  }

  /// `layout` with ids in place of paths.
  Dict by_ids(const Dict& layout) const {
    IdsByPlace ids;
    for (const Element& element : elements_) ids.emplace(element.place, element.meta->id);
    Dict out;
    for (const auto& [key, value] : layout) {
      const auto id = holders_.contains(key.as_string()) ? ids.cend() : element_at(key.as_string(), ids);
      if (id != ids.cend()) {
        out.set(id->second, value);  // also in place of the id's own entry: who writes paths has written last
      } else if (!out.find(key)) {
        out.set(key, value);
      }
    }
    return out;
  }

 private:
  struct Element {
    Meta* meta;
    Hash place;
  };

  /// Of the elements with one id, one keeps it.
  void part_equals(const Places* previous) {
    for (const Element& element : elements_) {
      if (element.meta->id.empty()) continue;
      const auto [entry, is_first] = holders_.emplace(element.meta->id, element);
      if (is_first) continue;
      const Element loser =
          previous && stands_where_it_stood(element, *previous) ? std::exchange(entry->second, element) : element;
      loser.meta->id.clear();
    }
  }

  static bool stands_where_it_stood(const Element& element, const Places& previous) {
    const auto stood = previous.places.find(element.meta->id);
    return stood != previous.places.end() && stood->second == element.place;
  }

  void take_over(const Places& previous) {
    for (const Element& element : elements_) {
      if (!element.meta->id.empty()) continue;
      const auto id = previous.ids.find(element.place);
      if (id != previous.ids.end()) claim(element, std::string(id->second));
    }
  }

  void make(const Element& element, const Places* previous) {
    for (Hash attempt = 0; element.meta->id.empty(); ++attempt) {
      std::string id = digits(mixed(element.place + attempt * kGolden), kNewLength);
      if (!previous || !previous->places.contains(id)) claim(element, std::move(id));
    }
  }

  void claim(const Element& element, std::string id) {
    if (holders_.emplace(id, element).second) set_id(*element.meta, std::move(id));
  }

  std::vector<Element> elements_;
  std::unordered_map<std::string, Element> holders_;  // of each id of the document
};

}  // namespace

bool is_id(std::string_view text) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= 64 && std::ranges::all_of(text, allowed);
}

void give_ids(Document& document, const Document* previous) {
  std::optional<Places> places;
  if (previous) places.emplace(*previous);
  Giver giver(document);
  giver.give(places ? &*places : nullptr);
  if (document.layout.is_dict()) document.layout = giver.by_ids(document.layout.as_dict());
}

std::string derived_id(std::string_view owner, std::string_view part) {
  if (owner.empty() || part.empty()) return {};
  return digits(hash(hash(0, owner), part), kDerivedLength);
}

}  // namespace race::rcm
