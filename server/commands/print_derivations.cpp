#include "server/commands/print_derivations.h"

#include <cstdio>

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

void DerivationPrinter::print_steps(const Value& document) {
  if (as_text_) {
    std::fputs(text_.steps(document).c_str(), stdout);
    return;
  }
  const Value* steps = document.find("steps");
  if (!steps || !steps->is_list()) return;
  for (const Value& step : steps->as_list()) std::printf("%s\n", to_json(step).c_str());
}

int DerivationPrinter::print_end(const Value& document) const {
  Dict end;
  for (const char* key : {"status", "outcome", "fault"})
    if (const Value* value = document.find(key)) end.set(key, *value);
  const Value* status = document.find("status");
  const bool is_faulted = status && status->is_string() && status->as_string() == "faulted";
  const Value all(std::move(end));
  std::fputs(as_text_ ? semantics::DerivationText::status(all).c_str() : (to_json(all) + '\n').c_str(), stdout);
  return is_faulted ? kExitFindings : kExitOk;
}

}  // namespace race::server
