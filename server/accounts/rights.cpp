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

std::string who(const Identity& identity) {
  if (identity.role == Role::process) return "a process of services";
  if (identity.account.empty()) return "who is no process of services";
  return "the role " + quote(name(identity.role));
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

Expected<void> check_right(const Identity& identity, std::string_view what, std::optional<Right> right) {
  if (right && has_right(identity.role, *right)) return {};
  const std::string needed = right ? ": it needs " + quote(name(*right)) : "";
  return unexpected(ErrorCode::rights, who(identity) + " may not use " + quote(what) + needed);
}

Expected<void> check_message(const Identity& identity, std::string_view type) {
  return check_right(identity, type, Rights::table().of_message(type));
}

Expected<void> check_channel(const Identity& identity, std::string_view name) {
  const auto right = Rights::table().of_channel(name);
  if (!right) return unexpected(ErrorCode::not_found, "there is no channel of this name", std::string(name));
  return check_right(identity, name, right);
}

}  // namespace race::server
