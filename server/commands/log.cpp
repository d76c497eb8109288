// race log: the log of a running server, its last lines; with --follow, also those that come (the channel `log` of
// api/asyncapi.yaml).
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/commands/ask_server.h"
#include "server/commands/command.h"
#include "server/commands/watching.h"

namespace race::server {
namespace {

struct Options {
  bool follow = false;
  ServerOptions server;
};

class LogPrinter {
 public:
  explicit LogPrinter(const Options& options) : options_(options) {}

  // Whether more is wanted.
  bool take(const Value& message) {
    const Value* kind = message.find("kind");
    const Value* data = message.find("data");
    const Value* entries = data ? data->find("entries") : nullptr;
    is_log_ = kind && kind->is_string() && entries && entries->is_list();
    if (data && data->find("errors")) refusal_ = *data;
    if (!is_log_) return false;
    print(entries->as_list(), kind->as_string() == "snapshot");
    return options_.follow;
  }
  bool is_log() const { return is_log_; }
  // Why there is no more of it (schemas/errors.json).
  const std::optional<Value>& refusal() const { return refusal_; }

 private:
  // A client that was too slow gets a snapshot again, which begins with what it has.
  void print(const List& entries, bool is_snapshot) {
    auto from = entries.begin();
    if (is_snapshot) {
      const auto last = std::find(entries.rbegin(), entries.rend(), last_);
      if (last != entries.rend()) from = last.base();
    }
    for (; from != entries.end(); ++from) print(*from);
    if (!entries.empty()) last_ = entries.back();
  }

  void print(const Value& entry) const {
    if (options_.server.json) {
      std::printf("%s\n", to_json(entry).c_str());
      return;
    }
    std::vector<Error> errors;
    Fields fields(entry, "", "the line", errors);
    const double time = fields.number("time").value_or(0);
    const std::string source = fields.text("source").value_or(""), text = fields.text("text").value_or("");
    std::printf("%10.3f  %-12s  %s\n", time, in_one_line(source).c_str(), in_one_line(text).c_str());
  }

  const Options& options_;
  Value last_;  // line that was printed
  bool is_log_ = true;
  std::optional<Value> refusal_;
};

int run(const Options& options) {
  const ServerOptions& server = options.server;
  const auto client = client_of(server);
  if (!client) return refuse(client.error(), server.json);
  if (options.follow) end_on_signal(kExitOk);
  LogPrinter printer(options);
  const auto followed = client->follow("log", [&printer](const Value& message) { return printer.take(message); });
  if (!followed) return refuse_connection(server, followed.error());
  if (printer.is_log()) return kExitOk;
  if (printer.refusal()) return refuse_answer(server, {0, *printer.refusal()});  // of no HTTP
  return refuse(Error{ErrorCode::io, "sends what is no log", server.url}, server.json);
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.flag("--follow", options->follow, "goes on until Ctrl-C");
  options->server.declare(arguments, "prints each line as a line of JSON (api/schemas/log_entry.json)");
  return [options] { return run(*options); };
}

}  // namespace

const Command kLog = {"log", "prints the log of a running server: seconds since its start, source and text", declare};

}  // namespace race::server
