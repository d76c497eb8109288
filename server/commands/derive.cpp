// race derive [--text] MODEL SCRIPT: prints the derivations of a scripted run (core/SEMANTICS.md section 7), as JSON or
// as a transcript. Exit 1 if the run faulted.
#include "core/semantics/derive.h"

#include <cstdio>

#include "core/semantics/derivation_text.h"
#include "core/value/json.h"
#include "server/commands/command.h"

namespace race::server {
namespace {

int derive(const std::vector<std::string>& words) {
  std::vector<std::string> arguments = words;
  const bool as_text = std::erase(arguments, "--text") > 0;
  if (arguments.size() != 2) return misused(kDerive);
  const auto model = read_file(arguments[0]);
  if (!model) return refuse(model.error(), !as_text);
  const auto script = read_file(arguments[1]);
  if (!script) return refuse(script.error(), !as_text);
  const auto document = semantics::derive_texts(*model, *script);
  if (!document) return refuse(document.error(), !as_text);
  if (as_text)
    std::fputs(semantics::derivation_text(*document).c_str(), stdout);
  else
    std::printf("%s\n", to_json(*document, 1).c_str());
  return document->find("status")->as_string() == "faulted" ? kFound : kFine;
}

}  // namespace

const Command kDerive = {"derive", "[--text] MODEL SCRIPT", "prints the derivations of a scripted run, as JSON or text",
                         derive};

}  // namespace race::server
