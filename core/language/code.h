// Code: a compiled condition, expression or function of a state, ready to be evaluated many times; and what it needs to
// be compiled (Symbols, ServiceTable) and evaluated (Environment). Names are resolved at compile time: Δ is read by
// number.
//
// Threads: a Code is immutable (its constants are frozen) and shared; an Interpreter belongs to one thread.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::language {

/// Where a parameter, result or variable has its value in Δ.
using Slot = std::uint32_t;
/// Where `active` of a node or a port stands in Δ.
using Flag = std::uint32_t;
using EventId = std::uint32_t;
using OperationId = std::uint32_t;
inline constexpr std::uint32_t kNone = 0xffffffff;

enum class CodeKind : std::uint8_t {
  condition,   // COND: ports and actions, three-valued
  expression,  // EXPR: `from` of a parameter; scope of the parent, no svc, no port
  function,    // CODE: entry, exit, actions
};

/// The names that code of one state may use (SEMANTICS.md section 2, Scopes), each with its place in Δ. The checker
/// uses the names alone.
struct ChildSymbols {
  bool barrier = false;  // a barrier has `active` and `name` only
  Flag active = 0;
  std::map<std::string, Slot, std::less<>> parameters, results;
  std::map<std::string, Flag, std::less<>> ports;
};
struct Symbols {
  std::map<std::string, Slot, std::less<>> parameters, results;
  std::map<std::string, Slot, std::less<>>
      variables;  // declared ones, and for compiling all that any code of the state uses
  std::map<std::string, Flag, std::less<>> ports;
  std::map<std::string, ChildSymbols, std::less<>> children;
};

/// Every service event and operation that a program can name, by number. Built from the services that are known (their
/// declarations), extended by `event()` and `operation()` with names that no declaration has.
///
/// `svc[expr].op` may name an operation that the table does not have. For these there is one entry per name, the *open*
/// operation `op`: it stands for all services without an entry of that name.
class ServiceTable {
 public:
  struct Event {
    std::string service, name;
    bool sampled = false;
    bool declared = false;  // by its service; else only named by code
  };
  struct Operation {
    std::string service, name;  // no service: an open one
    bool safe = false;
    bool declared = false;
    bool open = false;
  };
  /// Adds a declared event or operation; returns its number (the old one, updated, if it is there).
  EventId declare_event(std::string_view service, std::string_view name, bool sampled);
  OperationId declare_operation(std::string_view service, std::string_view name, bool safe);
  /// The number of a name, added undeclared (not sampled, not safe) if it is new.
  EventId event(std::string_view service, std::string_view name);
  OperationId operation(std::string_view service, std::string_view name);
  /// kNone if the table does not have it.
  EventId find_event(std::string_view service, std::string_view name) const;
  OperationId find_operation(std::string_view service, std::string_view name) const;
  /// The number of the open operation of this name, added if it is new.
  OperationId open_operation(std::string_view name);
  bool is_open(OperationId operation) const { return operations_[operation].open; }
  /// What svc[service].name is: the entry if there is one, else the open operation. kNone if there is neither.
  OperationId dynamic_operation(std::string_view service, std::string_view name) const;
  const std::vector<Event>& events() const { return events_; }
  const std::vector<Operation>& operations() const { return operations_; }
  /// Services that have declared an event or operation, in order of appearance.
  std::vector<std::string> declared_services() const;

 private:
  using Key = std::pair<std::string, std::string>;
  std::vector<Event> events_;
  std::vector<Operation> operations_;
  std::map<Key, std::uint32_t> event_ids_, operation_ids_;
  std::map<std::string, OperationId, std::less<>> open_ids_;
};

/// What a Code can read and do, found at compile time: the ground for R9, R19, R21, for skipping conditions whose
/// inputs did not change, and for verification. Sorted, without repetition. `svc[expr].x` counts as x of every service
/// of the table and as the open operation x.
struct Mentions {
  bool svc = false;                    // `svc` occurs, calls included
  std::vector<EventId> events;         // occurrence or data, but not `.latest`
  std::vector<EventId> latest;         // read through `.latest`
  std::vector<OperationId> responses;  // .result or .error is read
  std::vector<OperationId> calls;
  std::vector<Slot> reads, writes;  // of Δ; a bare par/res/var reads all of its slots
  std::vector<Flag> flags;
  bool needs_occurrence = false;  // a condition that is never true, and no fault, while no event occurs (kFewUnits)
};

/// A budget of so many steps is enough for every condition with `needs_occurrence`.
inline constexpr std::uint64_t kFewUnits = 64;

