// Role: what an account may do, and Right: what something needs. Which right a route, channel or message needs is a row
// of api/rights.json (rights.h).
//
// Threads: any; values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace race::server {

/// Of people, each role may do all that those before it may. A process of services may connect as such, and nothing
/// else.
enum class Role : std::uint8_t { process, observer, cell_operator, developer, admin };

/// "process", "observer", "operator", "developer", "admin".
std::string_view name(Role role);
std::optional<Role> role_of(std::string_view name);

/// Who may do it: anybody, also without an account; processes of services alone; or people of this role and those after
/// it.
enum class Right : std::uint8_t { anyone, process, observer, cell_operator, developer, admin };

/// "anyone", and the names of roles.
std::string_view name(Right right);
std::optional<Right> right_of(std::string_view name);

/// Whether an account of this role has the right.
bool has_right(Role role, Right right);

/// Who asks: an account, or anybody at a server that has none.
struct Identity {
  std::string account;  // empty: the server has no accounts, and this is anybody on this machine
  Role role = Role::admin;
  std::vector<std::string> groups = {};  // as of Account
  std::string token = {};                // hexadecimal digest of the token; empty without accounts
  std::string address = {};              // where they are: "127.0.0.1"
  std::string display = {};              // the name of the display that this is, if it was let in with a code
  bool operator==(const Identity&) const = default;
};

/// The group of an account that is a display at the cell, where what moves is seen.
inline constexpr std::string_view kLocal = "local";
/// Whether that is somebody at the cell: an account of kLocal, or anybody at a server without accounts, on its machine.
bool is_local(const Identity& identity);

/// Who that is, as people read it: "alice", "somebody at 127.0.0.1".
std::string name_for_people(const Identity& identity);

}  // namespace race::server
