#include "server/http/content_coding.h"

#include <algorithm>
#include <map>
#include <string>

#include "server/http/field_list.h"

namespace race::server {
namespace {

// In thousandths: 1000 for "1", 250 for "0.25". Nothing: no valid weight.
std::optional<int> weight_of(std::string_view text) {
  if (text.empty() || text.size() > 5 || (text[0] != '0' && text[0] != '1')) return std::nullopt;
  if (text.size() > 1 && text[1] != '.') return std::nullopt;
  int weight = (text[0] - '0') * 1000;
  int place = 100;
  for (const char digit : text.substr(std::min<std::size_t>(text.size(), 2))) {
    if (digit < '0' || digit > '9') return std::nullopt;
    weight += (digit - '0') * place;
    place /= 10;
  }
  if (weight > 1000) return std::nullopt;
  return weight;
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return lower;
}

// Weights by coding, with "*" for those that are not named. Of equal names the first counts.
std::map<std::string, int> weights_in(const std::vector<std::string_view>& elements) {
  std::map<std::string, int> weights;
  for (const std::string_view element : elements) {
    const auto mark = element.find(';');
    std::optional<int> weight = 1000;
    if (mark != std::string_view::npos) {
      const std::string parameter = in_lower_case(trim(element.substr(mark + 1)));
      weight = parameter.starts_with("q=") ? weight_of(std::string_view(parameter).substr(2)) : std::nullopt;
    }
    std::string name = in_lower_case(trim(element.substr(0, mark)));
    if (name == "x-gzip") name = "gzip";
    if (weight && !name.empty()) weights.try_emplace(std::move(name), *weight);
  }
  return weights;
}

}  // namespace

std::optional<std::string_view> choose_coding(const Request& request, std::span<const std::string_view> codings) {
  const std::map<std::string, int> weights = weights_in(elements_of(request, "accept-encoding"));
  const auto weight = [&](std::string_view coding) {
    if (const auto named = weights.find(std::string(coding)); named != weights.end()) return named->second;
    if (const auto others = weights.find("*"); others != weights.end()) return others->second;
    return coding == "identity" ? 1 : 0;
  };
  const auto best = std::ranges::max_element(codings, {}, weight);  // of equal ones the first
  if (best == codings.end() || weight(*best) == 0) return std::nullopt;
  return *best;
}

}  // namespace race::server
