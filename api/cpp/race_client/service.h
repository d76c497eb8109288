// Services of one's own: a program says what it offers, and does it; tasks call it as `svc.KEY.OPERATION(...)`.
//
//   int main(int argc, char** argv) {
//     race::client::Service lamp("lamp");
//     lamp.operation("switch").parameter("on", "bool").does([](race::client::Call& call) {
//       std::puts(call.flag("on") ? "on" : "off");
//     });
//     return lamp.run(argc, argv);
//   }
//
// `run` connects to the server, and again when the connection is lost. The server holds what the service announces
// against its RSM, which is made of the declaration, or given: what does not fit is shown at its line.
//
// Threads: a Service is declared and run on one; what says so may be used on any.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <source_location>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/value/value.h"
#include "services/types.h"

namespace race::client {

namespace types = services::types;  // of RSM: types::record({{"width", "number"}}); a plain one is its name, "number"

struct DeclaredOperation;
struct RunningCall;

/// Thrown by a handler: the error that answers its call. `code` is what tasks branch on; `more`: further fields.
class Failure : public std::exception {
 public:
  explicit Failure(std::string_view code, std::string message = {}, const Dict& more = {});
  const char* what() const noexcept override { return message_.c_str(); }
  /// {"code", "message", ...}
  const Value& error() const { return error_; }

 private:
  std::string message_;
  Value error_;
};

/// Thrown by Call::pause() when the call is over. No std::exception, so that no handler takes it for a failure of its
/// device: end what moves, and let it pass.
struct Stopped {};

/// A call while its handler is at work; on the handler's thread.
class Call {
 public:
  /// By name, with the values that the declaration has for those which were not given. They fit the RSM.
  const Dict& arguments() const { return arguments_; }
  /// An argument of this kind. std::invalid_argument: the operation has no such parameter, or it was not given, or is
  /// of another type.
  double number(std::string_view parameter) const;
  std::int64_t integer(std::string_view parameter) const;
  bool flag(std::string_view parameter) const;
  const std::string& text(std::string_view parameter) const;

  /// Waits. Stopped: the call is over, as another operation has stopped it, a later one has its place, or the server is
  /// lost or silent. In a handler that is not busy, and while a service halts, it waits only.
  void pause(double seconds) const;
  /// Whether the call is over.
  bool stopped() const;

 private:
  friend class Hosted;
  Call(RunningCall& call, Dict arguments) : call_(call), arguments_(std::move(arguments)) {}

  RunningCall& call_;
  Dict arguments_;
};

/// What is said of a parameter beside its name and type. Units are SI; `value`: if it is not given.
struct Parameter {
  std::string unit = {};
  std::optional<double> min = {}, max = {};
  std::optional<Value> value = {};
  std::string doc = {};
};

/// What is said of an event beside its name and type, as in an RSM.
struct Event {
  bool sampled = false;  // only the newest that waits counts
  std::optional<double> rate_hz = {};
  std::string doc = {};
};

/// Declares an operation further: part of its Service, which outlives it.
class Operation {
 public:
  using Handler = std::function<Value(Call&)>;

  /// It may set something in the cell in motion.
  Operation& moves();
  /// It stops what is in motion; called without arguments, also when the cell is stopped, and when the server is lost.
  Operation& safe();
  /// It changes nothing.
  Operation& reads();
  /// The service is in this state until the handler returns; meanwhile it takes this operation, and others that are
  /// busy, not again. The handler has a thread of its own. All others share one and are to be short.
  Operation& busy(std::string state);
  /// Ends what is busy in this state, with the error `stopped`.
  Operation& stops(std::string state);
  Operation& parameter(std::string name, Value type = {}, Parameter more = {});
  /// The type of what the handler returns.
  Operation& result(Value type);
  Operation& doc(std::string text);

  /// What it does: a function of a Call& or of nothing, which returns the result as a Value, or nothing. What it throws
  /// is the error.
  template <typename Function>
  void does(Function function) {
    set_handler([function = std::move(function)]([[maybe_unused]] Call& call) mutable -> Value {
      if constexpr (std::is_invocable_v<Function&>)
        return value_of([&]() -> decltype(auto) { return function(); });
      else
        return value_of([&]() -> decltype(auto) { return function(call); });
    });
  }

 private:
  friend class Service;
  explicit Operation(DeclaredOperation& declared) : declared_(declared) {}

  template <typename Run>
  static Value value_of(Run run) {
    if constexpr (std::is_void_v<decltype(run())>) {
      run();
      return {};
    } else {
      return run();
    }
  }
  void set_handler(Handler handler);

  DeclaredOperation& declared_;
};

/// A service; it begins anew in the first state of its RSM each time when the server is connected.
class Service {
 public:
  using Place = std::source_location;  // where it is declared

  /// `key`: as in svc.KEY; a name of at most 64 letters, digits and `_`.
  explicit Service(std::string key, Place place = Place::current());
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;
  /// Waits for handlers that are at work.
  ~Service();

  // Before run().

  /// What kind of service it is; its key, if nothing is said.
  void type(std::string name);
  /// For people: the RSM has it as `meta.version`.
  void version(std::string text);
  /// An event that emit() announces; `type` of its data.
  void event(std::string name, Value type = {}, Event more = {}, Place place = Place::current());
  /// An operation, to be declared further: service.operation("stop").safe().does(...).
  Operation operation(std::string name, Place place = Place::current());
  /// An RSM of one's own, as JSON or in a file of it: operations then have nothing but a name and what they do.
  void rsm(std::string json);
  void rsm_file(std::string path);
  /// What is done when the server is lost or silent, so that nothing moves; else the `safe` operations are called.
  void on_halt(std::function<void()> function);

  // On any thread. Without a server, nobody hears of it.

  /// Announces an event. std::invalid_argument: no JSON can say it.
  void emit(std::string_view event, Value data = {});
  /// Takes a transition of the RSM that no call brings, by its id. Those that answer calls are taken when their
  /// handlers end. std::invalid_argument: there is none.
  void take(std::string_view transition);
  /// A line for people in the log of the server; at most 300 bytes of it.
  void log(std::string_view text);
  /// The present state of the RSM; empty: the service is not connected.
  std::string state() const;
  /// What moves must not be faster [m/s], whatever was asked for; nothing: there is no limit.
  std::optional<double> speed_limit() const;

  /// Offers it as run() below.
  int run(int argc, char** argv);

 private:
  friend int run(int argc, char** argv, std::initializer_list<Service*> services);
  struct State;
  std::unique_ptr<State> state_;
};

/// Offers services until SIGINT or SIGTERM, as the command line says (README.md), and returns the exit status of the
/// program: 0, 1 if it fails, or 2 if the command line or a declaration is wrong, or the server refuses them. Once in a
/// process. Handlers that do not end within two seconds then end with the process, here.
int run(int argc, char** argv, std::initializer_list<Service*> services);

}  // namespace race::client
