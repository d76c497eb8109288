// EvaluationRecord: what the interpreter did in one evaluation: the parts of a condition or the statements of a
// function, and the service data that they read. Cond (4.12) and Func (4.16) make their premises from it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/language/interface/environment.h"
#include "core/semantics/derivation.h"

namespace race::semantics {

/// A part of a condition without and/or/not, which was evaluated: be of 4.11 or, with service data, bd of 4.10.
struct ConditionPart {
  bool service = false;
  language::Truth value = language::Truth::unknown;
};

/// A statement of a function, which was executed: st of 4.15, sd of 4.13, sc of 4.14.
struct Statement {
  enum class Kind : std::uint8_t { plain, service_data, service_call } kind = Kind::plain;
  std::size_t call = 0;  // of a service_call: which of StepEnvironment::calls
};

class EvaluationRecord final : public language::EvaluationTrace {
 public:
  void clear() {
    parts.clear();
    statements.clear();
    required.clear();
  }
  void atom(bool service, language::Truth value, SourceRange) override { parts.push_back({service, value}); }
  void statement(bool service, SourceRange) override {
    statements.push_back({service ? Statement::Kind::service_data : Statement::Kind::plain, 0});
  }
  void required_event(EventId event) override { require({RequiredDatum::Kind::event, event, {}}); }
  void required_response(OperationId operation, std::string_view service, bool error) override {
    require({error ? RequiredDatum::Kind::error : RequiredDatum::Kind::result, operation, std::string(service)});
  }

  std::vector<ConditionPart> parts;
  std::vector<Statement> statements;
  std::vector<RequiredDatum> required;  // ε, without repetition

 private:
  void require(RequiredDatum datum);
};

}  // namespace race::semantics
