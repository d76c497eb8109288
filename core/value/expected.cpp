#include "core/value/expected.h"

#include <algorithm>
#include <array>

#include "core/value/error_list.h"

namespace race {
namespace {

constexpr std::array kNames = {
    "json",           "version",      "missing",      "type",         "unknown_field",  "name",
    "duplicate",      "constant",     "parameter",    "root_from",    "first",          "port_target",
    "barrier_target", "link_unknown", "link_cycle",   "link_field",   "link_parameter", "link_port",
    "oracle",         "after",        "reference",    "keep",         "syntax",         "forbidden",
    "scope",          "effect",       "service_call", "unknown_name", "too_large",      "too_deep",
    "out_of_range",   "not_found",    "conflict",     "io",           "unavailable",    "not_accepted",
    "storage",        "corrupt",      "rights",       "stopped",      "leased"};
static_assert(kNames.size() == static_cast<std::size_t>(ErrorCode::leased) + 1);

}  // namespace

std::string_view name(ErrorCode code) { return kNames[static_cast<std::size_t>(code)]; }

std::optional<ErrorCode> code_of(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<ErrorCode>(found - kNames.begin());
}

std::string to_string(const Error& error) {
  return error.path + ": " + std::string(name(error.code)) + ": " + error.message;
}

std::string quote(std::string_view name) { return "`" + std::string(name) + "`"; }

void append_below(std::vector<Error>& errors, std::vector<Error> more, const std::string& below) {
  for (Error& error : more) {
    error.path = below + (below.empty() || error.path.empty() ? "" : "/") + error.path;
    add_error(errors, std::move(error));
  }
}

}  // namespace race
