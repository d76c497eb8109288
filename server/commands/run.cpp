// race run MODEL: one task with services of its own, without clients.
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "core/rcm/document.h"
#include "core/value/json.h"
#include "server/cell/screen_services.h"
#include "server/commands/command.h"
#include "server/commands/headless.h"
#include "server/commands/input.h"
#include "server/commands/load_operator_script.h"

namespace race::server {
namespace {

// What happened in a macro step, for people: which states were entered and left, what was called.
void print(const Dict& report) {
  if (const Value* text = report.find("text")) {
    std::printf("%9.3f  %s: %s\n", report.find("time")->as_number(), report.find("source")->as_string().c_str(),
                text->as_string().c_str());
    return;
  }
  const Value* active = report.find("active");
  if (!active) {
    std::printf("%s\n", to_json(Value(report)).c_str());
    return;
  }
  std::string line;
  for (const auto& [path, on] : active->as_dict()) line += (on.as_bool() ? "  +" : "  -") + path.as_string();
  for (const Value& call : report.find("calls")->as_list())
    line += "  " + call.find("service")->as_string() + "." + call.find("operation")->as_string() + "()";
  if (!line.empty()) std::printf("%9.3f%s\n", report.find("time")->as_number(), line.c_str());
}

struct Options {
  std::string model, arguments = "{}", database = ":memory:";
  std::optional<std::string> cell, operator_script;
  double seed = 0, limit_s = 3600;
  bool fast = false, json = false;
};

int run_task(const Options& options) {
  const bool json = options.json;
  auto arguments = read_object("--arguments", options.arguments);
  const auto text = read_input(options.model);
  if (!arguments) return refuse(arguments.error(), json);
  if (!text) return refuse(FileErrors{options.model, {text.error()}}, json);
  const auto document = rcm::read_document_text(*text);
  if (!document) return refuse(FileErrors{options.model, document.error()}, json);

  display::Screens screens;  // the operator script answers them
  HeadlessSetup setup;
  setup.model_file = options.model;
  setup.cell.folder = options.cell.value_or(std::filesystem::path(options.model).parent_path());
  if (setup.cell.folder.empty()) setup.cell.folder = ".";
  setup.cell.database = options.database;
  setup.cell.extra_services = screen_services(screens, setup.cell.folder);
  setup.fast = options.fast;
  setup.limit_s = options.limit_s;
  setup.cell.seed = static_cast<std::uint64_t>(options.seed);
  if (options.operator_script) {
    auto script = load_operator_script(*options.operator_script);
    if (!script) return refuse(script.error(), json);
    setup.script_file = *options.operator_script;
    setup.script = std::move(*script);
    setup.screens = &screens;
  }
  const auto status = Headless::run(*document, std::move(*arguments), setup, [&](const Dict& report) {
    if (!json) return print(report);
    std::cout << to_json(Value(report)) << '\n';
  });
  std::cout.flush();
  if (!status) return refuse(status.error(), json);
  return *status == semantics::Status::ended ? kExitOk : kExitFindings;
}

std::function<int()> declare(Arguments& arguments) {
  constexpr double kMaxSeed = 9007199254740992.0;  // 2^53: every integer up to it is a double
  const auto options = std::make_shared<Options>();
  arguments.file("MODEL", options->model);
  arguments.flag("--fast", options->fast, "as fast as possible, else in real time");
  arguments.number("--seed", "N", options->seed, {0, kMaxSeed, true},
                   "of cameras and searches; the same seed gives the same run with --fast");
  arguments.text("--arguments", "JSON", options->arguments, "parameters of the task, an object");
  arguments.text("--cell", "DIR", options->cell, "the cell: scene.json, database.json ... (the folder of MODEL)");
  arguments.text("--database", "FILE", options->database, "where values that tasks store are kept");
  arguments.number("--limit", "SECONDS", options->limit_s, {0, 1e9}, "ends a run that takes longer, in world time");
  arguments.file("--operator", "FILE", options->operator_script, "a person at the cell who acts by this script");
  arguments.flag("--json", options->json, "a line of JSON for each step");
  return [options] { return run_task(*options); };
}

}  // namespace

const Command kRun = {"run", "runs a task with its own services, without clients; the last line is the outcome",
                      declare};

}  // namespace race::server
