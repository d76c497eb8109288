#include "core/language/syntax/source.h"

#include "core/language/primitives/utf8.h"

namespace race::language {

SourceRange range_of(std::string_view text, Span span) {
  const auto position = [&](std::size_t offset, int& line, int& column) {
    const std::string_view before = text.substr(0, offset);
    line = 1;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i] == '\n') {
        ++line;
        begin = i + 1;
      }
    column = 1 + static_cast<int>(utf8::length(before.substr(begin)));
  };
  SourceRange range;
  position(span.begin, range.line, range.column);
  position(span.end, range.end_line, range.end_column);
  return range;
}

}  // namespace race::language
