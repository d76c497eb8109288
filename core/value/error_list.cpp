#include "core/value/error_list.h"

#include <string>
#include <utility>

namespace race {
namespace {

/// To kMaxErrorBytes, without the part of a character (UTF-8) at the end.
void cut(std::string& text) {
  if (text.size() <= kMaxErrorBytes) return;
  std::size_t end = kMaxErrorBytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  text.resize(end);
  text.shrink_to_fit();
}

}  // namespace

void add_error(std::vector<Error>& errors, Error error) {
  if (is_full(errors)) return;
  cut(error.path);
  cut(error.message);
  errors.push_back(std::move(error));
}

}  // namespace race
