#include "core/semantics/evaluation_record.h"

#include <algorithm>

namespace race::semantics {

void EvaluationRecord::require(RequiredDatum datum) {
  if (std::ranges::find(required, datum) == required.end()) required.push_back(std::move(datum));
}

}  // namespace race::semantics
