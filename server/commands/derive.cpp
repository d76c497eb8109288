// race derive [--text] [--order ORDER] MODEL SCRIPT: prints the derivations of a scripted run (core/SEMANTICS.md
// section 7), as JSON or as a transcript. Exit 1 if the run faulted.
#include "core/execution/derive.h"

#include <memory>

#include "server/commands/command.h"
#include "server/commands/print_derivations.h"

namespace race::server {
namespace {

int derive(const std::string& model_path, const std::string& script_path, const std::string& order_text, bool as_text) {
  auto order = execution::read_order(order_text);
  if (!order) return refuse(Error{order.error().code, order.error().message, "--order"}, !as_text);
  const auto model = read_file(model_path);
  if (!model) return refuse(model.error(), !as_text);
  const auto script = read_file(script_path);
  if (!script) return refuse(script.error(), !as_text);
  const auto document = execution::derive_texts(*model, *script, *order);
  if (!document) return refuse(document.error(), !as_text);
  return print_derivations(*document, as_text);
}

std::function<int()> declare(Arguments& arguments) {
  struct Options {
    std::string model, script, order = "declared";
    bool as_text = false;
  };
  const auto options = std::make_shared<Options>();
  arguments.positional("MODEL", options->model);
  arguments.positional("SCRIPT", options->script);
  arguments.text(
      "--order", "ORDER", options->order,
      "of ports, actions and children: declared, reversed, or a seed; if what happens differs, the task has a race");
  arguments.flag("--text", options->as_text, "as a transcript: one node a line");
  return [options] { return derive(options->model, options->script, options->order, options->as_text); };
}

}  // namespace

const Command kDerive = {"derive", "prints the derivations of a scripted run, as JSON or text", declare};

}  // namespace race::server
