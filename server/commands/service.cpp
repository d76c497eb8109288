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
#include "services/mutex.h"
#include "services/remote/socket_client.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

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

// The state of a connection, shared by the threads of the socket and of the group.
struct Session {
  std::atomic<bool> over{false};
  services::Mutex mutex;
  std::string why GUARDED_BY(mutex);               // it ended
  std::optional<Error> refused GUARDED_BY(mutex);  // by the server, for good

  void end(std::string reason) {
    const services::MutexLock lock(mutex);
    if (why.empty()) why = std::move(reason);
    over = true;
  }
  void end_invalid(const Error& error) { end("invalid message from the server: " + to_string(error)); }
  std::string reason() {
    const services::MutexLock lock(mutex);
    return why;
  }
  void refuse(const remote::Message& message) {
    const Value reason = message.value.as_list().empty() ? Value() : message.value.as_list().front();
    const auto text = [&](const char* field) {
      const Value* value = reason.find(field);
      return value && value->is_string() ? value->as_string() : std::string();
    };
    const services::MutexLock lock(mutex);
    refused = Error{ErrorCode::conflict, "the server refuses: " + text("message"), text("path")};
    over = true;
  }
};

// Handles a message of the server, on the socket's thread. The group may wait for a reply; all else is queued for the
// group.
void handle_message(const remote::EncodedMessage& encoded, remote::ProcessHost& process, Session& session, Log& log) {
  auto message = remote::decode(encoded, remote::Reader::process);
  if (!message) return session.end_invalid(message.error());
  if (message->kind == remote::Kind::refused) return session.refuse(*message);
  if (message->kind == remote::Kind::reply) return process.handle_reply(std::move(*message));
  if (message->kind == remote::Kind::welcome) log.write(LogLevel::info, "connected to the server");
  if (!process.receive(std::move(*message), encoded.bytes.size())) session.end("the server says more than is handled");
}

// Steps the group in real time while it is connected.
Expected<void> serve(remote::ProcessHost& process, Session& session) {
  auto next = steady_clock::now();
  while (!stop_requested && !session.over) {
    next += 1ms;
    std::this_thread::sleep_until(next);
    if (const auto now = steady_clock::now(); now - next > 100ms) next = now;
    if (auto stepped = process.step(); !stepped) session.end_invalid(stepped.error());
  }
  const services::MutexLock lock(session.mutex);
  if (session.refused) return tl::unexpected(*session.refused);
  return {};
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
    Session session;
    std::unique_ptr<remote::SocketClient> socket;
    while (!stop_requested && !socket) {
      const auto token = token_of_process(options.token_file);  // the server may have made it meanwhile
      if (!token) return refuse(token.error());
      auto connected = remote::SocketClient::connect(
          *address, *token, out,
          {[&](const remote::EncodedMessage& encoded) { handle_message(encoded, process, session, log); },
           [&](std::string why) { session.end(std::move(why)); }});
      if (connected) {
        socket = std::move(*connected);
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
    out.push(remote::encode(process.hello()).value());
    process.connect(out, [&] { return stop_requested || session.over; });
    try {
      if (auto served = serve(process, session); !served) return refuse(served.error());
    } catch (const std::exception& failure) {
      log.write(LogLevel::error, std::string("failed: ") + failure.what());
      return kExitFindings;
    }
    if (!stop_requested) log.write(LogLevel::warning, "lost the server: " + session.reason());
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
