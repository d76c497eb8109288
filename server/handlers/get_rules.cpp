// GET /api/v1/rules: the rules of the semantics, from their one table.
#include "core/semantics/rules.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_rules(const Request&) {
  List rules;
  for (const semantics::RuleInfo& rule : semantics::kRules)
    rules.emplace_back(
        Dict{{"rule", rule.name}, {"equation", rule.equation}, {"layer", rule.layer}, {"text", rule.text}});
  return ok(Dict{{"rules", std::move(rules)}});
}

}  // namespace race::server
