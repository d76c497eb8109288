// The text of a document: an edit of one element changes the lines of that element alone, so that two people's edits of
// a file merge as texts.
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/language/primitives/utf8.h"
#include "core/rcm/document.h"
#include "core/rcm/fields_internal.h"
#include "core/value/json.h"

namespace race::rcm {
namespace {

constexpr std::size_t kColumns = 120;
constexpr std::size_t kIndent = 2;
constexpr int kLevelsOnOneLine = 2;
constexpr std::size_t kMaxCharacter = 4;  // bytes

bool is_container(const Value& value) { return value.is_list() || value.is_dict(); }

/// Stops soon after `limit` bytes.
class Formatter {
 public:
  explicit Formatter(std::size_t limit = std::string::npos) : limit_(limit) {}

  void write_document(const Document& document) {
    write_fields(document, 0, [&](std::string_view key, const auto& field, std::size_t column) {
      using Field = std::remove_cvref_t<decltype(field)>;
      if constexpr (std::is_same_v<Field, Value>) {
        if (key == "layout" && field.is_dict()) return write_entries(field.as_dict(), kIndent);
        if (key == "meta" && field.is_dict()) return write_document_meta(field.as_dict(), kIndent);
      }
      write(field, kIndent, column);
    });
    text_ += '\n';
  }

  std::string take() { return std::move(text_); }
  /// How many levels of lists and objects the text has.
  std::size_t depth() const { return depth_; }
  /// Whether a number was written that JSON does not have.
  bool has_no_json() const { return has_no_json_; }

 private:
  /// A list or object that is being written.
  class Level {
   public:
    explicit Level(Formatter& of) : of_(of) { of.depth_ = std::max(of.depth_, ++of.level_); }
    ~Level() { --of_.level_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Formatter& of_;
  };

  // On one line. Each returns false, at the latest at its end, if `field` has more than `levels` levels of lists and
  // objects or the text reaches line_end_.
  bool fits(std::size_t more = 0) const { return text_.size() + more <= line_end_; }

  bool line(const std::string& text, int) {
    if (!fits(text.size())) return false;
    append_json_string(text, text_);
    return true;
  }

  bool line(const Value& value, int levels) {
    if (value.is_string()) return line(value.as_string(), levels);
    if (!is_container(value)) return scalar(value), true;
    if (levels == 0) return false;
    const Level level(*this);
    const char* separator = value.is_list() ? "[" : "{";
    if (value.is_list()) {
      for (const Value& item : value.as_list()) {
        text_ += std::exchange(separator, ", ");
        if (!line(item, levels - 1) || !fits()) return false;
      }
    } else {
      for (const auto& [key, item] : value.as_dict()) {
        text_ += std::exchange(separator, ", ");
        label(key.as_string());
        if (!line(item, levels - 1) || !fits()) return false;
      }
    }
    if (*separator != ',') text_ += separator;
    text_ += value.is_list() ? ']' : '}';
    return true;
  }

  bool line(const std::vector<std::string>& texts, int levels) {
    if (levels == 0) return false;
    const Level level(*this);
    text_ += '[';
    for (const std::string& text : texts) {
      if (&text != &texts.front()) text_ += ", ";
      if (!line(text, levels - 1)) return false;
    }
    text_ += ']';
    return true;
  }

  bool line(const Meta& meta, int levels) {
    if (meta.id.empty() || !meta.rest.is_null()) return line(meta_json(meta), levels);
    if (levels == 0) return false;
    const Level level(*this);
    text_ += "{\"id\": ";
    const bool is_short = line(meta.id, levels - 1);
    text_ += '}';
    return is_short;
  }

  /// An oracle or an element that is no state.
  template <typename Element>
  bool line(const Element& element, int levels) {
    if (levels == 0) return false;
    const Level level(*this);
    bool is_short = true;
    const char* separator = "{\"";
    const auto visit = [&](std::string_view key, const auto& field) {
      if (!is_short) return;
      text_ += std::exchange(separator, ", \"");
      text_ += key;
      text_ += "\": ";
      is_short = line(field, levels - 1) && fits();
    };
    for_each_field(element, visit);
    text_ += '}';
    return is_short;
  }

  // A field that starts in column `column` of a line that is indented by `indent`.

  void write(const std::string& text, std::size_t, std::size_t) { append_json_string(text, text_); }

  void write(const Value& value, std::size_t indent, std::size_t column) {
    if (!is_container(value)) return scalar(value);
    if (!write_line(value, column)) value.is_list() ? write_list(value.as_list(), indent) : write_dict(value, indent);
  }

  void write(const std::vector<std::string>& texts, std::size_t indent, std::size_t column) {
    if (!write_line(texts, column)) write_list(texts, indent);
  }

  void write(const Meta& meta, std::size_t indent, std::size_t column) {
    if (!write_line(meta, column)) write(meta_json(meta), indent, column);
  }

  void write(const State& state, std::size_t indent, std::size_t) { write_fields(state, indent); }

  void write(const Node& node, std::size_t indent, std::size_t column) {
    std::visit([&](const auto& element) { write(element, indent, column); }, node);
  }

  void write(const std::map<std::string, std::string>& entries, std::size_t indent, std::size_t) {
    const Level level(*this);
    const char* separator = "{";
    for (const auto& [key, text] : entries) {
      text_ += std::exchange(separator, ",");
      new_line(indent + kIndent);
      label(key);
      append_json_string(text, text_);
    }
    new_line(indent);
    text_ += '}';
  }

