// CodeChecks: what the checks of code found in a document, so that the check of its next revision reads the texts again
// that an edit concerns, and no others. A check depends on the text, its kind and the names of its scope alone; an
// entry is found by all three, so it is never out of date. Holds what the last document had: no more than its code.
//
// A value, on one thread. Owned by whoever checks revisions of a document one after the other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/language/interface/symbols.h"
#include "core/value/expected.h"

namespace race::rcm {

class CodeChecks {
  struct Entry {
    std::vector<Error> errors;
    std::uint64_t revision;  // the last document that has the text
  };
  using Entries = std::map<std::string, Entry, std::less<>>;

 public:
  /// The texts with the same names in scope, by CodeKind.
  using Scope = std::array<Entries, 3>;

  /// A check of a document begins.
  void begin() { ++revision_; }
  /// It is over: what the document did not ask for is dropped.
  void end();

  /// The scope of code with these names; good until end().
  Scope& scope(const language::Symbols& symbols);
  /// language::check of a text in a scope with these names. Good until end().
  const std::vector<Error>& check(std::string_view text, language::CodeKind kind, const language::Symbols& symbols,
                                  Scope& scope);

  /// How many texts were read since it was made, for tests: the others were known.
  std::size_t reads() const { return reads_; }
  /// How many texts it knows.
  std::size_t size() const;

 private:
  std::map<std::string, Scope, std::less<>> scopes_;  // by their names; ordered maps: the texts are a stranger's
  std::uint64_t revision_ = 0;
  std::size_t reads_ = 0;
};

}  // namespace race::rcm
