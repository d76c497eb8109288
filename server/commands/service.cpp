// race service NAME: one group of a cell as a process; its services are those of the server.
#include <atomic>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <thread>

#include "server/cell/component_groups.h"
#include "server/commands/command.h"
#include "server/commands/options.h"
#include "services/remote/socket_client.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr auto kAgain = 500ms;  // from one try to reach the server to the next

std::atomic<bool> ended{false};  // by SIGINT or SIGTERM

void say(const std::string& text) {
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

// How a connection went, as the socket's thread and the group's see it.
struct Session {
  std::atomic<bool> over{false};
  std::mutex mutex;
  std::string why;               // it ended
  std::optional<Error> refused;  // by the server, for good

  void end(std::string reason) {
    const std::lock_guard lock(mutex);
    if (why.empty()) why = std::move(reason);
    over = true;
  }
  void refuse(const remote::Message& message) {
    const Value reason = message.value.as_list().empty() ? Value() : message.value.as_list().front();
    const auto text = [&](const char* field) {
      const Value* value = reason.find(field);
      return value && value->is_string() ? value->as_string() : std::string();
    };
    const std::lock_guard lock(mutex);
    refused = Error{ErrorCode::conflict, "the server refuses: " + text("message"), text("path")};
    over = true;
  }
};

// What the server says, on the socket's thread. The group may wait for a reply; all else waits for the group.
void take(const remote::EncodedMessage& encoded, remote::ProcessHost& process, Session& session,
          const std::string& name) {
  auto message = remote::decode(encoded, remote::Reader::process);
  const auto unfit = [&session](const Error& error) {
    session.end("the server says what does not fit: " + to_string(error));
  };
  if (!message) return unfit(message.error());
  if (message->kind == remote::Kind::refused) return session.refuse(*message);
  if (message->kind == remote::Kind::reply) return process.handle_reply(std::move(*message));
  if (message->kind == remote::Kind::welcome) say(name + " is there");
  process.queue().post([&process, unfit, message = std::move(*message)]() mutable {
    if (auto handled = process.handle(std::move(message)); !handled) unfit(handled.error());
  });
}

// Steps the group in real time while it is connected.
Expected<void> serve(remote::ProcessHost& process, Session& session) {
  auto next = steady_clock::now();
  while (!ended && !session.over) {
    next += 1ms;
    std::this_thread::sleep_until(next);
    if (const auto now = steady_clock::now(); now - next > 100ms) next = now;
    process.step();
  }
  const std::lock_guard lock(session.mutex);
  if (session.refused) return tl::unexpected(*session.refused);
  return {};
}

int be_a_service(const std::vector<std::string>& words) {
  const auto options = read_options(words, kService.arguments);
  if (!options) return refuse(options.error());
  if (options->rest.size() != 1 || !options->has("--server")) return misused(kService);
  const std::string& name = options->rest.front();
  const auto row = find_component_group(name);
  if (!row) return refuse(row.error());
  const std::string url = options->text("--server");
  const auto address = remote::read_address(url);
  if (!address) return refuse(address.error());
  const GroupSetup setup{options->text("--folder"), options->text("--database", ":memory:")};
  std::signal(SIGINT, [](int) { ended = true; });
  std::signal(SIGTERM, [](int) { ended = true; });

  bool waits = false;  // and has said so
  while (!ended) {
    // What was connected once is as good as dead afterwards: its services begin anew.
    remote::SendQueue out;
    remote::ProcessHost process;
    if (auto made = (*row)->make(setup, process); !made) return refuse(made.error());
    Session session;
    std::unique_ptr<remote::SocketClient> socket;
    while (!ended && !socket) {
      auto connected = remote::SocketClient::connect(
          *address, out,
          {[&](const remote::EncodedMessage& encoded) { take(encoded, process, session, name); },
           [&](std::string why) { session.end(std::move(why)); }});
      if (connected) {
        socket = std::move(*connected);
      } else if (connected.error().code != ErrorCode::unavailable) {
        return refuse(Error{connected.error().code, connected.error().message, url});
      } else {
        if (!std::exchange(waits, true))
          say(name + " waits for the server at " + url + ": " + connected.error().message);
        std::this_thread::sleep_for(kAgain);
      }
    }
    if (ended) break;
    waits = false;
    out.push(remote::encode(process.hello()).value());
    process.connect(out, [&] { return ended || session.over; });
    try {
      if (auto served = serve(process, session); !served) return refuse(served.error());
    } catch (const std::exception& failure) {
      std::fprintf(stderr, "%s: died: %s\n", name.c_str(), failure.what());
      return kFound;
    }
    if (!ended) say(name + " has lost the server: " + session.why);
  }
  return kFine;
}

}  // namespace

const Command kService = {
    "service", "UNIT --server URL [--folder DIR] [--database FILE]",
    "runs one unit of a server's cell as a process, which may die", be_a_service, [] {
      return "  UNIT              " + component_group_names() +
             "\n"
             "  --server URL      http://127.0.0.1:8080, where it runs; waits for it, and again when it was lost\n"
             "  --folder DIR      the cell: scene.json, parts.json, database.json, pictures, as its unit needs them\n"
             "  --database FILE   of the unit database: keeps its values; without, they die with the process\n";
    }};

}  // namespace race::server
