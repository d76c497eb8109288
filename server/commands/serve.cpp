// race serve: cores, services and the browser clients, on loopback.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "server/application/application.h"
#include "server/cell/component_groups.h"
#include "server/commands/command.h"
#include "server/commands/load_operator_script.h"
#include "server/http/listener.h"
#include "server/wire/calendar.h"

namespace race::server {
namespace {

// Numbers of messages go on where an earlier server can not have been: 1000 a millisecond since 1970.
std::int64_t first_sequence() { return now_ms() * 1000; }

// The component groups that run as processes: "cell,database".
Expected<std::vector<std::string>> read_units(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::string_view name = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), name.size() + 1));
    ASSIGN_OR_RETURN(const ComponentGroup* group, find_component_group(name));
    if (std::ranges::find(names, group->name) != names.end())
      return unexpected(ErrorCode::duplicate, "stands twice", std::string(name));
    names.emplace_back(group->name);
  }
  return names;
}

struct Options {
  std::string data = "data", demo, web, remote;
  std::optional<std::string> operator_script;
  double port = 8080, heartbeat_s = 1, keep_runs = 1000, keep_mb = 1024;
  bool headless = false;
};

int serve(const Options& options) {
  auto remote = read_units(options.remote);
  if (!remote) return refuse(remote.error());
  Application::Setup setup{options.data, options.demo, first_sequence()};
  if (options.operator_script) {
    auto script = load_operator_script(*options.operator_script);
    if (!script) return refuse(script.error());
    setup.script = std::move(*script);
  }
  setup.remote = std::move(*remote);
  setup.heartbeat = std::chrono::milliseconds(std::llround(options.heartbeat_s * 1000));
  setup.retention = {static_cast<std::size_t>(options.keep_runs),
                     static_cast<std::uint64_t>(options.keep_mb * (std::uint64_t{1} << 20U))};
  auto app = Application::create(setup);
  if (!app) return refuse(app.error());
  // Without clients, no pages; the interface is there all the same.
  const std::string web = options.headless ? "" : options.web;
  auto server = HttpServer::listen(static_cast<std::uint16_t>(options.port), web, (*app)->make_backend());
  if (!server) return refuse(server.error());
  std::printf("race listens on http://127.0.0.1:%u\n", static_cast<unsigned>((*server)->port()));
  std::fflush(stdout);
  (*server)->run();
  (*app)->stop_replays();
  return kExitOk;
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.number("--port", "N", options->port, 0, 65535, "0: any that is free");
  arguments.text("--data", "DIR", options->data, "where documents and values are kept");
  arguments.text("--demo", "DIR", options->demo, "the cell and its tasks; without, there is no robot");
  arguments.text("--web", "DIR", options->web, "the pages; without, the interface alone");
  arguments.flag("--headless", options->headless, "no pages, whatever --web says");
  arguments.file("--operator", "FILE", options->operator_script, "a person at the cell who acts by this script");
  arguments.text("--remote", "UNIT,...", options->remote,
                 "waits for processes (race service) that bring these: " + component_group_names());
  arguments.number("--heartbeat", "SECONDS", options->heartbeat_s, 0.1, 3600,
                   "after which such a process that is silent is lost");
  arguments.number("--keep-runs", "N", options->keep_runs, 0, 1e6, "runs that are over; the oldest are removed");
  arguments.number("--keep-mb", "N", options->keep_mb, 0, 1e6, "what these may hold [MiB]; the oldest are removed");
  return [options] { return serve(*options); };
}

}  // namespace

const Command kServe = {"serve", "serves cores, services and the browser clients on 127.0.0.1", declare};

}  // namespace race::server