enum class FaultKind : std::uint8_t {
  type,
  missing,
  zero_division,
  overflow,
  budget,
  value,
  name,
  unmet,
  unresolved,
  divergence
};
std::string_view name(FaultKind kind);

struct Fault {
  FaultKind kind = FaultKind::type;
  std::string message;
  SourceRange where;
};

/// Kleene's three values, and the fault.
enum class Truth : std::uint8_t { no, yes, unknown, fault };

/// What an evaluation touched, for derivations and explanations. Called only if an Environment has one.
class EvaluationTrace {
 public:
  virtual ~EvaluationTrace() = default;
  /// An atom of a condition (a maximal part without and/or/not), in evaluation order: `service` tells CondBD (4.10)
  /// from CondBE (4.11). `value` is its truth.
  virtual void atom(bool service, Truth value, SourceRange where) = 0;
  /// A top-level statement of a function that is no call: `service` tells FuncSD (4.13) from FuncST (4.15).
  virtual void statement(bool service, SourceRange where) = 0;
  /// Service data was read, found or not.
  virtual void required_event(EventId event) = 0;
  /// `service`: whose, if the operation is an open one.
  virtual void required_response(OperationId operation, std::string_view service, bool error) = 0;
};

/// What code sees and does when it is evaluated: Δ and Σ for reading, writes and calls through functions. Writes and
/// calls are buffered by the owner and undone when the function turns out unmet or faulty.
class Environment {
 public:
  virtual ~Environment() = default;

  const Value* values = nullptr;          // Δ by Slot; unknown = has no value
  const std::uint8_t* flags = nullptr;    // Δ by Flag
  const Value* event_data = nullptr;      // newest data ever delivered by EventId; unknown = never
  const std::uint8_t* sampled = nullptr;  // by EventId
  EventId occurrence = kNone;             // the event whose occurrence this evaluation sees; R21 hides it by kNone
  EvaluationTrace* trace = nullptr;

  /// The response to an operation that counts in the state whose code runs (R6, R20); unknown if there is none.
  /// `service`: whose, if the operation is an open one.
  virtual const Value& response(OperationId operation, std::string_view service, bool error) = 0;
  /// A write to res or var. `values[slot]` reads the new value afterwards. Finite (checked by the interpreter).
  virtual void write(Slot slot, Value value) = 0;
  /// A call, in order of evaluation.
  virtual void call(OperationId operation, std::string_view service, std::string_view name, List args, Dict kwargs) = 0;
  /// The table for svc[expr].
  virtual const ServiceTable& services() const = 0;
  /// print() and other output of a function; for people, never semantic.
  virtual void print(std::string text) = 0;
};

class Program;  // the compiled form, internal to this room

/// A compiled code. Copies share it.
class Code {
 public:
  Code() = default;
  explicit operator bool() const { return program_ != nullptr; }
  CodeKind kind() const;
  const std::string& text() const;
  const Mentions& mentions() const;
  const Program& program() const { return *program_; }

 private:
  friend class Compiler;
  std::shared_ptr<const Program> program_;  // held by all copies of this Code
};

/// All violations of `text` as code of a state with these names: `syntax`, `forbidden`, `scope`, `effect`,
/// `service_call`, `unknown_name`. Empty = it compiles. Paths are left to the caller.
std::vector<Error> check(std::string_view text, CodeKind kind, const Symbols& symbols);

/// The names after `var.` in `text`, declared or not. Empty for code that does not parse.
std::vector<std::string> variable_names(std::string_view text);

/// Compiles a text that check() found nothing in. Names of service data that the table does not know are added to it:
/// `.result` or `.error` after an unknown name makes it an operation.
Checked<Code> compile(std::string_view text, CodeKind kind, const Symbols& symbols, ServiceTable& services);

/// Evaluates codes. One for each run; keeps its buffers between evaluations.
class Interpreter {
 public:
  struct Limits {
    std::uint64_t steps = 100'000;          // one unit for each evaluated syntax node
    std::uint64_t value_units = 1'000'000;  // elements plus string bytes of one value
  };
  Interpreter();
  explicit Interpreter(Limits limits);
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  /// A condition; Truth::fault leaves the reason in fault().
  Truth condition(const Code& code, Environment& environment);
  /// A parameter's expression: its value, unknown, or nothing (see fault()).
  std::optional<Value> expression(const Code& code, Environment& environment);
  enum class Outcome : std::uint8_t { done, unmet, fault };
  /// A function. When it is not `done`, the caller undoes its writes and calls.
  Outcome function(const Code& code, Environment& environment);
  /// Of the last evaluation that faulted; also says what was unknown when a function was unmet.
  const Fault& fault() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace race::language
