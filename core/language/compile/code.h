// Code: a compiled condition, expression or function of a state, ready to be evaluated many times. Names are resolved
// at compile time: Δ is read by number.
//
// Threads: a Code is immutable (its constants are frozen) and shared.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/language/interface/ids.h"
#include "core/language/interface/service_table.h"
#include "core/language/interface/symbols.h"
#include "core/value/expected.h"

namespace race::language {

/// What a Code can read, write and call, found at compile time. Used for R9, R19, R21, to skip conditions whose inputs
/// did not change, and for verification. Sorted, without repetition. `svc[expr].x` counts as x of every service
/// of the table and as the open operation x.
struct Mentions {
  bool svc = false;                    // `svc` occurs, calls included
  std::vector<EventId> events;         // occurrence or data, but not `.latest`
  std::vector<EventId> latest;         // read through `.latest`
  std::vector<OperationId> responses;  // .result or .error is read
  std::vector<OperationId> calls;
  std::vector<ValueIndex> reads, writes;  // of Δ; par, res or var as a whole reads all of its slots
  std::vector<Flag> flags;
  bool needs_occurrence = false;  // a condition that is never true, and no fault, while no event occurs (kSmallBudget)
};

/// A budget of this many steps is enough for every condition with `needs_occurrence`.
inline constexpr std::uint64_t kSmallBudget = 64;

class Program;  // the compiled form (program.h)

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

/// Compiles a text that check() found nothing in. Names of service data that the table does not know are added to it:
/// `.result` or `.error` after an unknown name makes it an operation.
Checked<Code> compile(std::string_view text, CodeKind kind, const Symbols& symbols, ServiceTable& services);

}  // namespace race::language
