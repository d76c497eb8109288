#include "server/accounts/account.h"

#include <algorithm>

namespace race::server {
namespace {

bool is_alphanumeric(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

bool is_account_name(const std::string& text) {
  if (text.empty() || text.size() > Account::kLongestName || !is_alphanumeric(text.front())) return false;
  return std::ranges::all_of(text, [](char c) { return is_alphanumeric(c) || c == '_' || c == '-' || c == '.'; });
}

}  // namespace

Expected<void> Account::check() const {
  if (!is_account_name(name))
    return unexpected(ErrorCode::name,
                      "a name has 1 to 40 letters, digits, `_`, `-` and `.`, and begins with a letter or digit",
                      "name");
  if (role == Role::process && groups.empty())
    return unexpected(ErrorCode::missing, "a process needs the component groups that it may bring", "groups");
  if (role != Role::process && !groups.empty() && groups != std::vector<std::string>{std::string(kLocal)})
    return unexpected(ErrorCode::not_accepted,
                      "only a process brings component groups; an account of people is `local`, or nothing", "groups");
  if (role == Role::process && !password_hash.empty())
    return unexpected(ErrorCode::not_accepted, "a process has tokens and no password", "password");
  return {};
}

Expected<void> TokenScope::check(const Account& account) const {
  const bool is_process = account.role == Role::process;
  if (role && (is_process || *role == Role::process || *role > account.role))
    return unexpected(ErrorCode::not_accepted, "a token of a person may do what its account may, or less", "role");
  if (local && is_process) return unexpected(ErrorCode::not_accepted, "a process is no display at the cell", "local");
  return {};
}

}  // namespace race::server
