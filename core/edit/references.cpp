#include "core/edit/references.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "core/edit/builder.h"
#include "core/language/check/names.h"
#include "core/language/syntax/parser.h"

namespace race::edit {
namespace {

using language::Expr;
using language::ExprKind;
using language::Span;

bool is_text(const Expr& e) { return e.kind == ExprKind::constant && e.value.is_string(); }

bool is_own_collection(std::string_view name) { return name == "par" || name == "res" || name == "var"; }

/// Whether `e` is `par`, `res` or `var` as a whole.
bool is_own_collection(const Expr& e) { return e.kind == ExprKind::name && is_own_collection(e.name); }

class Collector {
 public:
  std::vector<Reference> found;

  void block(const language::Block& statements) {
    for (const language::Stmt& s : statements) {
      for (const auto& target : s.targets) expression(*target);
      if (s.value) expression(*s.value);
      for (const auto& test : s.tests)
        if (test) expression(*test);
      for (const language::Block& inner : s.blocks) block(inner);
    }
  }

  void expression(const Expr& e) {
    if (path(e) || entry(e)) return;
    if (e.kind == ExprKind::compare) keys(e);
    language::for_each_part(e, [&](const Expr& part) { expression(part); });
  }

 private:
  /// A chain of attributes that begins with a collection.
  bool path(const Expr& e) {
    const language::Path names = language::path_of(e);
    if (names.names.empty() || !language::is_collection(names.names.front())) return false;
    if (names.service && !is_text(*names.service)) {
      expression(*names.service);
      return true;
    }
    Reference out;
    chain(e, out);
    out.whole = {out.spans.front().begin, out.spans.back().end};
    found.push_back(std::move(out));
    return true;
  }

  void chain(const Expr& e, Reference& out) {
    if (e.kind == ExprKind::attribute) {
      chain(*e.items[0], out);
      add(out, e.name, {e.at.end - static_cast<std::uint32_t>(e.name.size()), e.at.end}, false);
    } else if (e.kind == ExprKind::index) {
      chain(*e.items[0], out);
      add(out, e.items[1]->value.as_string(), e.items[1]->at, true);
    } else {
      add(out, e.name, e.at, false);
    }
  }

  /// `par["x"]` and `par.get("x", ...)`; other methods of a collection read all of it.
  bool entry(const Expr& e) {
    if (e.kind == ExprKind::index && is_own_collection(*e.items[0]) && is_text(*e.items[1])) {
      keyed(*e.items[0], *e.items[1]);
      return true;
    }
    if (e.kind != ExprKind::call || e.items[0]->kind != ExprKind::attribute) return false;
    const Expr& method = *e.items[0];
    if (!is_own_collection(*method.items[0])) return false;
    const bool has_key = method.name == "get" && e.items.size() > 1 && is_text(*e.items[1]);
    has_key ? keyed(*method.items[0], *e.items[1]) : static_cast<void>(path(*method.items[0]));
    for (std::size_t i = has_key ? 2 : 1; i < e.items.size(); ++i) expression(*e.items[i]);
    return true;
  }

  /// `"x" in par`
  void keys(const Expr& e) {
    for (std::size_t i = 0; i + 1 < e.items.size() && i < e.operators.size(); ++i) {
      const bool is_in =
          e.operators[i] == language::BinaryOperator::in || e.operators[i] == language::BinaryOperator::not_in;
      if (is_in && e.items[i] && e.items[i + 1] && is_text(*e.items[i]) && is_own_collection(*e.items[i + 1]))
        keyed(*e.items[i + 1], *e.items[i]);
    }
  }

  void keyed(const Expr& collection, const Expr& key) {
    Reference out;
    add(out, collection.name, collection.at, false);
    add(out, key.value.as_string(), key.at, true);
    out.whole = {std::min(collection.at.begin, key.at.begin), std::max(collection.at.end, key.at.end)};
    found.push_back(std::move(out));
  }

