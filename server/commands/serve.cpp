// race serve: cores, services and the browser clients, on loopback.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "server/application.h"
#include "server/cell/component_groups.h"
#include "server/commands/command.h"
#include "server/commands/options.h"
#include "server/http/routes.h"

namespace race::server {
namespace {

// Numbers of messages go on where an earlier server can not have been: 1000 a millisecond since 1970.
std::int64_t first_sequence() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count() * 1000;
}

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

int serve(const std::vector<std::string>& words) {
  const auto options = read_options(words, kServe.arguments);
  if (!options) return refuse(options.error());
  if (!options->rest.empty()) return misused(kServe);
  const auto port = options->number("--port", 8080, 0, 65535);
  if (!port) return refuse(port.error());
  auto remote = read_units(options->text("--remote"));
  if (!remote) return refuse(remote.error());
  const auto heartbeat = options->number("--heartbeat", 1, 0.1, 3600);
  if (!heartbeat) return refuse(heartbeat.error());
  const std::string data = options->text("--data", "data");
  std::error_code error;
  std::filesystem::create_directories(data, error);
  if (error) return refuse(Error{ErrorCode::io, error.message(), data});

  Application::Setup setup{data, options->text("--demo"), first_sequence()};
  if (options->has("--operator")) {
    auto script = read_operator_file(options->text("--operator"));
    if (!script) return refuse(script.error());
    setup.script = std::move(*script);
  }
  setup.remote = std::move(*remote);
  setup.heartbeat = std::chrono::milliseconds(std::llround(*heartbeat * 1000));
  auto app = Application::create(setup);
  if (!app) return refuse(app.error());
  // Without clients, no pages; the interface is there all the same.
  const std::string web = options->has("--headless") ? "" : options->text("--web");
  auto server = HttpServer::listen(static_cast<std::uint16_t>(*port), web, behind_the_door(**app));
  if (!server) return refuse(server.error());
  std::printf("race listens on http://127.0.0.1:%u\n", static_cast<unsigned>((*server)->port()));
  std::fflush(stdout);
  (*server)->run();
  return kFine;
}

}  // namespace

const Command kServe = {
    "serve",
    "[--port N] [--data DIR] [--demo DIR] [--web DIR] [--headless] [--operator FILE] [--remote UNIT,...] "
    "[--heartbeat SECONDS]",
    "serves cores, services and the browser clients on 127.0.0.1", serve, [] {
      return "  --port N              (8080); 0: any that is free\n"
             "  --data DIR            where documents and values are kept (data)\n"
             "  --demo DIR            the cell and its tasks; without, there is no robot\n"
             "  --web DIR             the pages; without, the interface alone\n"
             "  --headless            no pages, whatever --web says\n"
             "  --operator FILE       somebody who acts by this script, else people do\n"
             "  --remote UNIT,...     waits for processes (race service) that bring these: " +
             component_group_names() +
             "\n"
             "  --heartbeat SECONDS   after which such a process that says nothing is lost (1)\n";
    }};

}  // namespace race::server
