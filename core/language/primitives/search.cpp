#include "core/language/primitives/search.h"

#include <cstring>

namespace race::language {

// glibc's memmem() is linear: a shift by hashed pairs for up to 256 bytes, else the two-way algorithm (Crochemore and
// Perrin, "Two-way string-matching", Journal of the ACM 38, 1991).
std::size_t find_first(std::string_view text, std::string_view part, std::size_t from) {
  if (part.empty()) return from;
  if (from == text.size()) return kNowhere;
  const void* found = ::memmem(text.data() + from, text.size() - from, part.data(), part.size());
  return found == nullptr ? kNowhere : static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
}

std::size_t find_last(std::string_view text, std::string_view part) {
  const std::size_t found = find_first(mirrored(text), mirrored(part));
  return found == kNowhere ? kNowhere : text.size() - found - part.size();
}

std::string mirrored(std::string_view text) { return {text.rbegin(), text.rend()}; }

}  // namespace race::language