  static void add(Reference& out, std::string_view name, Span at, bool is_literal) {
    out.names.emplace_back(name);
    out.spans.push_back(at);
    out.is_literal.push_back(is_literal);
  }
};

/// The literal of a text, quoted as the one that stood there.
std::string literal(std::string_view old, std::string_view text) {
  const auto quote = old.find_first_of("'\"");
  const char mark = quote == std::string_view::npos ? '\'' : old[quote];
  return mark + std::string(text) + mark;
}

void collect_values(const Expr& e, std::string_view text, std::string_view from, std::string_view to,
                    std::vector<Replacement>& out) {
  const auto inner = [&](std::size_t first, std::size_t step, const Expr& of) {
    for (std::size_t i = first; i < of.items.size(); i += step) collect_values(*of.items[i], text, from, to, out);
  };
  if (is_text(e) && e.value.as_string() == from) out.push_back({e.at, literal(slice(text, e.at), to)});
  if (e.kind == ExprKind::conditional) inner(1, 1, e);
  if (e.kind == ExprKind::logical) inner(0, 1, e);
  if (e.kind == ExprKind::index && e.items[0]->kind == ExprKind::list) inner(0, 1, *e.items[0]);
  if (e.kind == ExprKind::index && e.items[0]->kind == ExprKind::dict) inner(1, 2, *e.items[0]);
}

void add_text(std::vector<CodeText>& out, std::string_view id, std::string_view field,
              const std::optional<std::string>& text, language::CodeKind kind) {
  if (text) out.push_back({std::string(id), std::string(field), *text, kind});
}

}  // namespace

bool Reference::begins_with(const std::vector<std::string>& path) const {
  return names.size() >= path.size() && std::equal(path.begin(), path.end(), names.begin());
}

std::vector<CodeText> texts_in_scope(const Tree& tree, std::string_view id) {
  using language::CodeKind;
  std::vector<CodeText> out;
  const rcm::State& state = *state_of(tree, id);
  add_text(out, id, "entry", state.entry, CodeKind::function);
  add_text(out, id, "exit", state.exit, CodeKind::function);
  if (state.oracle && state.oracle->kind == rcm::Oracle::Kind::expr)
    add_text(out, id, "oracle", state.oracle->text, CodeKind::expression);
  if (state.oracle && state.oracle->kind == rcm::Oracle::Kind::external)
    add_text(out, id, "oracle", state.oracle->text, CodeKind::function);
  for (const std::string& at : tree.list(id, ListName::actions)) {
    const auto& action = std::get<rcm::Action>(tree.find(at)->content);
    add_text(out, at, "when", action.when, CodeKind::condition);
    add_text(out, at, "do", action.code, CodeKind::function);
  }
  for (const std::string& at : tree.list(id, ListName::ports)) {
    const auto& port = std::get<rcm::Port>(tree.find(at)->content);
    add_text(out, at, "when", port.when, CodeKind::condition);
    add_text(out, at, "after", port.after, CodeKind::expression);
  }
  for (const std::string& child : tree.list(id, ListName::children))
    std::ranges::move(from_texts(tree, child), std::back_inserter(out));
  return out;
}

std::vector<CodeText> from_texts(const Tree& tree, std::string_view state) {
  std::vector<CodeText> out;
  for (const std::string& at : tree.list(state, ListName::parameters))
    add_text(out, at, "from", std::get<rcm::Parameter>(tree.find(at)->content).from, language::CodeKind::expression);
  return out;
}

std::vector<TakenOver> taken_over_texts(const Tree& tree, std::string_view state) {
  std::vector<TakenOver> out;
  for (const std::string& child : tree.list(state, ListName::children)) {
    std::set<std::string, std::less<>> given;  // by the links on the way
    std::string at = child;
    for (std::size_t links = 0; links <= tree.size() && state_of(tree, at); ++links) {
      for (const CodeText& text : from_texts(tree, at)) {
        if (at != child && !given.contains(name_of(tree, text.id))) out.push_back({child, text});
      }
      for (const std::string& id : tree.list(at, ListName::parameters)) {
        const auto& parameter = std::get<rcm::Parameter>(tree.find(id)->content);
        if (parameter.value || parameter.from) given.insert(parameter.name);
      }
      const auto& link = state_of(tree, at)->link;
      if (!link) break;
      at = find_by_name(tree, "", ListName::library, *link);
    }
  }
  return out;
}

References references_in(const CodeText& text) {
  const language::Parsed parsed = language::parse(text.text, text.kind);
  if (!parsed.problems.empty()) return {{}, false};
  Collector collector;
  if (parsed.tree.expression) collector.expression(*parsed.tree.expression);
  collector.block(parsed.tree.statements);
  return {std::move(collector.found), true};
}

Value field_with(const Tree& tree, const CodeText& text, std::string changed) {
  if (text.field != "oracle") return Value(std::move(changed));
  const bool is_expr = state_of(tree, text.id)->oracle->kind == rcm::Oracle::Kind::expr;
  return Dict{{"kind", is_expr ? "expr" : "external"}, {is_expr ? "expr" : "call", std::move(changed)}};
}

std::string replaced(std::string_view text, std::vector<Replacement> replacements) {
  std::ranges::sort(replacements, {}, [](const Replacement& r) { return r.at.begin; });
  std::string out;
  std::size_t at = 0;
  for (const Replacement& replacement : replacements) {
    out += text.substr(at, replacement.at.begin - at);
    out += replacement.text;
    at = replacement.at.end;
  }
  return out += text.substr(at);
}

Replacement with_name(std::string_view text, const Reference& reference, std::size_t i, std::string_view name) {
  const Span at = reference.spans[i];
  return {at, reference.is_literal[i] ? literal(slice(text, at), name) : std::string(name)};
}

std::vector<Replacement> renamed_values(std::string_view expression, std::string_view from, std::string_view to) {
  const language::Parsed parsed = language::parse(expression, language::CodeKind::expression);
  std::vector<Replacement> out;
  if (parsed.problems.empty()) collect_values(*parsed.tree.expression, expression, from, to, out);
  return out;
}

}  // namespace race::edit
