// References: where a code text names what belongs to its state, its children and services. Positions are those of the
// parser of core/language. Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/edit/tree.h"
#include "core/language/interface/symbols.h"
#include "core/language/syntax/source.h"
#include "core/value/expected.h"

namespace race::edit {

/// One path in a text, as long as it goes: `chi.A.res.x.y`, `par.x`, `par["x"]`, `var.get("x")`, `"x" in res`,
/// `svc["S"].op`. It begins with par, res, var, port, chi or svc.
struct Reference {
  std::vector<std::string> names;     // one alone: a collection as a whole, such as `par`
  std::vector<language::Span> spans;  // of each name; of one that stands as a text, of the literal
  std::vector<bool> is_literal;       // of each name
  language::Span whole;               // from the first name to the last
  /// Whether the names begin with those of `path`.
  bool begins_with(const std::vector<std::string>& path) const;
};

/// A text of a document.
struct CodeText {
  std::string id, field;  // the element that has it: entry, exit, when, after, do, from, oracle
  std::string text;
  language::CodeKind kind = language::CodeKind::function;
};

/// The texts whose scope (core/SEMANTICS.md, section 2) is that of a state: its own, those of its actions and ports,
/// and the `from` of its children's parameters.
std::vector<CodeText> texts_in_scope(const Tree& tree, std::string_view state);

/// The `from` of a state's own parameters. Their scope is that of its parent; for a state of the library, that of each
/// state that links it.
std::vector<CodeText> from_texts(const Tree& tree, std::string_view state);

/// A `from` that a link has from the library, because it gives the parameter no expression of its own.
struct TakenOver {
  std::string link;  // a child of the scope
  CodeText text;     // shared with whatever else links its state: it cannot be changed for this scope
};
/// Those whose scope is that of a state (core/SEMANTICS.md, section 8), besides texts_in_scope().
std::vector<TakenOver> taken_over_texts(const Tree& tree, std::string_view state);

/// The references in a text, in order; and whether it could be parsed.
struct References {
  std::vector<Reference> found;
  bool is_parsed = true;
};
References references_in(const CodeText& text);

/// The value of the field that holds `text`, with another text.
Value field_with(const Tree& tree, const CodeText& text, std::string changed);

/// A piece of a text and what comes in its place.
struct Replacement {
  language::Span at;
  std::string text;
};
std::string replaced(std::string_view text, std::vector<Replacement> replacements);

/// The name `i` of a reference by another name, in the way it stands there.
Replacement with_name(std::string_view text, const Reference& reference, std::size_t i, std::string_view name);

/// The literals in an expression whose text may be its value (an oracle `expr`): itself, the branches of conditions,
/// the parts of `and` and `or`, the items of a list or dict that is indexed.
std::vector<Replacement> renamed_values(std::string_view expression, std::string_view from, std::string_view to);

}  // namespace race::edit
