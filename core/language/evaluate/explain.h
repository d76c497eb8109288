// Explanations of conditions: which atoms (maximal parts without and, or, not) they have, what each read, and which of
// them would have to change for the condition to be fulfilled; and of expressions: what they read, and come to. For
// people: "why does this port not fire?"
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/language/compile/code.h"
#include "core/language/interface/environment.h"
#include "core/language/interface/fault.h"

namespace race::language {

struct Explanation {
  /// A name that an atom read, as written, with what is there now; unknown if nothing is.
  struct Read {
    std::string text;
    Value value;
  };
  struct Atom {
    std::string text;
    SourceRange where;
    Truth value = Truth::unknown;
    std::vector<Read> reads;  // in the order of the text
    /// What it would have to become, if it is decisive.
    bool wanted = false;
  };

  Truth value = Truth::unknown;  // of the whole condition
  std::vector<Atom> atoms;       // in the order of the text, also those that are not evaluated
  /// Numbers of atoms. Of a condition that is not True: each one whose change alone would make it True; if none would,
  /// the smallest set that would by changing `together`. Atoms that read nothing cannot change. Empty if nothing would
  /// (`a and not a`, `1 > 2`), or if it is True.
  std::vector<std::size_t> decisive;
  bool together = false;
};

/// Explains a condition in its present state. Atoms with the same text are one atom.
Explanation explain(const Code& condition, Environment& environment);

/// An expression in its present state.
struct ExplainedValue {
  Value value = Value::unknown();  // unknown if it has none
  std::optional<Fault> fault;      // why it cannot be evaluated
  std::vector<Explanation::Read> reads;
};
ExplainedValue explain_value(const Code& expression, Environment& environment);

}  // namespace race::language
