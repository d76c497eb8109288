// race mcp: a server of the Model Context Protocol on stdin and stdout, for a client that starts it (server/mcp).
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>

#include "server/commands/ask_server.h"
#include "server/commands/command.h"
#include "server/mcp/line_reader.h"
#include "server/mcp/output.h"
#include "server/mcp/session.h"

namespace race::server {
namespace {

constexpr std::size_t kMaxLine = std::size_t{16} * 1024 * 1024;
// Twice this, and it ends within a second.
constexpr std::chrono::milliseconds kLastTime{300};

int run(const ServerOptions& options) {
  auto client = client_of(options);
  if (!client) return refuse(client.error());
  std::signal(SIGPIPE, SIG_IGN);  // who reads nothing any more has also closed our input
  mcp::Output output(STDOUT_FILENO, STDIN_FILENO);
  mcp::Session session(std::move(*client), [&output](const Value& message) { output.send(message); });
  mcp::LineReader lines(STDIN_FILENO, kMaxLine);
  while (const auto line = lines.next()) {
    if (*line)
      session.receive(**line);
    else
      session.refuse(line->error());
  }
  if (!session.end(kLastTime)) std::_Exit(kExitOk);  // a request hangs; what it asked, it has asked
  return kExitOk;
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<ServerOptions>();
  options->declare(arguments);
  return [options] { return run(*options); };
}

}  // namespace

const Command kMcp = {
    "mcp", "offers a running server to a language-model agent (Model Context Protocol, on stdin and stdout)", declare};

}  // namespace race::server
