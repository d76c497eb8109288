// Paths: how documents, derivations and violations name a node (`Root/Pick/Grasp`, `library/Grasp/Close`) or a port
// (`Root/Pick.success`). A missing name is shown as `?`.
#pragma once

#include <string>
#include <string_view>

namespace race::rcm {

/// The path of the node `name` below `parent`; of a root, if `parent` is empty.
inline std::string node_path(std::string_view parent, std::string_view name) {
  std::string out(parent);
  if (!out.empty()) out += '/';
  return out += name.empty() ? "?" : name;
}

/// The path of the port `name` of the state at `state`.
inline std::string port_path(std::string_view state, std::string_view name) {
  return std::string(state) + '.' + std::string(name.empty() ? "?" : name);
}

/// The path of a state of the library.
inline std::string library_path(std::string_view name) { return node_path("library", name); }

}  // namespace race::rcm
