// The derivation document of core/SEMANTICS.md section 7 as a text for people: indented, one node of a tree a line.
// Changes of it are read as a line diff.
#pragma once

#include <cstddef>
#include <string>

#include "core/value/value.h"

namespace race::semantics {

/// The transcript of a derivation document, such as derive_texts() gives. For each step its trees, its calls, the
/// active states, and the values that changed since the step before; at the end the status:
///
///     step 1
///       micro 1
///         Micro 3.31 at Root (R13)
///           Cond 4.12 at Root, port done = true requires timer.wait.result
///       call timer.wait(0.5)
///       active Root
///       set Root par.seconds = 0.5
///     ended: done
///
/// A field that is missing is left out. Names that are no identifiers, values and messages are written as JSON, so that
/// none of them breaks a line.
std::string derivation_text(const Value& document);

/// The same in parts, for a run that goes on or is long: documents with steps that follow one another.
class DerivationText {
 public:
  /// `first`: the number of the first step.
  explicit DerivationText(std::size_t first = 1) : next_(first) {}

  /// The transcript of the steps of the next document, without its status.
  std::string steps(const Value& document);
  /// The last line, of the document whose status is that of the run.
  static std::string status(const Value& document);

 private:
  std::size_t next_;
  Value before_;  // the state after the last step; null: not known
};

}  // namespace race::semantics
