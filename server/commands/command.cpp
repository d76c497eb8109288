#include "server/commands/command.h"

#include <cstdio>

#include "core/semantics/derive.h"
#include "core/value/json.h"

namespace race::server {

int refuse(const std::vector<Error>& errors, bool json) {
  if (json) std::printf("%s\n", to_json(semantics::errors_json(errors), 1).c_str());
  for (const Error& error : errors) std::fprintf(stderr, "%s\n", to_string(error).c_str());
  return kBadInput;
}

int refuse(const Error& error, bool json) { return refuse(std::vector<Error>{error}, json); }

int usage(std::string_view command, std::string_view arguments) {
  std::fprintf(stderr, "usage: race %.*s %.*s\n", static_cast<int>(command.size()), command.data(),
               static_cast<int>(arguments.size()), arguments.data());
  return kBadInput;
}

}  // namespace race::server
