// The header of a journal with small budgets: with larger ones an input only takes longer.
#pragma once

#include <algorithm>

#include "core/execution/journal.h"

namespace race::fuzz {

inline execution::JournalHeader bounded(execution::JournalHeader header) {
  semantics::Budgets& budgets = header.budgets;
  budgets.evaluation.steps = std::min<std::uint64_t>(budgets.evaluation.steps, 2'000);
  budgets.evaluation.value_units = std::min<std::uint64_t>(budgets.evaluation.value_units, 10'000);
  budgets.micro_steps = std::min<std::uint32_t>(budgets.micro_steps, 200);
  return header;
}

}  // namespace race::fuzz
