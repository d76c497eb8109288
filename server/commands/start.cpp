// race start DOCUMENT and race stop: a run of a document at a running server, in a core of its own, and its end; or
// STOP for the whole cell.
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

#include "core/value/json.h"
#include "server/commands/ask_server.h"
#include "server/commands/command.h"
#include "server/commands/core_line.h"
#include "server/commands/watching.h"

namespace race::server {
namespace {

struct StartOptions {
  std::string document, arguments = "{}";
  bool wait = false;
  ServerOptions server;
};

std::string text_of(const Value& core, const char* key) {
  const Value* text = core.find(key);
  return text && text->is_string() ? text->as_string() : "";
}

// At a breakpoint: it goes on when somebody wants that.
bool is_paused(const Value& core) {
  const Value* paused = core.find("paused");
  return paused && paused->is_bool() && paused->as_bool();
}

int print_core(const ServerOptions& server, const Value& core) {
  const auto line = core_line(core);
  if (!line) return refuse(Error{line.error().code, line.error().message, server.url}, server.json);
  std::printf("%s\n", server.json ? to_json(core, 1).c_str() : line->c_str());
  const Value* results = core.find("results");
  if (results && !server.json) std::printf("%s\n", to_json(*results).c_str());
  return kExitOk;
}

// Without an answer, nobody would know else what may move.
int say_may_run(const std::string& id, int code) {
  std::fprintf(stderr, "core %s may run; `race stop %s` ends it\n", id.c_str(), id.c_str());
  return code;
}

// A core that cannot be started does not stay.
tl::expected<Value, int> start(const ServerOptions& server, const std::string& id) {
  auto answer = request_server(server, "POST", core_path(id) + "/start");
  if (!answer) return tl::unexpected(say_may_run(id, answer.error()));
  if (is_fine(*answer)) return std::move(answer->body);
  const int code = refuse_answer(server, *answer);
  if (const auto client = client_of(server)) (void)client->request("DELETE", core_path(id));
  return tl::unexpected(code);
}

// Until the run is over, waits for a person or is paused. Gives the exit code.
int wait_for_end(const ServerOptions& server, const std::string& id) {
  for (;; std::this_thread::sleep_for(kPollPause)) {
    const auto answer = request_server(server, "GET", core_path(id));
    if (!answer) return say_may_run(id, answer.error());
    if (answer->status == kBusy) continue;
    if (!is_fine(*answer)) return refuse_answer(server, *answer);
    const std::string status = text_of(answer->body, "status");
    if ((status == "ready" || status == "running") && !is_paused(answer->body)) continue;
    const int printed = print_core(server, answer->body);
    return printed == kExitOk && status != "ended" ? kExitFindings : printed;
  }
}

int start(const StartOptions& options) {
  const ServerOptions& server = options.server;
  auto arguments = read_object("--arguments", options.arguments);
  if (!arguments) return refuse(arguments.error(), server.json);
  const auto made =
      ask_server(server, "POST", kCores, Dict{{"document", options.document}, {"arguments", std::move(*arguments)}});
  if (!made) return made.error();
  const std::string id = in_one_line(text_of(*made, "id"));
  if (id.empty()) return refuse(Error{ErrorCode::io, "answers what is no core", server.url}, server.json);
  const auto core = start(server, id);
  if (!core) return core.error();
  // Who reads the number may already press Ctrl-C.
  if (options.wait) end_on_signal(kExitFindings, "core " + id + " goes on; `race stop " + id + "` ends it\n");
  if (!server.json) std::printf("%s\n", id.c_str());
  if (options.wait) return wait_for_end(server, id);
  if (server.json) std::printf("%s\n", to_json(*core, 1).c_str());
  return kExitOk;
}

struct StopOptions {
  std::optional<std::string> id;
  bool cell = false;
  ServerOptions server;
};

// STOP is for everybody: it needs no token, and does not fail for want of a good one.
int stop_cell(ServerOptions server) {
  server.anonymous = true;
  const auto answer = ask_server(server, "POST", "/api/v1/stop");
  if (!answer) return answer.error();
  std::printf("%s\n",
              server.json ? to_json(*answer, 1).c_str() : "the cell is stopped: nothing moves until it is reset");
  return kExitOk;
}

int stop(const StopOptions& options) {
  const ServerOptions& server = options.server;
  if (options.cell == options.id.has_value())
    return refuse(Error{options.cell ? ErrorCode::syntax : ErrorCode::missing,
                        "the form is `race stop ID` or `race stop --cell`", "ID"},
                  server.json);
  if (options.cell) return stop_cell(server);
  const auto core = ask_server(server, "POST", core_path(*options.id) + "/stop");
  return core ? print_core(server, *core) : core.error();
}

std::function<int()> declare_start(Arguments& arguments) {
  const auto options = std::make_shared<StartOptions>();
  arguments.positional("DOCUMENT", options->document);
  arguments.text("--arguments", "JSON", options->arguments, "parameters of the task, an object");
  arguments.flag("--wait", options->wait, "waits for the end of the run; 0: it ended without a fault");
  options->server.declare(arguments, "prints the core as JSON");
  return [options] { return start(*options); };
}

std::function<int()> declare_stop(Arguments& arguments) {
  const auto options = std::make_shared<StopOptions>();
  arguments.positional("ID", options->id, "the core whose run is stopped");
  arguments.flag("--cell", options->cell, "STOP: all that moves, all runs; needs no login; no safety function");
  options->server.declare(arguments, "prints what the server answers, as JSON");
  return [options] { return stop(*options); };
}

}  // namespace

const Command kStart = {"start", "starts a document at a running server; prints the id of its core", declare_start};
const Command kStop = {"stop", "stops the run of a core at a running server, or the whole cell", declare_stop};

}  // namespace race::server
