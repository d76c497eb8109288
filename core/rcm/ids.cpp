#include "core/rcm/ids.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
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

// Where paths begin: that of the root and those of the library.
constexpr Hash kRoot = 0, kLibrary = 1;

Hash node_hash(Hash parent, std::string_view name) { return hash(parent, name); }
Hash element_hash(Hash node, std::string_view kind, std::string_view name) { return hash(hash(node, kind), name); }
/// Of an action, which has two texts and no name: apart from elements of a node called `action`.
Hash action_hash(Hash node, const Action& action) {
  return hash(~element_hash(node, "action", action.when), action.code);
}

/// Where an element stands, and the state that it belongs to, or the parent of the node that it is.
struct Place {
  Hash element, owner;
};

/// Calls visit(meta, place) for each element of a document, in order; elements are all different, but for chance.
template <typename Visit>
class Walk {
 public:
  explicit Walk(Visit visit) : visit_(std::move(visit)) {}

  template <typename AnyDocument>
  void document(AnyDocument& document) {
    state(document.root, kRoot);
    for (auto& entry : document.library) state(entry, kLibrary);
  }

 private:
  template <typename AnyState>
  void state(AnyState& state, Hash parent) {
    const Hash at = node_hash(parent, state.name);
    element(state.meta, element_hash(at, "state", ""), parent);
    for (auto& parameter : state.parameters) element(parameter.meta, element_hash(at, "parameter", parameter.name), at);
    for (auto& result : state.results) element(result.meta, element_hash(at, "result", result.name), at);
    for (auto& variable : state.variables) element(variable.meta, element_hash(at, "variable", variable.name), at);
    for (auto& action : state.actions) element(action.meta, action_hash(at, action), at);
    for (auto& child : state.children) node(child, at);
    for (auto& port : state.ports) element(port.meta, element_hash(at, "port", port.name), at);
  }

  template <typename AnyNode>
  void node(AnyNode& node, Hash parent) {
    if (auto* inner = std::get_if<State>(&node)) return state(*inner, parent);
    auto& barrier = std::get<Barrier>(node);
    element(barrier.meta, element_hash(node_hash(parent, barrier.name), "barrier", ""), parent);
  }

  template <typename AnyMeta>
  void element(AnyMeta& meta, Hash place, Hash owner) {
    const Hash earlier = count_[place]++;
    visit_(meta, Place{earlier == 0 ? place : mixed(place + earlier), owner});
  }

  Visit visit_;
  std::map<Hash, Hash> count_;  // a hash table would be slow for texts made to collide: the hash is no secret
};

void set_id(Meta& meta, std::string id) {
  meta.id = std::move(id);
  wrap_rest(meta);
}

using IdsByPlace = std::map<Hash, std::string_view>;

/// Where the elements of a document stand and which ids they have.
struct Places {
  explicit Places(const Document& document) {
    Walk([this](const Meta& meta, Place place) {
      if (meta.id.empty()) return;
      ids.emplace(place.element, meta.id);
      places.emplace(meta.id, place);
    }).document(document);
  }

  IdsByPlace ids;
  std::map<std::string_view, Place> places;
};

/// The node or port with this path below `start`.
IdsByPlace::const_iterator element_below(Hash start, std::string_view path, const IdsByPlace& ids) {
  const auto dot = path.rfind('.');
  Hash node = start;
  for (std::string_view rest = path.substr(0, dot); !rest.empty();) {
    const auto slash = std::min(rest.find('/'), rest.size());
    node = node_hash(node, rest.substr(0, slash));
    rest.remove_prefix(std::min(slash + 1, rest.size()));
  }
  if (dot != std::string_view::npos) return ids.find(element_hash(node, "port", path.substr(dot + 1)));
  const auto state = ids.find(element_hash(node, "state", ""));
  return state != ids.end() ? state : ids.find(element_hash(node, "barrier", ""));
}

/// The node or port with this path; of the root, if it is called `library`, before one of the library.
IdsByPlace::const_iterator element_at(std::string_view path, const IdsByPlace& ids) {
  constexpr std::string_view kPrefix = "library/";
  const auto element = element_below(kRoot, path, ids);
  if (element != ids.end() || !path.starts_with(kPrefix)) return element;
  return element_below(kLibrary, path.substr(kPrefix.size()), ids);
}

