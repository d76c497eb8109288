// Writing documents: the JSON of an element, as a value.
#include "core/rcm/document.h"
#include "core/rcm/fields_internal.h"

namespace race::rcm {
namespace {

template <typename Element>
Value json_of(const Element& element);

Value json_of(const std::string& text) { return text; }
Value json_of(const Value& json) { return json; }
Value json_of(const Meta& meta) { return meta_json(meta); }
Value json_of(const Node& node) {
  return std::visit([](const auto& element) { return json_of(element); }, node);
}

Value json_of(const std::map<std::string, std::string>& services) {
  Dict out;
  for (const auto& [key, type] : services) out.set(std::string_view(key), type);
  return out;
}

template <typename Element>
Value json_of(const std::vector<Element>& elements) {
  List out;
  out.reserve(elements.size());
  for (const Element& element : elements) out.push_back(json_of(element));
  return out;
}

template <typename Element>
Value json_of(const Element& element) {
  Dict out;
  const auto set = [&](std::string_view key, const auto& field) { out.set(key, json_of(field)); };
  for_each_field(element, set);
  return out;
}

}  // namespace

Value write_state(const State& state) { return json_of(state); }

Value write_document(const Document& document) { return json_of(document); }

}  // namespace race::rcm
