// Derivation documents on stdout, for the commands derive, replay and trace.
#pragma once

#include <cstddef>

#include "core/semantics/derivation_text.h"
#include "core/value/value.h"

namespace race::server {

/// Prints `document` as JSON, or as a transcript (core/semantics/derivation_text.h). Returns kExitFindings if the run
/// faulted, else kExitOk.
int print_derivations(const Value& document, bool as_text);

/// The same in parts, of documents whose steps follow one another. As JSON, each step is a line
/// (api/schemas/trace_step.json), and the end another one.
class DerivationPrinter {
 public:
  /// `first`: the number of the first step.
  DerivationPrinter(bool as_text, std::size_t first) : as_text_(as_text), text_(first) {}

  void print_steps(const Value& document);
  /// Of the document whose `status`, `outcome` and `fault` are those of the run. As print_derivations().
  int print_end(const Value& document) const;

 private:
  bool as_text_;
  semantics::DerivationText text_;
};

}  // namespace race::server
