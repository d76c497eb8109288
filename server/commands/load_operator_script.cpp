#include "server/commands/load_operator_script.h"

#include "server/commands/input.h"

namespace race::server {

tl::expected<OperatorScript, FileErrors> load_operator_script(const std::string& file) {
  const auto text = read_input(file);
  if (!text) return tl::unexpected(FileErrors{file, {text.error()}});
  auto script = read_operator_text(*text);
  if (!script) return tl::unexpected(FileErrors{file, std::move(script).error()});
  return std::move(*script);
}

}  // namespace race::server
