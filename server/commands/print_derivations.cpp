#include "server/commands/print_derivations.h"

#include <cstdio>

#include "core/semantics/derivation_text.h"
#include "core/value/json.h"
#include "server/commands/command.h"

namespace race::server {

int print_derivations(const Value& document, bool as_text) {
  if (as_text)
    std::fputs(semantics::derivation_text(document).c_str(), stdout);
  else
    std::printf("%s\n", to_json(document, 1).c_str());
  return document.find("status")->as_string() == "faulted" ? kExitFindings : kExitOk;
}

}  // namespace race::server
