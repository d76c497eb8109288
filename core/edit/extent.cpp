#include "core/edit/extent.h"

#include <algorithm>

#include "core/rcm/document.h"
#include "core/value/json.h"

namespace race::edit {
namespace {

// What a character and a line may cost: `\u0000`; indentation, quotes, commas and the name of a field. Texts with more
// levels are not indented.
constexpr std::size_t kCharacter = 6, kLine = 2 * JsonLimits{}.depth + 24;

class Bound {
 public:
  std::size_t bytes() const { return bytes_; }

  void add(std::string_view text) { bytes_ += kCharacter * text.size() + kLine; }
  void add(const std::string& text) { add(std::string_view(text)); }
  void add(const Value& value) {
    bytes_ += 2 * kLine;  // with the bracket that ends it
    if (value.is_string()) add(value.as_string());
    if (value.is_list()) {
      for (const Value& item : value.as_list()) add(item);
    } else if (value.is_dict()) {
      for (const auto& [key, item] : value.as_dict()) {
        add(key.as_string());
        add(item);
      }
    }
  }
  template <typename T>
  void add(const std::optional<T>& part) {
    if (part) add(*part);
  }
  void add(const std::vector<std::string>& texts) {
    bytes_ += 2 * kLine;
    for (const std::string& text : texts) add(text);
  }
  void add(const rcm::Meta& meta) {
    add(meta.id);
    add(meta.rest);
  }
  void add(const rcm::Keep& keep) { add(keep.ports); }
  void add(const rcm::Oracle& oracle) {
    add(oracle.text);
    add(oracle.resume);
  }
  void add(const rcm::State& s) {
    constexpr std::size_t kListBrackets = 12;
    bytes_ += kListBrackets * kLine;
    add_all(s.name, s.doc, s.entry, s.exit, s.first, s.keep, s.link, s.oracle, s.meta);
  }
  void add(const rcm::Barrier& b) { add_all(b.name, b.to, b.meta); }
  void add(const rcm::Parameter& p) { add_all(p.name, p.value, p.from, p.type, p.unit, p.doc, p.meta); }
  void add(const rcm::Datum& d) { add_all(d.name, d.initial, d.type, d.unit, d.doc, d.meta); }
  void add(const rcm::Action& a) { add_all(a.when, a.code, a.meta); }
  void add(const rcm::Port& p) { add_all(p.name, p.when, p.after, p.to, p.meta); }

 private:
  template <typename... Parts>
  void add_all(const Parts&... parts) {
    (add(parts), ...);
    bytes_ += 2 * kLine;
  }

  std::size_t bytes_ = 0;
};

Expected<std::size_t> size_of_file(const rcm::Document& document) {
  ASSIGN_OR_RETURN(const std::string text, rcm::write_document_text(document));
  return text.size();
}

Expected<std::size_t> size_on_one_line(const rcm::Document& document, std::size_t limit) {
  const std::size_t bytes = to_json(rcm::write_document(document)).size();
  if (bytes <= limit) return bytes;
  return unexpected(ErrorCode::too_large,
                    "the text of the document would have more than " + std::to_string(limit) + " bytes");
}

}  // namespace

std::size_t text_bound(const Content& content) {
  Bound bound;
  std::visit([&](const auto& element) { bound.add(element); }, content);
  return bound.bytes();
}

std::size_t text_bound(std::string_view key, const Value& value) {
  Bound bound;
  bound.add(key);
  bound.add(value);
  return bound.bytes();
}

Expected<void> check_extent(Tree& tree) {
  if (tree.text_bound() <= tree.one_line().value_or(JsonLimits{}).bytes) return {};
  auto size =
      tree.one_line() ? size_on_one_line(tree.document(), tree.one_line()->bytes) : size_of_file(tree.document());
  if (!size) return unexpected(size.error().code, size.error().message, "operations");
  tree.set_text_bound(*size);
  return {};
}

}  // namespace race::edit