  /// Elements, each of which has its own lines.
  template <typename Element>
  void write(const std::vector<Element>& elements, std::size_t indent, std::size_t) {
    write_list(elements, indent);
  }

  /// An oracle or an element that is no state.
  template <typename Element>
  void write(const Element& element, std::size_t indent, std::size_t column) {
    if (!write_line(element, column)) write_fields(element, indent);
  }

  /// False, and nothing is written, if `field` does not go into one line.
  template <typename Field>
  bool write_line(const Field& field, std::size_t column) {
    const std::size_t start = text_.size();
    line_end_ = start + kMaxCharacter * kColumns;
    if (line(field, kLevelsOnOneLine)) {
      const std::string_view written = std::string_view(text_).substr(start);
      const std::size_t left = kColumns - std::min(column + 1, kColumns);
      // Counting is needed only where characters are fewer than bytes.
      if (column < kColumns && (written.size() <= left || language::utf8::length(written) <= left)) return true;
    }
    text_.resize(start);
    return false;
  }

  /// On several lines.
  template <typename Item>
  void write_list(const std::vector<Item>& items, std::size_t indent) {
    const Level level(*this);
    text_ += '[';
    for (const Item& item : items) {
      if (is_full()) return;
      if (&item != &items.front()) text_ += ',';
      new_line(indent + kIndent);
      write(item, indent + kIndent, indent + kIndent);
    }
    new_line(indent);
    text_ += ']';
  }

  void write_dict(const Value& dict, std::size_t indent) {
    write_dict(dict.as_dict(), indent, [&](std::string_view, const Value& entry, std::size_t column) {
      write(entry, indent + kIndent, column);
    });
  }

  /// An object on several lines; write_one(key, entry, column) writes an entry, which starts in this column.
  template <typename WriteOne>
  void write_dict(const Dict& entries, std::size_t indent, WriteOne write_one) {
    const Level level(*this);
    const char* separator = "{";
    for (const auto& [key, entry] : entries) {
      if (is_full()) return;
      text_ += std::exchange(separator, ",");
      new_line(indent + kIndent);
      const std::size_t start = text_.size();
      label(key.as_string());
      const std::size_t columns = language::utf8::length(std::string_view(text_).substr(start));
      write_one(key.as_string(), entry, indent + kIndent + columns);
    }
    if (*separator == ',') {
      new_line(indent);
    } else {
      text_ += separator;
    }
    text_ += '}';
  }

  /// The same for an element or the document.
  template <typename Element, typename WriteOne>
  void write_fields(const Element& element, std::size_t indent, WriteOne write_one) {
    const Level level(*this);
    const char* separator = "{";
    const auto visit = [&](std::string_view key, const auto& field) {
      if (is_full()) return;
      text_ += std::exchange(separator, ",");
      new_line(indent + kIndent);
      label(key);
      constexpr std::size_t kMarks = 4;  // quotes, colon, space
      write_one(key, field, indent + kIndent + key.size() + kMarks);
    };
    for_each_field(element, visit);
    new_line(indent);
    text_ += '}';
  }

  template <typename Element>
  void write_fields(const Element& element, std::size_t indent) {
    write_fields(element, indent, [&](std::string_view, const auto& field, std::size_t column) {
      write(field, indent + kIndent, column);
    });
  }

  void write_document_meta(const Dict& meta, std::size_t indent) {
    write_dict(meta, indent, [&](std::string_view key, const Value& entry, std::size_t column) {
      key == "notes" && entry.is_dict() ? write_entries(entry.as_dict(), indent + kIndent)
                                        : write(entry, indent + kIndent, column);
    });
  }

  /// Each on one line.
  void write_entries(const Dict& entries, std::size_t indent) {
    write_dict(entries, indent, [&](std::string_view, const Value& entry, std::size_t) {
      line_end_ = std::string::npos;
      line(entry, std::numeric_limits<int>::max());
    });
  }

  void label(std::string_view key) {
    append_json_string(key, text_);
    text_ += ": ";
  }

  void scalar(const Value& value) {
    if (value.is_number() && !std::isfinite(value.as_number())) has_no_json_ = true;
    append_json(value, text_);
  }

  bool is_full() const { return text_.size() > limit_; }

  void new_line(std::size_t indent) {
    text_ += '\n';
    text_.append(indent, ' ');
  }

  const std::size_t limit_;
  std::string text_;
  std::size_t line_end_ = 0;
  std::size_t level_ = 0, depth_ = 0;
  bool has_no_json_ = false;
};

}  // namespace

std::string format_document(const Document& document) {
  Formatter formatter;
  formatter.write_document(document);
  return formatter.take();
}

Expected<std::string> write_document_text(const Document& document) {
  const JsonLimits limits{.keep_out_of_range = true};
  Formatter formatter(limits.bytes);
  formatter.write_document(document);
  const bool has_depth = formatter.depth() <= limits.depth && !formatter.has_no_json();
  std::string text = formatter.take();
  if (has_depth && text.size() <= limits.bytes && language::utf8::valid(text)) return text;
  auto again = parse_json(text, limits);  // which says why
  if (!again) return tl::unexpected(std::move(again).error());
  return text;
}

}  // namespace race::rcm
