#include "core/edit/extent.h"

#include <algorithm>

#include "core/rcm/document.h"
#include "core/value/json.h"

namespace race::edit {
namespace {

// What a character and a line may cost: `\u0000`; quotes, commas and the name of a field.
constexpr std::size_t kCharacter = 6, kLine = 24;
constexpr std::size_t kDeepestLine = 2 * JsonLimits{}.depth + kLine;

/// At most as much as the text has, if no line of fields is indented by more than `indent`.
class UpperBound {
 public:
  explicit UpperBound(std::size_t indent) : line_(indent + kLine) {}

  std::size_t bytes() const { return bytes_; }

  void add(std::string_view text) { bytes_ += kCharacter * text.size() + line_; }
  void add(const std::string& text) { add(std::string_view(text)); }
  void add(const Value& value) { bytes_ += (kCharacter + kDeepestLine) * value.size_units(); }
  template <typename T>
  void add(const std::optional<T>& part) {
    if (part) add(*part);
  }
  void add(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) bytes_ += kCharacter * text.size() + kDeepestLine;
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
  void add(const rcm::State& s) { add_all(s.name, s.doc, s.entry, s.exit, s.first, s.keep, s.link, s.oracle, s.meta); }
  void add(const rcm::Barrier& b) { add_all(b.name, b.to, b.meta); }
  void add(const rcm::Parameter& p) { add_all(p.name, p.value, p.from, p.type, p.unit, p.doc, p.meta); }
  void add(const rcm::Datum& d) { add_all(d.name, d.initial, d.type, d.unit, d.doc, d.meta); }
  void add(const rcm::Action& a) { add_all(a.when, a.code, a.meta); }
  void add(const rcm::Port& p) { add_all(p.name, p.when, p.to, p.meta); }
  void add(const Content& content) {
    std::visit([this](const auto& element) { add(element); }, content);
    bytes_ += kBrackets * line_;
  }

 private:
  static constexpr std::size_t kBrackets = 14;  // of an element, and of six lists

  template <typename... Parts>
  void add_all(const Parts&... parts) {
    (add(parts), ...);
  }

  std::size_t line_, bytes_ = 0;
};

std::size_t upper_bound(const Tree& tree) {
  std::size_t level = 0;
  tree.for_each([&](const Element&, std::size_t at) { level = std::max(level, at); });
  UpperBound out(2 * (level + 2));
  tree.for_each([&](const Element& element, std::size_t) { out.add(element.content); });
  out.add(tree.fields().name);
  out.add(tree.fields().layout);
  out.add(tree.fields().meta);
  for (const auto& [key, type] : tree.fields().services) {
    out.add(key);
    out.add(type);
  }
  return out.bytes();
}

}  // namespace

Expected<void> check_extent(const Tree& tree) {
  if (upper_bound(tree) <= JsonLimits{}.bytes) return {};
  auto text = rcm::write_document_text(tree.document());
  if (!text) return unexpected(text.error().code, text.error().message, "operations");
  return {};
}

}  // namespace race::edit
