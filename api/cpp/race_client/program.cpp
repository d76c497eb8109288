#include "api/cpp/race_client/program.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "api/cpp/race_client/options.h"
#include "api/cpp/race_client/say.h"
#include "services/remote/process_session.h"

namespace race::client {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr std::array kRetries = {100ms, 200ms, 500ms, 1000ms};  // between attempts; the last again and again
constexpr auto kTakenTime = 10s;                                // for a process that was there before to be missed
constexpr double kHandlerTime = 2;                              // [s] for handlers to end

constexpr int kExitFailed = 1, kExitRefused = 2;

std::atomic<bool> stop_requested{false};  // by SIGINT or SIGTERM

void sleep_unless_stopped(std::chrono::milliseconds time) {
  const auto end = steady_clock::now() + time;
  while (!stop_requested && steady_clock::now() < end) std::this_thread::sleep_for(10ms);
}

std::string text_of(const Value& error, std::string_view field) {
  const Value* text = error.find(field);
  return text && text->is_string() ? text->as_string() : std::string();
}

// What became of one connection, or of an attempt to make one.
struct Ended {
  std::string why = {};
  Value refusal = {};  // of the server, a list of errors; null: it did not refuse
  bool was_welcome = false;
  bool is_final = false;  // it makes no sense to try again
};

class Offering {
 public:
  Offering(const std::vector<Hosted*>& services, const Options& options) : services_(services), options_(options) {
    for (const Hosted* each : services) keys_ += (keys_.empty() ? "" : ", ") + each->declaration().key;
  }

  // The exit status.
  int run() {
    while (!stop_requested) {
      const auto began = steady_clock::now();
      const Ended ended = offer();
      if (ended.is_final) {
        say(ended.why);
        return kExitRefused;
      }
      if (ended.was_welcome) {  // it connects again, whatever ended the connection
        taken_since_.reset();
        if (steady_clock::now() > began + kRetries.back()) attempts_ = 0;
      } else if (!ended.refusal.is_null() && !may_pass(ended)) {
        return refused(ended.refusal);
      }
      if (stop_requested) break;
      if (ended.was_welcome || attempts_ == 0) say(keys_ + ": " + ended.why);
      sleep_unless_stopped(kRetries[std::min(attempts_++, kRetries.size() - 1)]);
    }
    return 0;
  }

 private:
  Ended offer() {
    remote::SendQueue out;
    remote::ProcessHost process;
    process.ask_for_violations();
    for (Hosted* each : services_) {
      const Declaration& declaration = each->declaration();
      services::ServiceHost& host = process.declare(declaration.key, declaration.type);
      process.attach(declaration.key, each->component(host));
    }
    const auto token = find_token(options_.token_file);  // the server may have made it meanwhile
    if (!token) return {.why = to_string(token.error()), .is_final = true};
    std::atomic<bool> is_welcome{false};
    auto session = remote::ProcessSession::connect(options_.address, *token, process, out,
                                                   {stop_requested, [&] {
                                                      is_welcome = true;
                                                      for (const Hosted* each : services_)
                                                        say(each->declaration().key + ": connected");
                                                    }});
    if (!session && session.error().code == ErrorCode::unavailable)
      return {.why = "waits for the server at " + options_.server + ": " + session.error().message};
    if (!session) return {.why = options_.server + ": " + to_string(session.error()), .is_final = true};
    serve(**session);
    const std::string why = is_welcome ? "lost the server: " : "";
    return {.why = why + (*session)->reason(), .refusal = (*session)->refusal(), .was_welcome = is_welcome};
  }

  // Until the connection is over; what moves is halted before it is closed.
  void serve(remote::ProcessSession& session) {
    const auto lose = [&] {
      for (Hosted* each : services_) each->lost();
    };
    for (Hosted* each : services_) each->connected();
    try {
      session.run();
    } catch (...) {
      lose();
      throw;
    }
    lose();
  }

  // Whether the server may accept them soon: it has not missed yet the process that was there before.
  bool may_pass(const Ended& ended) {
    const bool is_taken = std::ranges::any_of(ended.refusal.as_list(), [](const Value& error) {
      return text_of(error, "message").ends_with("has a process already");
    });
    const auto now = steady_clock::now();
    if (is_taken && !taken_since_) taken_since_ = now;
    return is_taken && now < *taken_since_ + kTakenTime;
  }

  int refused(const Value& refusal) const {
    for (const Value& error : refusal.as_list()) {
      const std::string key = text_of(error, "path");
      const auto of = std::ranges::find(services_, key, [](const Hosted* each) { return each->declaration().key; });
      const Declaration& declaration = (of == services_.end() ? services_.front() : *of)->declaration();
      say(place_of(declaration, {}) + ": error: " + declaration.key + ": " + text_of(error, "code") + ": " +
          text_of(error, "message"));
    }
    return kExitRefused;
  }

  const std::vector<Hosted*>& services_;
  const Options& options_;
  std::string keys_;
  std::size_t attempts_ = 0;  // since the server was there
  std::optional<steady_clock::time_point> taken_since_;
};

// Sets the RSM of each. What is wrong; empty: nothing.
std::string prepare(const std::vector<Hosted*>& services) {
  if (services.empty()) return "there is no service";
  std::set<std::string> keys;
  for (Hosted* each : services) {
    auto model = model_of(each->declaration());
    if (!model) return model.error();
    each->set_model(std::move(*model));
    if (const std::string& key = each->declaration().key; !keys.insert(key).second)
      return place_of(each->declaration(), {}) + ": error: two services have the key " + quote(key);
  }
  return {};
}

int offer_all(const std::vector<Hosted*>& services, const Options& options) {
  try {
    return Offering(services, options).run();
  } catch (const std::exception& failure) {
    say(std::string("failed: ") + failure.what());
    return kExitFailed;
  }
}

}  // namespace

int run_program(int argc, char** argv, const std::vector<Hosted*>& services) {
  const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  const auto options = read_options(arguments);
  if (!options) {
    say(to_string(options.error()) + "\n" + kHelp);
    return kExitRefused;
  }
  if (options->help) {
    std::puts(kHelp);
    return 0;
  }
  if (std::string wrong = prepare(services); !wrong.empty()) {
    say(std::move(wrong));
    return kExitRefused;
  }
  std::signal(SIGPIPE, SIG_IGN);  // of a log that nobody reads any more
  std::signal(SIGINT, [](int) { stop_requested = true; });
  std::signal(SIGTERM, [](int) { stop_requested = true; });
  const int status = offer_all(services, *options);
  for (Hosted* each : services) {
    if (each->wait_for_handlers(kHandlerTime)) continue;
    say(each->declaration().key + ": a handler does not end; it ends with the process");
    std::fflush(stdout);
    std::_Exit(status);
  }
  return status;
}

}  // namespace race::client
