// race serve: cores, services and the browser clients, on loopback.
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "server/application.h"
#include "server/commands/command.h"
#include "server/commands/options.h"
#include "server/http/listener.h"

namespace race::server {
namespace {

constexpr std::string_view kUsage = "--port N --data DIR [--headless] [--demo DIR] [--web DIR] [--operator FILE]";

// Numbers of messages go on where an earlier server can not have been: 1000 a millisecond since 1970.
std::int64_t first_sequence() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count() * 1000;
}

}  // namespace

int serve_command(const std::vector<std::string>& words) {
  const auto options = read_options(words, {"--port", "--data", "--demo", "--web", "--operator"}, {"--headless"});
  if (!options) return refuse(options.error());
  if (!options->rest.empty()) return usage("serve", kUsage);
  const auto port = options->number("--port", 8080, 0, 65535);
  if (!port) return refuse(port.error());
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
  auto app = Application::create(setup);
  if (!app) return refuse(app.error());
  // Without clients, no pages; the interface is there all the same.
  const std::string web = options->has("--headless") ? "" : options->text("--web");
  auto server = HttpServer::listen(static_cast<std::uint16_t>(*port), web, **app);
  if (!server) return refuse(server.error());
  std::printf("race listens on http://127.0.0.1:%u\n", static_cast<unsigned>((*server)->port()));
  std::fflush(stdout);
  (*server)->run();
  return kFine;
}

}  // namespace race::server
