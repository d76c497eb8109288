// The text of a document: an edit of one element changes the lines of that element alone, so that two people's edits of
// a file merge as texts.
#include <algorithm>
#include <map>

#include "core/rcm/document.h"
#include "core/value/json.h"

namespace race::rcm {
namespace {

constexpr std::size_t kColumns = 120;
constexpr std::size_t kIndent = 2;
constexpr int kLevelsOnOneLine = 2;

/// The levels of lists and objects in `value`: 0 for a scalar. Counts no further than `limit`.
int levels(const Value& value, int limit) {
  int inner = -1;
  if (value.is_list()) {
    inner = 0;
    for (const Value& item : value.as_list()) {
      if (inner < limit) inner = std::max(inner, levels(item, limit - 1));
    }
  } else if (value.is_dict()) {
    inner = 0;
    for (const auto& [key, item] : value.as_dict()) {
      if (inner < limit) inner = std::max(inner, levels(item, limit - 1));
    }
  }
  return inner + 1;
}

/// Characters, not bytes.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string one_line(const Value& value) {
  std::string out;
  if (value.is_list()) {
    for (const Value& item : value.as_list()) out += (out.empty() ? "" : ", ") + one_line(item);
    return "[" + out + "]";
  }
  if (value.is_dict()) {
    for (const auto& [key, item] : value.as_dict())
      out += (out.empty() ? "" : ", ") + to_json(key) + ": " + one_line(item);
    return "{" + out + "}";
  }
  return to_json(value);
}

/// Whether the field `key` of a document or a state is a list of elements, each of which has its own lines.
bool holds_elements(std::string_view key) {
  static constexpr std::string_view kLists[] = {"library", "parameters", "results", "variables",
                                                "actions", "children",   "ports"};
  return std::ranges::find(kLists, key) != std::end(kLists);
}

/// Stops soon after `limit` bytes.
class Formatter {
 public:
  explicit Formatter(std::size_t limit = std::string::npos) : limit_(limit) {}

  void write_document(const Dict& document) {
    write_fields(document, 0, [&](std::string_view key, const Value& field, std::size_t column) {
      if (key == "root") return write_state(field.as_dict(), kIndent);
      if ((key == "services" || key == "layout") && field.is_dict()) return write_entries(field.as_dict(), kIndent);
      if (key == "meta" && field.is_dict()) return write_meta(field.as_dict(), kIndent);
      write_field(key, field, kIndent, column);
    });
  }

  std::string take() { return std::move(text_) + "\n"; }

 private:
  /// Always on several lines.
  void write_state(const Dict& state, std::size_t indent) {
    write_fields(state, indent, [&](std::string_view key, const Value& field, std::size_t column) {
      write_field(key, field, indent + kIndent, column);
    });
  }

  void write_field(std::string_view key, const Value& field, std::size_t indent, std::size_t column) {
    holds_elements(key) ? write_elements(field.as_list(), indent) : write(field, indent, column);
  }

  void write_elements(const List& elements, std::size_t indent) {
    text_ += '[';
    for (const Value& element : elements) {
      if (is_full()) return;
      next(&element == &elements.front(), indent + kIndent);
      element.find("state") ? write_state(element.as_dict(), indent + kIndent)
                            : write(element, indent + kIndent, indent + kIndent);
    }
    next(true, indent);
    text_ += ']';
  }

  /// The meta of the document.
  void write_meta(const Dict& meta, std::size_t indent) {
    write_fields(meta, indent, [&](std::string_view key, const Value& field, std::size_t column) {
      key == "notes" && field.is_dict() ? write_entries(field.as_dict(), indent + kIndent)
                                        : write(field, indent + kIndent, column);
    });
  }

  /// In order of the keys, each on one line.
  void write_entries(const Dict& entries, std::size_t indent) {
    std::map<std::string_view, const Value*> sorted;
    for (const auto& [key, entry] : entries) sorted.emplace(key.as_string(), &entry);
    Dict ordered;
    for (const auto& [key, entry] : sorted) ordered.set(key, *entry);
    write_fields(ordered, indent, [&](std::string_view, const Value& entry, std::size_t) { text_ += one_line(entry); });
  }

  /// Any JSON, which starts in column `column` of a line that is indented by `indent`.
  void write(const Value& value, std::size_t indent, std::size_t column) {
    const int depth = levels(value, kLevelsOnOneLine);
    if (depth <= kLevelsOnOneLine) {
      const std::string line = one_line(value);
      if (depth == 0 || column + columns(line) + 1 <= kColumns) {
        text_ += line;
        return;
      }
    }
    value.is_list() ? write_list(value.as_list(), indent) : write_dict(value.as_dict(), indent);
  }

  bool is_full() const { return text_.size() > limit_; }

  void next(bool first, std::size_t indent) {
    text_ += first ? "\n" : ",\n";
    text_.append(indent, ' ');
  }

  void write_list(const List& items, std::size_t indent) {
    text_ += '[';
    for (const Value& item : items) {
      if (is_full()) return;
      next(&item == &items.front(), indent + kIndent);
      write(item, indent + kIndent, indent + kIndent);
    }
    next(true, indent);
    text_ += ']';
  }

  void write_dict(const Dict& entries, std::size_t indent) {
    write_fields(entries, indent, [&](std::string_view, const Value& entry, std::size_t column) {
      write(entry, indent + kIndent, column);
    });
  }

  /// An object on several lines; `write_one` writes a field, given its key, its value and the column where it starts.
  template <typename WriteOne>
  void write_fields(const Dict& fields, std::size_t indent, WriteOne write_one) {
    text_ += '{';
    bool first = true;
    for (const auto& [key, field] : fields) {
      if (is_full()) return;
      next(first, indent + kIndent);
      first = false;
      const std::string label = to_json(key) + ": ";
      text_ += label;
      write_one(key.as_string(), field, indent + kIndent + columns(label));
    }
    if (!first) next(true, indent);
    text_ += '}';
  }

  const std::size_t limit_;
  std::string text_;
};

}  // namespace

std::string format_document(const Document& document) {
  Formatter formatter;
  formatter.write_document(write_document(document).as_dict());
  return formatter.take();
}

Expected<std::string> write_document_text(const Document& document) {
  const JsonLimits limits{.keep_out_of_range = true};
  Formatter formatter(limits.bytes);
  formatter.write_document(write_document(document).as_dict());
  std::string text = formatter.take();
  if (auto again = parse_json(text, limits); !again) return tl::unexpected(std::move(again).error());
  return text;
}

}  // namespace race::rcm
