// race service NAME: one group of a cell as a process; its services are those of the server.
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <thread>

#include "server/accounts/local_key.h"
#include "server/cell/component_groups.h"
#include "server/commands/ask_server.h"
#include "server/commands/command.h"
#include "server/log/line_log.h"
#include "services/remote/process_session.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;

constexpr auto kRetryInterval = 500ms;  // between attempts to connect

std::atomic<bool> stop_requested{false};  // by SIGINT or SIGTERM

/// The log of the process; its lines are the group's.
class Log {
 public:
  explicit Log(const std::string& group) : group_(group) {}
  void write(LogLevel level, const std::string& text) { lines_.write(level, group_, text); }

 private:
  LineLog lines_{STDERR_FILENO, LogLevel::info};
  const std::string group_;
};

// Why the server does not accept the process, by the first error of its refusal.
Error refused(const Value& refusal) {
  const Value reason = refusal.as_list().empty() ? Value() : refusal.as_list().front();
  const auto text = [&](const char* field) {
    const Value* value = reason.find(field);
    return value && value->is_string() ? value->as_string() : std::string();
  };
  return Error{ErrorCode::conflict, "the server refuses: " + text("message"), text("path")};
}

struct Options {
  std::string group, server, folder, database = ":memory:";
  std::optional<std::string> token_file;
};

// Empty: there is none.
Expected<std::string> token_of_process(const std::optional<std::string>& file) {
  constexpr const char* kUsual = "data/processes.token";
  if (file || std::getenv("RACE_TOKEN")) return token_of(file);
  if (!std::filesystem::exists(kUsual)) return std::string();
  return read_token_file(kUsual);
}

int run_service(const Options& options) {
  const std::string& name = options.group;
  const auto row = find_component_group(name);
  if (!row) return refuse(row.error());
  const std::string& url = options.server;
  const auto address = remote::read_address(url);
  if (!address) return refuse(address.error());
  if (address->tls)
    return refuse(Error{ErrorCode::not_accepted,
                        "a process of services connects without TLS: to a server of its own machine, or by a tunnel",
                        url});
  auto cell = read_cell(options.folder);
  if (!cell) return refuse(FileErrors{"", std::move(cell).error()});
  const GroupSetup setup{std::move(*cell), options.folder, options.database};
  Log log(name);
  std::signal(SIGPIPE, SIG_IGN);  // of a log that nobody reads any more
  std::signal(SIGINT, [](int) { stop_requested = true; });
  std::signal(SIGTERM, [](int) { stop_requested = true; });

  bool waiting = false;  // for the server, and has logged so
  while (!stop_requested) {
    // The server treats a lost process as dead: its services begin anew.
    remote::SendQueue out;
    remote::ProcessHost process;
    if (auto made = (*row)->make(setup, process); !made) return refuse(made.error());
    std::unique_ptr<remote::ProcessSession> session;
    while (!stop_requested && !session) {
      const auto token = token_of_process(options.token_file);  // the server may have made it meanwhile
      if (!token) return refuse(token.error());
      auto connected = remote::ProcessSession::connect(
          *address, *token, process, out,
          {stop_requested, [&] { log.write(LogLevel::info, "connected to the server"); }});
      if (connected) {
        session = std::move(*connected);
      } else if (connected.error().code != ErrorCode::unavailable) {
        return refuse(Error{connected.error().code, connected.error().message, url});
      } else {
        if (!std::exchange(waiting, true))
          log.write(LogLevel::info, "waits for the server at " + url + ": " + connected.error().message);
        std::this_thread::sleep_for(kRetryInterval);
      }
    }
    if (stop_requested) break;
    waiting = false;
    try {
      session->run();
    } catch (const std::exception& failure) {
      log.write(LogLevel::error, std::string("failed: ") + failure.what());
      return kExitFindings;
    }
    if (const Value refusal = session->refusal(); !refusal.is_null()) return refuse(refused(refusal));
    if (!stop_requested) log.write(LogLevel::warning, "lost the server: " + session->reason());
  }
  return kExitOk;
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.positional("GROUP", options->group, component_group_names());
  arguments.required_text("--server", "URL", options->server,
                          "http://127.0.0.1:8080, where it runs; waits for it, and reconnects");
  arguments.text("--token-file", "FILE", options->token_file,
                 "the token of the process: processes.token in the server's data folder, or that of an account; else "
                 "that in RACE_TOKEN, else data/processes.token");
  arguments.text("--folder", "DIR", options->folder,
                 "the cell: cell.json, or scene.json, parts.json, database.json; pictures; as its group needs them");
  arguments.text("--database", "FILE", options->database, "of the group database: where its values are kept");
  return [options] { return run_service(*options); };
}

}  // namespace

const Command kService = {"service", "runs one component group of a server's cell as a process, which may die",
                          declare};

}  // namespace race::server
