#include "server/accounts/role.h"

#include <algorithm>
#include <array>

namespace race::server {
namespace {

// In the order of Right; Role is the same without `anyone`.
constexpr std::array<std::string_view, 6> kNames = {"anyone", "process", "observer", "operator", "developer", "admin"};

constexpr std::size_t kFirstRole = 1;

std::optional<std::size_t> place_of(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kNames.begin());
}

}  // namespace

std::string_view name(Role role) { return kNames.at(static_cast<std::size_t>(role) + kFirstRole); }
std::string_view name(Right right) { return kNames.at(static_cast<std::size_t>(right)); }

std::optional<Role> role_of(std::string_view name) {
  const auto place = place_of(name);
  if (!place || *place < kFirstRole) return std::nullopt;
  return static_cast<Role>(*place - kFirstRole);
}

std::optional<Right> right_of(std::string_view name) {
  const auto place = place_of(name);
  if (!place) return std::nullopt;
  return static_cast<Right>(*place);
}

bool has_right(Role role, Right right) {
  if (right == Right::anyone) return true;
  if (right == Right::process || role == Role::process) return right == Right::process && role == Role::process;
  return static_cast<std::size_t>(role) + kFirstRole >= static_cast<std::size_t>(right);
}

bool is_local(const Identity& identity) {
  return identity.account.empty() || std::ranges::find(identity.groups, kLocal) != identity.groups.end();
}

std::string name_for_people(const Identity& identity) {
  if (!identity.account.empty()) return identity.account;
  return "somebody at " + (identity.address.empty() ? "this machine" : identity.address);
}

}  // namespace race::server
