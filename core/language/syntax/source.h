// Source: ranges of a code text. Spans count bytes; positions for people count lines and code points.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/value/expected.h"

namespace race::language {

/// Bytes [begin, end) of a code text.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// The lines and columns (in code points, from 1) of a span of `text`.
SourceRange range_of(std::string_view text, Span span);

/// The piece of `text`.
inline std::string_view slice(std::string_view text, Span span) {
  return text.substr(span.begin, span.end - span.begin);
}

}  // namespace race::language
