#include "core/rcm/code_checks.h"

#include <algorithm>
#include <utility>

#include "core/language/check/checker.h"

namespace race::rcm {
namespace {

// Names may be any texts if they are not valid, so each has its length before it.
constexpr char kEndOfLength = ':', kEndOfNames = ';', kBarrier = '|';

void add_name(const std::string& name, std::string& out) {
  out += std::to_string(name.size());
  out += kEndOfLength;
  out += name;
}

template <typename Names>
void add_names(const Names& names, std::string& out) {
  for (const auto& [name, number] : names) add_name(name, out);
  out += kEndOfNames;
}

/// A text that two scopes have in common only if code means the same in both.
std::string key_of(const language::Symbols& symbols) {
  std::string out;
  add_names(symbols.parameters, out);
  add_names(symbols.results, out);
  add_names(symbols.variables, out);
  add_names(symbols.ports, out);
  for (const auto& [name, child] : symbols.children) {
    add_name(name, out);
    if (child.barrier) out += kBarrier;
    add_names(child.parameters, out);
    add_names(child.results, out);
    add_names(child.ports, out);
  }
  return out;
}

}  // namespace

CodeChecks::Scope& CodeChecks::scope(const language::Symbols& symbols) { return scopes_[key_of(symbols)]; }

const std::vector<Error>& CodeChecks::check(std::string_view text, language::CodeKind kind,
                                            const language::Symbols& symbols, Scope& scope) {
  Entries& entries = scope[static_cast<std::size_t>(kind)];
  auto found = entries.lower_bound(text);
  if (found == entries.end() || found->first != text) {
    ++reads_;
    found = entries.emplace_hint(found, text, Entry{language::check(text, kind, symbols), revision_});
  }
  found->second.revision = revision_;
  return found->second.errors;
}

void CodeChecks::end() {
  for (auto& [names, scope] : scopes_) {
    for (Entries& entries : scope)
      std::erase_if(entries, [&](const auto& entry) { return entry.second.revision != revision_; });
  }
  std::erase_if(scopes_, [](const auto& scope) {
    return std::ranges::all_of(scope.second, [](const Entries& entries) { return entries.empty(); });
  });
}

std::size_t CodeChecks::size() const {
  std::size_t out = 0;
  for (const auto& [names, scope] : scopes_) {
    for (const Entries& entries : scope) out += entries.size();
  }
  return out;
}

}  // namespace race::rcm
