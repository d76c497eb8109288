// race trace ID | --run NUMBER: the derivations of a run at a running server, as `race derive` prints them; with
// --follow, as it goes on.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <thread>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/commands/ask_server.h"
#include "server/commands/command.h"
#include "server/commands/core_line.h"
#include "server/commands/print_derivations.h"
#include "server/commands/watching.h"
#include "server/http/encode_part.h"
#include "server/wire/run_status.h"

namespace race::server {
namespace {

constexpr std::int64_t kAtOnce = 100;  // steps of an answer
constexpr int kTries = 50;             // while it is busy: ten seconds long

struct Options {
  std::optional<std::string> core, run;
  double first = 1;
  bool follow = false;
  ServerOptions server;
};

// How far a run is.
struct Reached {
  std::int64_t steps = 0;  // that are complete
  bool is_over = false;
  Value status;  // with `status`, `outcome` and `fault`
};

// schemas/core.json or run.json. Error `io`: it is none.
Expected<Reached> read_reached(const Value& answer, bool is_core) {
  std::vector<Error> errors;
  Fields fields(answer, "", "the run", errors);
  constexpr std::int64_t kMany = std::numeric_limits<std::int64_t>::max();
  const auto status = fields.text("status", kRequired);
  const auto steps = fields.integer(is_core ? "step" : "steps", 0, kMany, kRequired);
  const auto micro = fields.integer("micro", 0, kMany);
  if (!errors.empty()) return unexpected(ErrorCode::io, "answers what is no run");
  const bool is_over = server::is_over(*status);
  const bool is_within = !is_over && micro.value_or(0) > 0;  // of a step that is not complete
  return Reached{*steps - (is_within ? 1 : 0), is_over, answer};
}

class Trace {
 public:
  explicit Trace(const Options& options)
      : options_(options),
        path_(options.core ? core_path(*options.core) : "/api/v1/runs/" + encode_part(*options.run)),
        next_(static_cast<std::int64_t>(options.first)),
        printer_(!options.server.json, static_cast<std::size_t>(next_)) {}

  // Gives the exit code.
  int print() {
    for (;; std::this_thread::sleep_for(kPollPause)) {
      const auto answer = ask_patiently(path_);
      if (!answer) return answer.error();
      const auto reached = read_reached(*answer, options_.core.has_value());
      if (!reached) return refuse(Error{reached.error().code, reached.error().message, options_.server.url});
      for (bool all = true; all && next_ <= reached->steps;) {
        const auto printed = print_steps(reached->steps);
        if (!printed) return printed.error();
        all = *printed;
      }
      if (reached->is_over || !options_.follow) return printer_.print_end(reached->status);
    }
  }

 private:
  // Some of the steps up to this one. False: one is not complete yet, as the run is paused in it.
  tl::expected<bool, int> print_steps(std::int64_t last) {
    const std::int64_t to = std::min(last, next_ + kAtOnce - 1);
    auto document = ask_patiently(path_ + "/derivations?from=" + std::to_string(next_) + "&to=" + std::to_string(to));
    if (!document) return tl::unexpected(document.error());
    const Value* steps = document->find("steps");
    if (!steps || !steps->is_list() || steps->as_list().empty())
      return tl::unexpected(refuse(Error{ErrorCode::io, "answers no derivations", options_.server.url}));
    List complete = steps->as_list();
    const Value* is_complete = complete.back().find("complete");
    const bool all = !is_complete || *is_complete != Value(false);
    if (!all) complete.pop_back();
    next_ += static_cast<std::int64_t>(complete.size());
    document->mutable_dict().set("steps", std::move(complete));
    printer_.print_steps(*document);
    return all;
  }

  // A server that is busy with the run, or with replays, is asked again.
  tl::expected<Value, int> ask_patiently(const std::string& target) const {
    for (int tries = 1;; ++tries) {
      auto answer = request_server(options_.server, "GET", target);
      if (!answer) return tl::unexpected(answer.error());
      if (is_fine(*answer)) return std::move(answer->body);
      if (answer->status != kBusy || tries == kTries) return tl::unexpected(refuse_answer(options_.server, *answer));
      std::this_thread::sleep_for(kPollPause);
    }
  }

  const Options& options_;
  const std::string path_;
  std::int64_t next_;  // step to print
  DerivationPrinter printer_;
};

int run(const Options& options) {
  if (options.core.has_value() == options.run.has_value())
    return refuse(Error{options.core ? ErrorCode::syntax : ErrorCode::missing,
                        "the form is `race trace ID`, of a core, or `race trace --run NUMBER`", "ID"},
                  options.server.json);
  if (options.follow) end_on_signal(kExitOk);
  return Trace(options).print();
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.positional("ID", options->core, "the core that has the run");
  arguments.text("--run", "NUMBER", options->run, "a stored run, instead");
  arguments.number("--first", "N", options->first, {1, 1e9, true}, "the first macro step");
  arguments.flag("--follow", options->follow, "goes on until the run is over, or Ctrl-C");
  options->server.declare(arguments, "prints each macro step as a line of JSON (api/schemas/trace_step.json)");
  return [options] { return run(*options); };
}

}  // namespace

const Command kTrace = {"trace", "prints the derivations of a run at a running server; 1: it has faulted", declare};

}  // namespace race::server
