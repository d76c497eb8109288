// The environment of an evaluation: what code reads, writes and calls, and who records it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/language/interface/ids.h"
#include "core/language/interface/service_table.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::language {

/// Kleene's three values, and the fault.
enum class Truth : std::uint8_t { no, yes, unknown, fault };

/// Records what an evaluation read, for derivations. Called only if an Environment has one.
class EvaluationTrace {
 public:
  virtual ~EvaluationTrace() = default;
  /// An atom of a condition (a maximal part without and/or/not), in evaluation order: `service` distinguishes CondBD
  /// (4.10) from CondBE (4.11). `value` is its truth.
  virtual void atom(bool service, Truth value, SourceRange where) = 0;
  /// A top-level statement of a function that is no call: `service` distinguishes FuncSD (4.13) from FuncST (4.15).
  virtual void statement(bool service, SourceRange where) = 0;
  /// Service data was read, found or not.
  virtual void required_event(EventId event) = 0;
  /// `service`: whose, if the operation is an open one.
  virtual void required_response(OperationId operation, std::string_view service, bool error) = 0;
};

/// What code sees and does when it is evaluated: Δ and Σ for reading, writes and calls through functions. Writes and
/// calls are buffered by the owner and undone if the function ends unmet or with a fault.
class Environment {
 public:
  virtual ~Environment() = default;

  const Value* values = nullptr;          // Δ by ValueIndex; unknown = has no value
  const std::uint8_t* flags = nullptr;    // Δ by Flag
  const Value* event_data = nullptr;      // newest data ever delivered by EventId; unknown = never
  const std::uint8_t* sampled = nullptr;  // by EventId
  EventId occurrence = kNone;             // the event whose occurrence this evaluation sees; R21 hides it by kNone
  EvaluationTrace* trace = nullptr;

  /// The response to an operation that counts in the state whose code runs (R6, R20); unknown if there is none.
  /// `service`: whose, if the operation is an open one.
  virtual const Value& response(OperationId operation, std::string_view service, bool error) = 0;
  /// A write to res or var. `values[slot]` reads the new value afterwards. Finite (checked by the interpreter).
  virtual void write(ValueIndex slot, Value value) = 0;
  /// A call, in order of evaluation.
  virtual void call(OperationId operation, std::string_view service, std::string_view name, List args, Dict kwargs) = 0;
  /// The table for svc[expr].
  virtual const ServiceTable& services() const = 0;
  /// print() and other output of a function; for people, never semantic.
  virtual void print(std::string text) = 0;
};

}  // namespace race::language
