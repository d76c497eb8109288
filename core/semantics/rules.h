// The list of all rules: the one place where their names, equations and texts stand. Derivations, tests,
// core/SEMANTICS.md and the browser pages read them here.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace race::semantics {

enum class Rule : std::uint8_t {
  Active,
  Act,
  Deact,
  BIn,
  Activated,
  Resolve,
  Cond,
  CondBE,
  CondBD,
  Func,
  FuncST,
  FuncSD,
  FuncSC,
  Action1,
  Action2,
  Action3,
  SDeact1,
  SDeact2,
  BDeact,
  SAct1,
  SAct2,
  BAct1,
  BAct2,
  BAct3,
  PTrigger,
  PTrans1,
  PTrans2,
  SProp,
  Micro,
};

/// One row of the table. `text` says in one sentence what the rule does, for the people who watch a derivation.
struct RuleInfo {
  Rule rule;
  std::string_view name, equation, layer, text;
};

inline constexpr std::array kRules = {
    RuleInfo{Rule::Active, "Active", "3.8", "atomic", "Reads whether a state, barrier or port is active."},
    RuleInfo{Rule::Act, "Act", "3.9", "atomic", "Makes a state, barrier or port active."},
    RuleInfo{Rule::Deact, "Deact", "3.10", "atomic", "Makes a state, barrier or port inactive."},
    RuleInfo{Rule::BIn, "BIn", "3.11", "atomic", "Registers the arrival of an inbound port at a barrier."},
    RuleInfo{Rule::Activated, "Activated", "3.12", "atomic",
             "Reads whether an inbound port has arrived at its barrier."},
    RuleInfo{Rule::Resolve, "Resolve", "3.13", "atomic",
             "Gives a parameter its value: a constant, or its expression in the scope of the parent."},
    RuleInfo{Rule::Cond, "Cond", "4.12", "atomic", "Evaluates a condition from its parts."},
    RuleInfo{Rule::CondBE, "CondBE", "4.11", "atomic", "A part of a condition that reads the model alone."},
    RuleInfo{Rule::CondBD, "CondBD", "4.10", "atomic", "A part of a condition that reads data of a service."},
    RuleInfo{Rule::Func, "Func", "4.16", "atomic", "Executes a function: its statements, in order."},
    RuleInfo{Rule::FuncST, "FuncST", "4.15", "atomic", "A statement that needs no service."},
    RuleInfo{Rule::FuncSD, "FuncSD", "4.13", "atomic", "A statement that reads data of a service."},
    RuleInfo{Rule::FuncSC, "FuncSC", "4.14", "atomic", "A statement that calls an operation of a service."},
    RuleInfo{Rule::Action1, "Action1", "4.17", "atomic",
             "The condition is fulfilled and the action has not been executed in this macro step: it is executed."},
    RuleInfo{Rule::Action2, "Action2", "3.17", "atomic", "The action has been served already: nothing happens."},
    RuleInfo{Rule::Action3, "Action3", "4.18", "atomic",
             "The condition of the action is not fulfilled: nothing happens."},
    RuleInfo{Rule::SDeact1, "SDeact1", "3.19", "activation",
             "Leaving an inactive state: its active ports become inactive."},
    RuleInfo{Rule::SDeact2, "SDeact2", "3.20", "activation",
             "Leaving an active state: first its children, then its exit function, then itself."},
    RuleInfo{Rule::BDeact, "BDeact", "3.21", "activation", "A barrier becomes inactive and forgets its arrivals."},
    RuleInfo{
        Rule::SAct1, "SAct1", "3.22", "activation",
        "Entering an inactive state: it becomes active, its entry function runs, then its first child is entered."},
    RuleInfo{Rule::SAct2, "SAct2", "3.23", "activation", "Entering a state that is active already: nothing happens."},
    RuleInfo{Rule::BAct1, "BAct1", "3.24", "activation", "A barrier that is the first child opens at once."},
    RuleInfo{Rule::BAct2, "BAct2", "3.25", "activation", "The last missing port arrives: the barrier opens."},
    RuleInfo{Rule::BAct3, "BAct3", "3.26", "activation",
             "A port arrives, others are still missing: the barrier waits."},
    RuleInfo{Rule::PTrigger, "PTrigger", "3.27", "micro",
             "A port whose condition is fulfilled takes its state out of play and becomes active."},
    RuleInfo{Rule::PTrans1, "PTrans1", "3.28", "micro", "Active ports of children lead to their destinations."},
    RuleInfo{Rule::PTrans2, "PTrans2", "3.29", "micro", "An open barrier leads to all of its destinations."},
    RuleInfo{Rule::SProp, "SProp", "3.30", "micro",
             "Nothing to do here but actions: the active children take their step."},
    RuleInfo{Rule::Micro, "Micro", "3.31", "micro", "One micro step of the whole model, starting at the root."},
};

constexpr const RuleInfo& info(Rule rule) { return kRules[static_cast<std::size_t>(rule)]; }

constexpr bool rules_stand_in_order() {
  for (std::size_t i = 0; i < kRules.size(); ++i)
    if (static_cast<std::size_t>(kRules[i].rule) != i) return false;
  return true;
}
static_assert(rules_stand_in_order());

/// The refinements that a node of a derivation names (core/SEMANTICS.md); 0 = none.
using Refinement = std::uint8_t;

}  // namespace race::semantics
