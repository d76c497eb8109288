// race derive MODEL SCRIPT: prints the derivations of a scripted run (core/SEMANTICS.md section 7). Exit 1 if the run
// faulted.
#include "core/semantics/derive.h"

#include <cstdio>
#include <memory>

#include "core/value/json.h"
#include "server/commands/command.h"

namespace race::server {
namespace {

int derive(const std::string& model_path, const std::string& script_path) {
  const auto model = read_file(model_path);
  if (!model) return refuse(model.error(), true);
  const auto script = read_file(script_path);
  if (!script) return refuse(script.error(), true);
  const auto document = semantics::derive_texts(*model, *script);
  if (!document) return refuse(document.error(), true);
  std::printf("%s\n", to_json(*document, 1).c_str());
  return document->find("status")->as_string() == "faulted" ? kExitFindings : kExitOk;
}

std::function<int()> declare(Arguments& arguments) {
  struct Options {
    std::string model, script;
  };
  const auto options = std::make_shared<Options>();
  arguments.positional("MODEL", options->model);
  arguments.positional("SCRIPT", options->script);
  return [options] { return derive(options->model, options->script); };
}

}  // namespace

const Command kDerive = {"derive", "prints the derivations of a scripted run, as JSON", declare};

}  // namespace race::server
