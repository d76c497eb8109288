#include "server/http/field_list.h"

#include <algorithm>

namespace race::server {

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return out;
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view kBlank = " \t";
  const auto begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

std::vector<std::string_view> elements_of(const Request& request, std::string_view name) {
  std::vector<std::string_view> elements;
  for (const auto& [field, value] : request.headers) {
    if (field != name) continue;
    for (std::string_view rest = value; !rest.empty();) {
      const auto end = rest.find(',');
      if (const std::string_view element = trim(rest.substr(0, end)); !element.empty()) elements.push_back(element);
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
  }
  return elements;
}

bool if_none_match_lists(const Request& request, std::string_view tag) {
  return std::ranges::any_of(elements_of(request, "if-none-match"), [&](std::string_view known) {
    if (known.starts_with("W/")) known.remove_prefix(2);
    return known == tag || known == "*";
  });
}

}  // namespace race::server
