#include "server/accounts/rights.h"

#include "core/value/json.h"
#include "server/accounts/rights_json.h"
#include "server/wire/path_pattern.h"

namespace race::server {
namespace {

// The text is the program's own: what is wrong in it ends the program, and a test reads it.
Rights::Rows rows(const Value& json, std::string_view key) {
  Rights::Rows rows;
  for (const auto& [what, right] : json.find(key)->as_dict())
    rows[what.as_string()] = right_of(right.as_string()).value();
  return rows;
}

std::optional<Right> find(const Rights::Rows& rows, std::string_view what) {
  const auto row = rows.find(what);
  if (row == rows.end()) return std::nullopt;
  return row->second;
}

}  // namespace

const Rights& Rights::table() {
  static const Rights table = [] {
    const Value json = parse_json(kRightsJson).value();
    Rights made;
    made.routes_ = rows(json, "routes");
    made.channels_ = rows(json, "channels");
    made.messages_ = rows(json, "messages");
    return made;
  }();
  return table;
}

std::optional<Right> Rights::of_route(std::string_view method, std::string_view pattern) const {
  return find(routes_, std::string(method) + ' ' + std::string(pattern));
}

std::optional<Right> Rights::of_channel(std::string_view name) const {
  for (const auto& [pattern, right] : channels_)
    if (match(pattern, name)) return right;
  return std::nullopt;
}

std::optional<Right> Rights::of_message(std::string_view type) const { return find(messages_, type); }

}  // namespace race::server
