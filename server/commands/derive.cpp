// race derive MODEL SCRIPT: prints the derivations of a scripted run (core/SEMANTICS.md section 7). Exit 1 if the run
// faulted.
#include "core/semantics/derive.h"

#include <cstdio>

#include "core/value/json.h"
#include "server/commands/command.h"

namespace race::server {
namespace {

int derive(const std::vector<std::string>& arguments) {
  if (arguments.size() != 2) return misused(kDerive);
  const auto model = read_file(arguments[0]);
  if (!model) return refuse(model.error(), true);
  const auto script = read_file(arguments[1]);
  if (!script) return refuse(script.error(), true);
  const auto document = semantics::derive_texts(*model, *script);
  if (!document) return refuse(document.error(), true);
  std::printf("%s\n", to_json(*document, 1).c_str());
  return document->find("status")->as_string() == "faulted" ? kExitFindings : kExitOk;
}

}  // namespace

const Command kDerive = {"derive", "MODEL SCRIPT", "prints the derivations of a scripted run, as JSON", derive};

}  // namespace race::server
