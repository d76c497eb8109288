// LiveEdit: a revision of a document on its way into a core that follows it (core/SEMANTICS.md section 9).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "core/execution/executed_model.h"

namespace race::server {

/// The edit by which a core gets from the model `base` to a revision of its document. Shared between threads: its
/// values are frozen.
struct LiveEdit {
  std::int64_t revision = 0;
  std::shared_ptr<const semantics::Program> base;
  execution::EditEntry entry;
  execution::ExecutedModel model;  // after it
  /// To be called if the core has another model than `base`, when its turn comes or later; any thread, quick: it only
  /// posts.
  std::function<void()> stale;

  bool changes_nothing() const {
    return entry.edit.operations.empty() && entry.services.empty() && entry.origin.empty();
  }
};

}  // namespace race::server
