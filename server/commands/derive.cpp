// race derive [--text] [--order ORDER] MODEL SCRIPT: prints the derivations of a scripted run (core/SEMANTICS.md
// section 7), as JSON or as a transcript. Exit 1 if the run faulted.
#include "core/execution/derive.h"

#include <memory>
#include <optional>

#include "core/rcm/document.h"
#include "server/commands/command.h"
#include "server/commands/input.h"
#include "server/commands/print_derivations.h"

namespace race::server {
namespace {

struct Options {
  std::string model, script, order = "declared";
  bool as_text = false;
};

// What is wrong in the document has a path from its root on, what is wrong in the script another.
std::vector<FileErrors> by_file(const Options& options, const std::string& root, const std::vector<Error>& errors) {
  FileErrors of_model{options.model, {}}, of_script{options.script, {}};
  for (const Error& error : errors) {
    const bool in_model = error.path.empty() || error.path == root || error.path.starts_with(root + '/') ||
                          error.path.starts_with(root + '.');
    (in_model ? of_model : of_script).errors.push_back(error);
  }
  return {std::move(of_model), std::move(of_script)};
}

// Reads a file with `read`; null, and its errors at the end of `errors`: it cannot be read.
template <typename T>
std::optional<T> load(const std::string& path, Checked<T> (*read)(std::string_view), std::vector<FileErrors>& errors) {
  const auto text = read_input(path);
  auto loaded = text ? read(*text) : Checked<T>(tl::unexpect, std::vector<Error>{text.error()});
  if (loaded) return std::move(*loaded);
  errors.push_back({path, std::move(loaded).error()});
  return {};
}

int derive(const Options& options) {
  const bool json = !options.as_text;
  auto order = execution::read_order(options.order);
  if (!order) return refuse(Error{order.error().code, order.error().message, "--order"}, json);
  std::vector<FileErrors> errors;
  const auto model = load(options.model, rcm::read_document_text, errors);
  const auto script = load(options.script, execution::read_script_text, errors);
  if (!errors.empty()) return refuse(errors, json);
  const auto derivations = execution::derive(*model, *script, *order);
  if (!derivations) return refuse(by_file(options, model->root.name, derivations.error()), json);
  return print_derivations(*derivations, options.as_text);
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.file("MODEL", options->model);
  arguments.file("SCRIPT", options->script);
  arguments.text(
      "--order", "ORDER", options->order,
      "of ports, actions and children: declared, reversed, or a seed; if what happens differs, the task has a race");
  arguments.flag("--text", options->as_text, "as a transcript: one node a line");
  return [options] { return derive(*options); };
}

}  // namespace

const Command kDerive = {"derive", "prints the derivations of a scripted run, as JSON or text", declare};

}  // namespace race::server
