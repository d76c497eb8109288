// The interpreter: evaluates Code in an Environment. It belongs to one thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/language/compile/code.h"
#include "core/language/interface/environment.h"
#include "core/language/interface/fault.h"
#include "core/value/value.h"

namespace race::language {

/// Evaluates codes. One for each run; keeps its buffers between evaluations.
class Interpreter {
 public:
  struct Limits {
    std::uint64_t steps = 1'000'000;        // units of work: one for each evaluated syntax node, and values/work.h
    std::uint64_t value_units = 1'000'000;  // elements plus string bytes of one value
    /// If somebody sets it, every evaluation ends soon, with a `budget` fault, and so does a run at its next micro
    /// step: for work that nobody waits for any more, whose result is thrown away. Outlives the interpreter; null:
    /// nobody stops it.
    const std::atomic<bool>* stop = nullptr;
    bool is_told_to_stop() const { return stop && stop->load(std::memory_order_relaxed); }
  };
  Interpreter();
  explicit Interpreter(Limits limits);
  ~Interpreter();
  /// Between evaluations.
  void set_limits(Limits limits);
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
  /// Units of work of the last expression or function.
  std::uint64_t work() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace race::language
