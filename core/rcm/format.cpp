// The text of a document: small values take one line, so that a change of a model changes few lines.
#include <algorithm>

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

class Formatter {
 public:
  /// Appends `value`, which starts in column `column` of a line that is indented by `indent`.
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

  std::string take() { return std::move(text_) + "\n"; }

 private:
  void next(bool first, std::size_t indent) {
    text_ += first ? "\n" : ",\n";
    text_.append(indent, ' ');
  }

  void write_list(const List& items, std::size_t indent) {
    text_ += '[';
    for (const Value& item : items) {
      next(&item == &items.front(), indent + kIndent);
      write(item, indent + kIndent, indent + kIndent);
    }
    next(true, indent);
    text_ += ']';
  }

  void write_dict(const Dict& entries, std::size_t indent) {
    text_ += '{';
    bool first = true;
    for (const auto& [key, item] : entries) {
      next(first, indent + kIndent);
      first = false;
      const std::string label = to_json(key) + ": ";
      text_ += label;
      write(item, indent + kIndent, indent + kIndent + columns(label));
    }
    next(true, indent);
    text_ += '}';
  }

  std::string text_;
};

}  // namespace

std::string format_document(const Document& document) {
  Formatter formatter;
  formatter.write(write_document(document), 0, 0);
  return formatter.take();
}

}  // namespace race::rcm
