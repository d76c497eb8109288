// race run MODEL: one task with services of its own, without clients.
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "core/rcm/document.h"
#include "core/value/json.h"
#include "server/cell/screen_services.h"
#include "server/commands/command.h"
#include "server/commands/headless.h"
#include "server/commands/options.h"

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

Expected<Dict> read_arguments(const std::string& text) {
  ASSIGN_OR_RETURN(Value value, parse_json(text));
  if (!value.is_dict()) return unexpected(ErrorCode::type, "must be an object", "--arguments");
  return value.as_dict();
}

int run_task(const std::vector<std::string>& words) {
  const auto options = read_options(words, kRun.arguments);
  if (!options) return refuse(options.error());
  if (options->rest.size() != 1) return misused(kRun);
  const bool json = options->has("--json");
  const std::string& model = options->rest.front();
  const auto seed = options->number("--seed", 0, 0, 9007199254740992.0);
  const auto limit = options->number("--limit", 3600, 0, 1e9);
  auto arguments = read_arguments(options->text("--arguments", "{}"));
  const auto text = read_file(model);
  if (!seed) return refuse(seed.error(), json);
  if (!limit) return refuse(limit.error(), json);
  if (!arguments) return refuse(arguments.error(), json);
  if (!text) return refuse(text.error(), json);
  const auto document = rcm::read_document_text(*text);
  if (!document) return refuse(document.error(), json);

  display::Screens screens;  // the operator stands before them, or nobody
  HeadlessSetup setup;
  setup.cell.folder = options->text("--cell", std::filesystem::path(model).parent_path());
  if (setup.cell.folder.empty()) setup.cell.folder = ".";
  setup.cell.database = options->text("--database", ":memory:");
  setup.cell.extra_services = screen_services(screens, setup.cell.folder);
  setup.fast = options->has("--fast");
  setup.limit_s = *limit;
  setup.cell.seed = static_cast<std::uint64_t>(*seed);
  if (options->has("--operator")) {
    auto script = read_operator_file(options->text("--operator"));
    if (!script) return refuse(script.error(), json);
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

}  // namespace

const Command kRun = {
    "run",
    "MODEL [--fast] [--seed N] [--arguments JSON] [--cell DIR] [--database FILE] [--limit SECONDS] [--operator FILE] "
    "[--json]",
    "runs a task with its own services, without clients; the last line is the outcome", run_task, [] {
      return std::string(
          "  --fast             as fast as possible, else in real time\n"
          "  --seed N           of cameras and searches (0); the same seed gives the same run with --fast\n"
          "  --arguments JSON   parameters of the task, an object ({})\n"
          "  --cell DIR         the cell: scene.json, database.json ... (the folder of MODEL)\n"
          "  --database FILE    keeps what tasks store; without, it is forgotten\n"
          "  --limit SECONDS    leaves a run that has not ended then (3600)\n"
          "  --operator FILE    somebody who acts by this script, else nobody\n"
          "  --json             a line of JSON for each step\n");
    }};

}  // namespace race::server