/// The ids by which `layout` and the notes of the document name elements, also elements that are gone.
std::set<std::string_view> named_ids(const Document& document) {
  std::set<std::string_view> out;
  for (const Value* entries : {&document.layout, document.meta.find("notes")}) {
    if (!entries || !entries->is_dict()) continue;
    for (const auto& [key, value] : entries->as_dict()) out.insert(key.as_string());
  }
  return out;
}

class IdAssigner {
 public:
  explicit IdAssigner(Document& document) : named_(named_ids(document)) {
    Walk([this](Meta& meta, Place place) { elements_.push_back({&meta, place}); }).document(document);
  }

  void assign(const Places* previous) {
    resolve_duplicates(previous);
    if (previous) take_over(*previous);
    for (const Element& element : elements_) {
      if (element.meta->id.empty()) make(element, previous);
    }
  }

  /// `layout` with ids in place of paths.
  Dict by_ids(const Dict& layout) const {
    IdsByPlace ids;
    for (const Element& element : elements_) ids.emplace(element.place.element, element.meta->id);
    Dict out;
    for (const auto& [key, value] : layout) {
      const auto id = owners_.contains(key.as_string()) ? ids.cend() : element_at(key.as_string(), ids);
      if (id == ids.cend()) {
        out.set(key, value);
      } else if (!layout.find(id->second)) {
        out.set(id->second, value);
      }
    }
    return out;
  }

 private:
  struct Element {
    Meta* meta;
    Place place;
  };

  /// Of the elements with one id, one keeps it.
  void resolve_duplicates(const Places* previous) {
    for (const Element& element : elements_) {
      if (element.meta->id.empty()) continue;
      const auto [entry, is_first] = owners_.emplace(element.meta->id, element);
      if (is_first) continue;
      const bool is_better = previous && rank(element, *previous) > rank(entry->second, *previous);
      const Element loser = is_better ? std::exchange(entry->second, element) : element;
      loser.meta->id.clear();
    }
  }

  /// 2: it stands where the element with its id stood; 1: its state or parent does; 0: neither.
  static int rank(const Element& element, const Places& previous) {
    const auto stood = previous.places.find(element.meta->id);
    if (stood == previous.places.end()) return 0;
    if (stood->second.element == element.place.element) return 2;
    return stood->second.owner == element.place.owner ? 1 : 0;
  }

  void take_over(const Places& previous) {
    for (const Element& element : elements_) {
      if (!element.meta->id.empty()) continue;
      const auto id = previous.ids.find(element.place.element);
      if (id != previous.ids.end()) try_assign(element, std::string(id->second));
    }
  }

  void make(const Element& element, const Places* previous) {
    for (Hash attempt = 0; element.meta->id.empty(); ++attempt) {
      std::string id = digits(mixed(element.place.element + attempt * kGolden), kNewLength);
      if (named_.contains(id) || (previous && previous->places.contains(id))) continue;
      try_assign(element, std::move(id));
    }
  }

  void try_assign(const Element& element, std::string id) {
    if (owners_.emplace(id, element).second) set_id(*element.meta, std::move(id));
  }

  std::vector<Element> elements_;
  std::map<std::string, Element, std::less<>> owners_;  // of each id of the document
  const std::set<std::string_view> named_;
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
  IdAssigner ids(document);
  ids.assign(places ? &*places : nullptr);
  if (document.layout.is_dict()) document.layout = ids.by_ids(document.layout.as_dict());
}

void wrap_rest(Meta& meta) {
  if (meta.id.empty() || meta.rest.is_null()) return;
  if (!meta.rest.is_dict()) meta.rest = Dict{{"value", meta.rest}};
  if (meta.rest.as_dict().empty()) meta.rest = Value();
}

std::string derived_id(std::string_view owner, std::string_view part) {
  if (owner.empty() || part.empty()) return {};
  return digits(hash(hash(0, owner), part), kDerivedLength);
}

DerivedIds::DerivedIds(const Document& document) {
  Walk([this](const Meta& meta, Place) {
    if (!meta.id.empty()) taken_.insert(meta.id);
  }).document(document);
}

std::string DerivedIds::operator()(std::string_view owner, std::string_view part) {
  const std::string first = derived_id(owner, part);
  if (!taken_.contains(first)) return first;
  std::string& id = replacements_[first];
  for (int attempt = 1; id.empty() || taken_.contains(id); ++attempt)
    id = derived_id(first, ":" + std::to_string(attempt));
  return id;
}

}  // namespace race::rcm
